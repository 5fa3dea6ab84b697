"""A course as an instructor writes it: declarations, catalogues and policy, loaded and checked."""
