"""A module for each revision of the tables. A revision that was published never changes."""
