"""Judging: answers against the reference and against the student's own numbers."""
