"""A whole term, kept and brought back."""
