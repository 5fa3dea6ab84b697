"""Virtual students: what they do is known, so that it can be set against what the grader says."""
