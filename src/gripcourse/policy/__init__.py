"""What a head of course decides: points, tolerances, credits, rubrics."""
