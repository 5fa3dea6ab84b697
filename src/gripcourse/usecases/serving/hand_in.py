"""Handing in: bytes are safe on the disk and in the database before there is a receipt."""

import hashlib
import hmac
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path, PurePath
from typing import Final

from gripcourse.access.desk.model import Allowance, HandIn
from gripcourse.errors import Problem, UsageError
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.files import make_private_folder, write_bytes
from gripcourse.machine.spreadsheet.by_content import is_workbook
from gripcourse.text.shown import shown
from gripcourse.text.words import Message, message
from gripcourse.usecases.serving.desk import DeskBooks, DeskContext
from gripcourse.usecases.serving.taken import hand_ins_by_person
from gripcourse.variants.model import Issued

_MOST: Final = 200_000_000
"""Bytes that one student may keep here: a term of large workbooks many times over."""
_MOST_FILES: Final = 200
"""Files of one student: where all that may count are graded, a flood of them stops a batch."""
_NAMELESS: Final = "file"
_LONGEST_NAME: Final = 120
_LONGEST_SUFFIX: Final = 10
_MAY_HOLD: Final = (b"PK", b"\xd0\xcf\x11\xe0", b"Rar!", b"7z\xbc\xaf", b"\x1f\x8b")
"""How workbooks and what may have one in it begin: `.xlsx`, `.ods`, `.docx`, `.xls`, archives."""
_PURPOSE: Final = b"gripcourse receipt 1\n"


@dataclass(frozen=True, slots=True)
class Receipt:
    """What a student gets for a file.

    Attributes:
        hand_in: number, hash, size, name and time.
        late: whether the deadline was over; hours of grace do not change that.
        is_workbook: whether it is one by its content, whatever it is called; whether it can be
            used is told by a check, and by grading.
        code: HMAC over all of it with the course's key; who has the key can verify it.
    """

    hand_in: HandIn
    late: bool
    is_workbook: bool
    code: str


def hand_in(
    context: DeskContext,
    issued: Issued,
    file: NamedBytes,
    now: datetime,
    allowed: Allowance | None = None,
) -> Receipt:
    """Keep a file that a student hands in, whatever is in it.

    The same file once more right after is the same hand-in: two clicks make one.

    Args:
        context: of the course.
        issued: to whom it was issued.
        file: as it was sent.
        now: with its zone.
        allowed: how often it may be done; None for any number.

    Raises:
        TooOftenError: it was done as often as is allowed; nothing was recorded.
        UsageError: the file is empty, or the student has handed in too much.
        OSError: the disk is full, or cannot be written; nothing was recorded.
        GradebookError: the database failed; nothing was recorded.
    """
    student = issued.student.id
    if not file.data:
        raise _refusal(
            message("The file is empty."), message("Choose your workbook once more, saved.")
        )
    known = context.desk.hand_ins(student)
    used = sum(one.size for one in known)
    if used + len(file.data) > _MOST or len(known) >= _MOST_FILES:
        raise _refusal(
            message("There is no more room for your files."), message("Ask your instructor.")
        )
    digest = hashlib.sha256(file.data).hexdigest()
    path = kept_path(context, digest)
    if not path.is_file():
        make_private_folder(path.parent)
        write_bytes(path, file.data, private=True)
        _make_durable(path.parent)
    name = _kept_name(file.name)
    kept = context.desk.add_hand_in(student, digest, len(file.data), name, now, allowed)
    return receipt_of(context, issued, kept)


def receipt_of(context: DeskContext, issued: Issued, kept: HandIn) -> Receipt:
    """Return the receipt of a file, the same whenever it is asked for."""
    signed = "\n".join(
        (
            *(context.course.id, kept.student, str(kept.number), kept.digest, str(kept.size)),
            kept.at.isoformat(),
        )
    )
    made = hmac.new(context.key, _PURPOSE + signed.encode(), hashlib.sha256)
    return Receipt(
        hand_in=kept,
        late=is_late(context, issued, kept.at),
        is_workbook=is_workbook(kept_path(context, kept.digest)),
        code=made.hexdigest()[:32],
    )


def is_late(context: DeskContext, issued: Issued, at: datetime) -> bool:
    """Tell whether a student's deadline was over at a time; its last second counts to its end."""
    deadline = context.deadlines.of(issued)
    return deadline is not None and at.replace(microsecond=0) > deadline


def kept_path(context: DeskBooks, digest: str) -> Path:
    """Return where bytes are kept: under what they are, never under what somebody calls them."""
    return context.private / "handed_in" / digest


