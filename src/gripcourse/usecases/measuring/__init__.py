"""What the grader is worth: students who do not exist, and tolerances derived from honest ones."""
