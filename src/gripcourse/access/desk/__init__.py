"""The desk of a course: personal links, what came in by them, what was published, who signed in."""
