"""What the works of a cohort say about the assignment: hard, telling, reliable, equally hard."""
