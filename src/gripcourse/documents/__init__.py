"""Everything that is printed: one module and one template for each kind."""
