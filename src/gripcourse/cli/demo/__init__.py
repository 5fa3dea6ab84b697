"""A whole small course played through, with scripted students."""
