"""What needs no student: variants made, audited, solved and drawn."""
