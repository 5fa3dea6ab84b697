"""What students get: issued, corrected, printed, and traced back to who got it."""
