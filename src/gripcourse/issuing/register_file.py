"""A register as one JSON file: what earlier programs kept, and what virtual cohorts carry along.

An entry keeps the numbers themselves, so that a later change of the variant table changes nobody's
assignment.
"""

import json
import math
from datetime import date
from pathlib import Path

from gripcourse.errors import Problem, RegisterError
from gripcourse.issuing.register import Register
from gripcourse.machine.enclosed import is_file_name
from gripcourse.machine.files import write_text
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued, Student, Variant

_FORMAT = 1


def old_register_path(root: Path) -> Path:
    """Return where a course kept its register before it stood in the database."""
    return root / "private" / "register.json"


def read_register_file(path: Path, course_id: str) -> Register:
    """Read the register; where there is none yet, an empty one.

    Args:
        path: of the file.
        course_id: of the course that asks.

    Raises:
        RegisterError: the file is damaged, of another course, or of a later version.
    """
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return Register(course_id, ())
    except (UnicodeDecodeError, json.JSONDecodeError) as fault:
        raise _failure(path, "", message("The register is damaged: {fault}.", fault=str(fault)),
                       _RESTORE) from fault  # fmt: skip
    if not isinstance(content, dict) or not isinstance(content.get("issued"), list):
        raise _failure(path, "", message("The file is no register."), _RESTORE)
    if content.get("format") != _FORMAT:
        raise _failure(
            path,
            "format",
            message("The register has the format {found}, this program knows {known}.",
                    found=str(content.get("format")), known=_FORMAT),
            message("Use the version of the program that wrote it, or a later one."),
        )  # fmt: skip
    if content.get("course") != course_id:
        raise _failure(
            path,
            "course",
            message("The register is of the course '{found}', not of '{course}'.",
                    found=str(content.get("course")), course=course_id),
            message("Name the right course, or take its id back."),
        )  # fmt: skip
    return Register(course_id, _entries(path, content["issued"]))


def write_register_file(path: Path, register: Register) -> None:
    """Write the register in one step; only its owner can read it, for it names students."""
    content = {
        "format": _FORMAT,
        "course": register.course_id,
        "issued": [_written(entry) for entry in register.entries],
    }
    text = json.dumps(content, ensure_ascii=False, indent=1, allow_nan=False)
    write_text(path, text + "\n", private=True)


def _entries(path: Path, written: list[object]) -> tuple[Issued, ...]:
    problems: list[Problem] = []
    entries: dict[str, Issued] = {}
    for number, one in enumerate(written, start=1):
        key = message("entry {number}", number=number)
        try:
            entry = _entry(one)
        except (KeyError, TypeError, ValueError) as fault:
            what = message("The entry is damaged: {fault}.", fault=repr(fault))
            problems.append(Problem(str(path), key, what, _RESTORE))
            continue
        if entry.student.id in entries:
            what = message("The student '{student}' has two entries.", student=entry.student.id)
            problems.append(Problem(str(path), key, what, _RESTORE))
        entries[entry.student.id] = entry
    if problems:
        raise RegisterError(problems)
    return tuple(entries.values())


def _written(entry: Issued) -> dict[str, object]:
    student, variant = entry.student, entry.variant
    return {
        "student": {
            "id": student.id,
            "name": student.name,
            "group": student.group,
            "email": student.email,
            "language": student.language,
            "variant": student.variant,
        },
        "variant": variant.id,
        "scheme": variant.scheme,
        "options": dict(variant.options),
        "given": dict(variant.given),
        "issued_on": entry.issued_on.isoformat(),
        "deadline": entry.deadline.isoformat() if entry.deadline else None,
        "signature": entry.signature,
    }


def _entry(written: object) -> Issued:
    """Read an entry.

    Raises:
        KeyError, TypeError, ValueError: it is not as `_written` writes it.
    """
    entry = _mapping(written)
    student = _mapping(entry["student"])
    deadline = entry["deadline"]
    for name in (student["id"], entry["variant"]):
        if not is_file_name(_text(name)):
            raise ValueError(f"{name!r} cannot name a file")
    return Issued(
        student=Student(
            id=_text(student["id"]),
            name=_text(student["name"]),
            group=_text(student["group"]),
            email=_text(student["email"]),
            language=_text(student["language"]),
            variant=_text(student["variant"]),
        ),
        variant=Variant(
            id=_text(entry["variant"]),
            scheme=_text(entry["scheme"]),
            options={id_: _text(one) for id_, one in _mapping(entry["options"]).items()},
            given={id_: _number(one) for id_, one in _mapping(entry["given"]).items()},
        ),
        issued_on=date.fromisoformat(_text(entry["issued_on"])),
        deadline=None if deadline is None else date.fromisoformat(_text(deadline)),
        signature=_text(entry["signature"]),
    )


def _mapping(written: object) -> dict[str, object]:
    if not isinstance(written, dict):
        raise TypeError(f"{written!r} is not a table")
    return written


def _text(written: object) -> str:
    if not isinstance(written, str):
        raise TypeError(f"{written!r} is not a text")
    return written


def _number(written: object) -> float:
    if not isinstance(written, int | float) or isinstance(written, bool):
        raise TypeError(f"{written!r} is not a number")
    if not math.isfinite(written):
        raise ValueError(f"{written!r} is not a finite number")
    return float(written)


_RESTORE = message("Restore the register from a backup; do not edit it by hand.")


def _failure(path: Path, key: str, what: Message, remedy: Message) -> RegisterError:
    return RegisterError([Problem(str(path), key, what, remedy)])
