"""The formula reference: pages that are generated from the declarations of a course alone."""
