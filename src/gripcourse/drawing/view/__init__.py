"""The general view of a variant."""