def latest(context: DeskBooks, hand_ins: Mapping[str, Iterable[HandIn]]) -> dict[str, HandIn]:
    """Return the last workbook of each student; drawings are looked at by persons.

    A photograph, a table of text or a drawing of another program takes no workbook's place: of
    such a file only somebody's last is returned who has handed in nothing else.

    Args:
        context: of the course.
        hand_ins: by the id of the person, in the order in which they were taken.
    """
    found: dict[str, HandIn] = {}
    for student, files in hand_ins.items():
        for one in (one for one in files if not one.is_drawing):
            before = found.get(student)
            if (
                before is None
                or _may_hold_answers(context, one)
                or not _may_hold_answers(context, before)
            ):
                found[student] = one
    return found


def _may_hold_answers(context: DeskBooks, one: HandIn) -> bool:
    """Tell by its first bytes whether a file may be a workbook, or an archive or text with one."""
    try:
        with kept_path(context, one.digest).open("rb") as stream:
            return stream.read(max(map(len, _MAY_HOLD))).startswith(_MAY_HOLD)
    except FileNotFoundError:  # who reads it says so
        return True


def may_count(
    context: DeskBooks, hand_ins: Mapping[str, Iterable[HandIn]]
) -> dict[str, tuple[HandIn, ...]]:
    """Return the workbooks of each student that are graded, in the order of handing in.

    The last one; where the policy counts the first, the best or only so many, all that may hold
    answers, each once: the gradebook tells which of them counts, and must know them.

    Args:
        context: of the course.
        hand_ins: by the id of the person, in the order in which they were taken.

    Raises:
        CourseError: the policy cannot be read.
        OSError: a file cannot be read.
    """
    last, rule = latest(context, hand_ins), context.attempt_rule()
    found: dict[str, tuple[HandIn, ...]] = {student: (one,) for student, one in last.items()}
    if rule is None or not rule.asks_for_all:
        return found
    works: dict[str, dict[str, HandIn]] = {}
    for student, files in hand_ins.items():
        for one in files:
            if not one.is_drawing and _may_hold_answers(context, one):
                works.setdefault(student, {}).setdefault(one.digest, one)
    return found | {student: tuple(of.values()) for student, of in works.items()}


def name_in_folder(one: HandIn, student: str) -> str:
    """Return what the last workbook of a student is called for grading: like its student."""
    suffix = PurePath(one.name).suffix.lower()
    return f"{student}{suffix if suffix.isascii() else ''}"


@dataclass(frozen=True, slots=True)
class CollectedFile:
    """A file that was handed in, and the id that stands for who did."""

    hand_in: HandIn
    student: str


def collect_hand_ins(context: DeskBooks, out: Path) -> Mapping[Path, CollectedFile]:
    """Write the workbooks that may count into a folder, for grading.

    One of a student is called like the student; several stand in a folder that is, numbered in the
    order in which they were taken, as their receipts are.

    Returns:
        What was handed in, by the file that was written.

    Raises:
        CourseError: the policy cannot be read.
        OSError: a file cannot be read or written.
    """
    make_private_folder(out)
    written: dict[Path, CollectedFile] = {}
    hand_ins = hand_ins_by_person(context.desk, context.joins())
    for student, works in may_count(context, hand_ins).items():
        joined = any(one.student != student for one in works)
        for place, one in enumerate(works, start=1):
            name = name_in_folder(one, student)
            path = out / name
            if len(works) > 1:
                make_private_folder(out / student)
                # Receipts under two ids have the same numbers.
                receipt = f"{place:03}-{one.student}-{one.number}" if joined else f"{one.number:03}"
                path = out / student / f"receipt-{receipt}{PurePath(name).suffix}"
            write_bytes(path, kept_path(context, one.digest).read_bytes(), private=True)
            # Lateness is counted from when it was handed in, not from when it was collected.
            os.utime(path, (one.at.timestamp(),) * 2)
            written[path] = CollectedFile(one, student)
    return written


def _kept_name(name: str) -> str:
    """Return what a file is called: its last part, shortened where it is long.

    The suffix stays: without it a drawing would pass for the workbook, and count as the last one.
    """
    last = shown(PurePath(name.replace("\\", "/")).name)
    suffix = PurePath(last).suffix
    if len(suffix) > _LONGEST_SUFFIX:
        suffix = ""
    short = last.removesuffix(suffix)[: _LONGEST_NAME - len(suffix)] + suffix
    return short if short.strip(". ") else _NAMELESS


def _make_durable(folder: Path) -> None:
    """Let the name of a new file survive a loss of power too."""
    if os.name != "posix":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _refusal(what: Message, remedy: Message) -> UsageError:
    return UsageError([Problem("", "", what, remedy)])
