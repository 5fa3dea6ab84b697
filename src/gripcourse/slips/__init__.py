"""Wrong methods: what a student may have computed instead."""
