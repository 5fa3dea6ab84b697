"""What a server does for students and instructors: the desk, opened, and all that happens at it."""
