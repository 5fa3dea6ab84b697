"""Proofs of a course: what its declarations compute, checked by something that is not they."""
