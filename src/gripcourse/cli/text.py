"""What the command line prints: tables, summaries and the progress bar."""

import json
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from gripcourse.cli.loudness import is_quiet
from gripcourse.cli.table_layout import table_text
from gripcourse.errors import Problem, UsageError
from gripcourse.machine.files import write_text
from gripcourse.text.words import Message, Texts, Words, counted, message

# rich costs 60 ms to import: only who prints a table or a bar pays; likewise other rare ones.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from gripcourse.course.quantity import Convention
    from gripcourse.machine.doctor import MachineCheck
    from gripcourse.usecases.grading.check import CheckedWorkbook
    from gripcourse.usecases.solving.audit import WrittenAudit
    from gripcourse.variants.audit import VariantAudit
    from gripcourse.variants.draw import Drawn
    from gripcourse.variants.tally import Refusal

Step = Callable[[str, int | None], Callable[[], None]]
_MOST_TOLD = 10


def misuse(what: Message, remedy: Message | None = None) -> UsageError:
    """Make the error of a command that was called wrongly."""
    return UsageError([Problem("", "", what, remedy or message("See --help."))])


def refuse_closed_output() -> int:
    """Refuse to work for nobody.

    Raises:
        UsageError: always.
    """
    raise misuse(
        message("The output is closed: nothing could be shown."),
        message("Leave it open; >/dev/null throws it away."),
    )


def chosen_convention(name: str | None) -> "Convention | None":
    """Read the convention that a user chose; None for the course's."""
    from gripcourse.course.quantity import Convention
    from gripcourse.text.suggestion import did_you_mean

    if name is None or name in list(Convention):
        return None if name is None else Convention(name)
    raise misuse(
        message("There is no convention '{name}'.", name=name), did_you_mean(name, list(Convention))
    )


@contextmanager
def progress(words: Words) -> Iterator[Step]:
    """Show a bar for each step with its rate and the time that it still takes; on stderr."""
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeRemainingColumn,
    )

    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[rate]}"),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), disable=is_quiet()) as bar:

        def step(name: str, total: int | None) -> Callable[[], None]:
            task = bar.add_task(name, total=total, rate="")
            began, done = perf_counter(), count(1)

            def tick() -> None:
                rate = 60 * next(done) / max(perf_counter() - began, 0.001)
                said = words.say(message("{count}/min", count=f"{rate:.0f}"))
                bar.update(task, advance=1, rate=said)

            return tick

        yield step


def written_variants(count: int, file: Path) -> Message:
    """Say how many variants a file got."""
    return counted(
        "{count} variant was written to {file}.",
        "{count} variants were written to {file}.",
        count,
        file=str(file),
    )


def kept_former(file: Path, kept: Path) -> Message:
    """Say where the file is whose place another one took."""
    return message(
        "{file} was there already and said something else: it is {kept} now.",
        file=file.name,
        kept=str(kept),
    )


def drawn_text(drawn: "Drawn", out: Path, words: Words) -> str:
    """Return how many variants were drawn, the acceptance rates and the main reasons."""
    lines = [words.say(written_variants(len(drawn.variants), out))]
    for tally in drawn.tallies:
        lines.append(
            words.say(
                message(
                    "{scheme}: {share} % of {tried} candidates can be solved.",
                    scheme=tally.scheme,
                    share=round(100 * tally.acceptance, 1),
                    tried=tally.tried,
                )
            )
        )
        lines += [
            f"  {refusal.count} ({refusal.count / tally.tried:.0%}): {words.say(refusal.what)}"
            for refusal in tally.refusals[:5]
        ]
        lines += [
            f"  {words.say(_left_out(refusal, tally.tried))}" for refusal in tally.set_aside[:5]
        ]
    return "\n".join(lines)


def _left_out(refusal: "Refusal", tried: int) -> Message:
    return message(
        "{count} ({share}) can be solved and are left out: {why}",
        count=refusal.count,
        share=f"{refusal.count / tried:.0%}",
        why=refusal.what,
    )


def audit_text(audited: "WrittenAudit", words: Words) -> str:
    """Return how many variants break which rule, and where the certificate is."""
    found = audited.audit
    share = float(found.apart.whole.share.max(initial=0.0))
    said = [
        counted("{count} variant of {file} was checked.",
                "{count} variants of {file} were checked.",
                len(found.variants), file=str(audited.table)),
        message("Breaking a rule of their space: {count}.",
                count=sum(bool(one.broken) for one in found.variants)),
        message("With a slip that gives nearly the right result: {count}.",
                count=sum(bool(one.slips) for one in found.variants)),
        message("With a size at the edge of its step: {count}.",
                count=sum(bool(one.edges) for one in found.variants)),
        message("Too near to another variant: {count}.",
                count=sum(one.above for one in found.variants)),
        *_overlap_lines(found, audited.tested),
        message("At most {share} % of the points of computed quantities are shared.",
                share=round(100 * share, 1)),
        message("Answers of the longest assignment for each of the shortest: {ratio}.",
                ratio=round(found.ratio, 2)),
        *_monotony_lines(found),
    ]  # fmt: skip
    verdict = (
        message("The table keeps all rules.")
        if found.passed
        else message("The table does not keep all rules.")
    )
    return "\n".join([*(words.say(one) for one in (*said, verdict)), *map(str, audited.written)])


