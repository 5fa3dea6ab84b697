"""Words, numbers, units and amounts, as people read and write them."""
