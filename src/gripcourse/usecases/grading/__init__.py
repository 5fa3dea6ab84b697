"""A batch of works graded: files found, judged, reported, and left where nothing changed."""
