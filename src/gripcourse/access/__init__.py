"""Who comes in by a server: by a personal link to the desk, or from a learning platform."""
