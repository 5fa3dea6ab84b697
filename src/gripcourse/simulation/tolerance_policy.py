"""Writing tolerances into a policy file: one line each, everything else stays as it was written."""

import re
from collections.abc import Mapping
from pathlib import Path

import tomli

from gripcourse.course.quantity import Tolerance
from gripcourse.errors import Problem, UsageError
from gripcourse.machine.files import write_text
from gripcourse.text.words import message

_TABLE = "quantity_tolerance"
_HEADER = re.compile(r"\s*\[")
_OURS = re.compile(rf"\s*\[\s*{_TABLE}\s*\]\s*(?:#.*)?")
_COMMENT = "# differs from the default; `gripcourse tolerance audit` proposes"


def apply_tolerances(path: Path, file: str, tolerances: Mapping[str, Tolerance]) -> None:
    """Write the tolerances of quantities into a policy, in one step.

    Args:
        path: of the policy.
        file: its name for messages.
        tolerances: by quantity; of the others nothing changes.

    Raises:
        UsageError: the file is written in a way that cannot be changed line by line.
        OSError: the file cannot be read or written.
    """
    before = path.read_text(encoding="utf-8-sig")
    after = with_tolerances(before, tolerances)
    if not _is_as_meant(before, after, tolerances):
        what = message("The tolerances of single quantities cannot be changed here line by line.")
        remedy = message(
            "Write each as one line of the table {table}: name = {{ relative = 0.01 }}.",
            table=f"[{_TABLE}]",
        )
        raise UsageError([Problem(file, _TABLE, what, remedy)])
    if after != before:
        write_text(path, after)


def with_tolerances(text: str, tolerances: Mapping[str, Tolerance]) -> str:
    """Return the text of a policy with the tolerances of some quantities changed or added."""
    lines = text.splitlines()
    start = next((at for at, line in enumerate(lines) if _OURS.fullmatch(line)), None)
    if not tolerances:
        return text
    if start is None:
        start = len(lines) + 1
        lines += ["", f"[{_TABLE}]".ljust(26) + _COMMENT]
    for name in sorted(tolerances):
        _write(lines, start, name, tolerances[name])
    return "\n".join(lines) + "\n"


def _write(lines: list[str], start: int, name: str, tolerance: Tolerance) -> None:
    """Change the line of a quantity in the table that begins at `start`, or add one to its end."""
    own = re.compile(rf"(\s*{re.escape(name)}\s*=\s*)\{{[^}}]*\}}(.*)")
    end = last = start + 1
    while end < len(lines) and not _HEADER.match(lines[end]):
        found = own.fullmatch(lines[end])
        if found is not None:
            lines[end] = f"{found[1]}{_inline(tolerance)}{found[2]}"
            return
        end += 1
        last = end if lines[end - 1].strip() else last
    lines.insert(last, f"{name} = {_inline(tolerance)}")


def _inline(tolerance: Tolerance) -> str:
    absolute = f", absolute = {tolerance.absolute:g}" if tolerance.absolute else ""
    return f"{{ relative = {tolerance.relative:g}{absolute} }}"


def _is_as_meant(before: str, after: str, tolerances: Mapping[str, Tolerance]) -> bool:
    """Tell whether a changed text says what it should, and everything else as before."""
    try:
        new = tomli.loads(after)
    except tomli.TOMLDecodeError:
        return False
    old = tomli.loads(before)
    wanted = {name: _written(one) for name, one in tolerances.items()}
    meant = {**old.pop(_TABLE, {}), **wanted}
    return bool(new.pop(_TABLE, {}) == meant and new == old)


def _written(tolerance: Tolerance) -> dict[str, float]:
    absolute = {"absolute": tolerance.absolute} if tolerance.absolute else {}
    return {"relative": tolerance.relative, **absolute}
