"""What an answer may differ by and what it can earn: bands and points, for all who count them."""