def _overlap_lines(found: "VariantAudit", tested: int) -> Iterator[Message]:
    from gripcourse.variants.overlaps import overlap_text

    if found.overlaps is None or not tested:
        return
    if not found.overlaps:
        yield message("No bodies stand in each other; variants looked at: {count}.", count=tested)
        return
    yield message("With bodies that stand in each other: {count}.", count=found.overlaps)
    worst = [(one.variant.id, one.overlap) for one in found.variants if one.overlap is not None]
    for variant, overlap in worst[:_MOST_TOLD]:
        yield message("  {variant}: {what}", variant=variant, what=overlap_text(overlap))


def _monotony_lines(found: "VariantAudit") -> Iterator[Message]:
    """Name what hardly differs from variant to variant; nothing where everything does."""
    same, ends, verdicts = found.same_sizes, found.same_ends, found.lopsided_verdicts
    if same:
        yield message("Sizes that are one and the same in most variants of a scheme: {sizes}.",
                      sizes=_some(f"{one.scheme} {one.quantity} {round(100 * one.share)} %"
                                  for one in same))  # fmt: skip
    if verdicts:
        yield message("Verdicts that hardly come out either way: {verdicts}.",
                      verdicts=_some(f"{one.scheme} {one.quantity} {one.yes}/{one.variants}"
                                     for one in verdicts))  # fmt: skip
    if ends:
        yield message("Formulas that mostly take the same of two values: {formulas}.",
                      formulas=_some(f"{one.scheme} {one.quantity} {round(100 * one.same)} %"
                                     for one in ends))  # fmt: skip
    if found.told_ends:
        yield message("Formulas that can take only one of two values, as ends.csv says why:"
                      " {count}.", count=len(found.told_ends))  # fmt: skip


def _some(named: Iterable[str]) -> Message:
    """Name the first of several."""
    names = list(named)
    said = message("{names}", names="; ".join(names[:_MOST_TOLD]))
    more = len(names) - _MOST_TOLD
    return message("{names} and {count} more", names=said, count=more) if more > 0 else said


def check_text(checked: "CheckedWorkbook", words: Words) -> str:
    """Return what a student learns about a workbook."""
    from gripcourse.submission.model import Reading

    rows = []
    for check in checked.checks:
        quantity = checked.plan.quantities[check.quantity]
        said = " ".join(words.say(one) for one in (check.message, *check.remarks))
        if check.answer.reading is Reading.UNREADABLE:
            said = f"{check.answer.cell}: {said}"
        typed = check.answer.typed
        rows.append(
            (
                quantity.symbol.of(words.language),
                _title(quantity.title, words),
                typed,
                _unit(quantity.unit, words),
                said,
            )
        )
    heads = ("", message("quantity"), message("your answer"), message("unit"), message("check"))
    lines = [words.say(remark) for remark in checked.remarks]
    named = [one if isinstance(one, str) else words.say(one) for one in heads]
    return "\n".join([*lines, table_text(named, rows, right={2}), *_sections_text(checked, words)])


def _sections_text(checked: "CheckedWorkbook", words: Words) -> Iterator[str]:
    """Yield what is said of sections, or why nothing is."""
    if not checked.sections:
        yield words.say(
            message(
                "Whether numbers follow from each other is told by your department's server, a few "
                "times to each student."
            )
            if checked.left is None
            else message("Whether numbers follow from each other will not be shown again.")
        )
        return
    titles = {one.id: one.title for one in checked.plan.course.sections}
    rows = [
        (_title(titles[one.section], words), words.say(one.message)) for one in checked.sections
    ]
    heads = (message("section"), message("check"))
    yield table_text([words.say(one) for one in heads], rows, right=set())
    yield words.say(message("Checks of this kind that are left: {count}.", count=checked.left or 0))


def json_text(plain: object) -> str:
    """Return the plain form of a result as JSON."""
    # A terminal that lacks letters gets them as JSON writes them, not as question marks.
    is_plain = (sys.stdout.encoding or "").lower().replace("-", "") != "utf8"
    return json.dumps(plain, ensure_ascii=is_plain, indent=1, allow_nan=False)


def doctor_text(found: "Sequence[MachineCheck]", words: Words) -> str:
    """Return what the machine has and lacks, each lack with its remedy."""
    lines = []
    for check in found:
        sign = "✓" if check.ok else ("✗" if check.required else "–")
        remedy = "" if check.ok else f". {words.say(check.remedy)}"
        lines.append(f"{sign} {words.say(check.message)}{remedy}")
    return "\n".join(lines)


def write_incident(trace: str) -> Path | None:
    """Write a traceback where a user can find it, and return where; None where nothing can be."""
    import hashlib
    import tempfile

    number = hashlib.sha256(trace.encode()).hexdigest()[:8]
    path = Path(tempfile.gettempdir()) / f"gripcourse-incident-{number}.log"
    # The folder is everybody's: not through a link that somebody laid there, and for nobody else.
    try:
        write_text(path, trace, private=True)
    except OSError:
        return None
    return path


def _title(title: Texts, words: Words) -> str:
    return title.of(words.language)


def _unit(unit: str, words: Words) -> str:
    from gripcourse.text.units import unit_text

    return unit_text(unit, words.language)
