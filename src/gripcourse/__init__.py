"""Course assignments for robot gripper design: issue variants, check answers, grade and report."""

__version__ = "0.1.0"
