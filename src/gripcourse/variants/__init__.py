"""Variant tables: drawn from a space or imported, stored as values."""
