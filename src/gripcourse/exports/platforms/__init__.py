"""Files of learning platforms: tables of grades that they read, and what goes with them."""
