"""Virtual students: works whose every answer is known to be right, wrong, and why."""
