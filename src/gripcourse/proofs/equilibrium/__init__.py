"""Equilibrium of free bodies: a proof of forces that knows nothing of the formulas for them."""
