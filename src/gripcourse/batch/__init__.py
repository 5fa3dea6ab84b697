"""Grading many files."""
