"""Course assignments: issue variants, check answers, grade and report."""

__version__ = "0.1.0"
