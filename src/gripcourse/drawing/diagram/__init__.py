"""The kinematic diagram of a variant."""
