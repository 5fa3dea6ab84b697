"""Whose answers are these? Evidence with its odds, for an instructor; never a verdict."""
