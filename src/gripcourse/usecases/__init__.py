"""What can be done with a course, each by one call; who calls is not known here."""
