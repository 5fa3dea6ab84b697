"""A grader for tests that does what the file tells it; it must be found from another process."""

import os
import time
from dataclasses import replace
from pathlib import Path

from gripcourse.batch.context import GradingContext
from gripcourse.grading.identify import identify
from gripcourse.grading.model import Report
from gripcourse.grading.unjudged import rejected_report
from gripcourse.submission.model import Rejected
from gripcourse.text.words import message

REFUSED = "a formula nobody foresaw"


def obey(file: Path, context: GradingContext) -> Report:
    """Do what the first word of the file says; its second word becomes the digest."""
    order, *rest = file.read_text(encoding="utf-8").split()
    if order == "die":
        os._exit(9)
    if order == "die-once":
        file.write_text("good", encoding="utf-8")
        os._exit(9)
    if order == "raise":
        raise RuntimeError(REFUSED)
    if order == "exhaust":
        raise RuntimeError(str(len(bytearray(1 << 45))))
    if order == "hang":
        _hang()
    if order == "slow":
        time.sleep(0.3)
    issued = identify(str(file), None, context.register).issued
    report = rejected_report(Rejected(str(file), "".join(rest), message("Graded.")), issued)
    return replace(report, flags=(), judged=True, score=1.0, max_score=1.0)


def _hang() -> None:
    """Hang as a parser does, whose caller takes every exception for a fault of the file."""
    while True:
        try:
            time.sleep(60)
        except Exception:  # noqa: BLE001, S112 (that is the point)
            continue
