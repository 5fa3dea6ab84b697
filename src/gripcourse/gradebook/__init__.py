"""The gradebook: every attempt and every mark of a person, kept for good."""
