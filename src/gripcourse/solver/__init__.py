"""The reference solution: the order of a scheme's quantities and their values."""
