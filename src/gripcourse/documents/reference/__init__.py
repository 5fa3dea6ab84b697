"""The formula reference, made from the declarations."""
