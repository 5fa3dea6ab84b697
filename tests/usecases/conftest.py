"""A course of one's own whose assignments can be issued."""

from support.classroom import classroom, issued
