"""An instructor in a process of their own, who issues one variant after the other."""

import sys
from datetime import date
from pathlib import Path

from gripcourse.issuing.allotment import Terms, extend
from gripcourse.issuing.store import extend_register
from gripcourse.variants.model import Student, Variant


def issue(root: Path, group: str, times: int) -> None:
    """Issue to so many rosters of two students from the same table."""
    variants = [Variant(f"{one:03}", "press", {}, {"mass": float(one)}) for one in range(1, 99)]
    terms = Terms(bytes(range(32)), date(2026, 9, 1), None)
    for number in range(times):
        names = (f"{group}{number}a", f"{group}{number}b")
        students = [Student(name, name, group, "", "", "") for name in names]
        extend_register(
            root, "small", lambda register, new=students: extend(register, new, variants, terms)
        )


if __name__ == "__main__":
    issue(Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]))
