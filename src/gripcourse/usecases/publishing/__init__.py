"""Results on their way out: published, exported, taken home and sent to platforms."""
