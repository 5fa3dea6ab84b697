"""A second kind of virtual students: other mistakes than the grader knows, another arithmetic."""
