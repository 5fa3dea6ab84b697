"""Which slips a cohort made: by quantity, and by kind."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.course.quantity import Quantity
from gripcourse.grading.model import Finding, FlagCode, Report
from gripcourse.policy.slips import SlipKind, SlipPolicy
from gripcourse.slips.model import DECLARED, NOT_STEPPED_UP, USED, SlipId
from gripcourse.text.amounts import percent_text
from gripcourse.text.words import Message, Texts, Words, message

_MOST = 15  # rows on paper; the table of kinds counts all of them


@dataclass(frozen=True, slots=True)
class Mistake:
    """A wrong answer of one student.

    Attributes:
        quantity: id of the quantity that it was made in, which may be a step that is blank.
        slip: None where nothing explains the answer.
        finding: the answer that shows it.
    """

    quantity: str
    slip: SlipId | None
    finding: Finding


@dataclass(frozen=True, slots=True)
class SlipRow:
    """A slip in a quantity: what was done, how many did it, of how many who were wrong there."""

    symbol: str
    title: str
    hint: str
    count: str
    share: str


@dataclass(frozen=True, slots=True)
class KindRow:
    """A kind of slip: answers, students, and its share of all wrong answers."""

    title: str
    answers: str
    students: str
    share: str


def mistakes_of(report: Report) -> Iterator[Mistake]:
    """Yield what one student did wrong, each mistake once; see `mistakes_in`.

    Another student's workbook has none.
    """
    if not is_anothers(report):
        yield from mistakes_in(report.findings)


def is_anothers(report: Report) -> bool:
    """Tell of another student's workbook: its numbers are nobody's wrong method."""
    return any(flag.code is FlagCode.ISSUED_TO_OTHER for flag in report.flags)


def mistakes_in(findings: Iterable[Finding]) -> Iterator[Mistake]:
    """Yield what was done wrongly, each mistake once.

    What follows from a mistake is none; what a person has decided about is not counted. Of two
    slips that explain an answer equally the likelier counts.
    """
    seen: set[tuple[str, SlipId]] = set()
    for finding in findings:
        if finding.outcome.traits.mistake:
            place = finding.quantity
        elif finding.outcome.traits.follows and finding.slip and finding.roots:
            place = finding.roots[0]  # a step that was left out: its slip shows in this answer
        else:
            continue
        if finding.slip is None or (place, finding.slip) not in seen:
            yield Mistake(place, finding.slip, finding)
        if finding.slip is not None:
            seen.add((place, finding.slip))


def slip_rows(
    reports: Sequence[Report], declared: Mapping[str, Quantity], words: Words
) -> list[SlipRow]:
    """Return the most common slips of single quantities, the commonest first.

    Args:
        reports: of the cohort.
        declared: the quantities by id.
        words: the reader's language.
    """
    found = [one for report in reports for one in mistakes_of(report)]
    wrong = Counter(one.quantity for one in found)
    counts = Counter((one.quantity, one.slip) for one in found if one.slip)
    shown = {(one.quantity, one.slip): one.finding for one in reversed(found)}
    rows = []
    for (name, slip), count in counts.most_common(_MOST):
        quantity = declared.get(name)
        rows.append(
            SlipRow(
                symbol=quantity.symbol.of(words.language) if quantity else "",
                title=quantity.title.of(words.language) if quantity else name,
                hint=_hint(quantity, slip, shown[name, slip], declared, words),
                count=str(count),
                share=percent_text(count / wrong[name], words),
            )
        )
    return rows


def kind_rows(reports: Sequence[Report], policy: SlipPolicy, words: Words) -> list[KindRow]:
    """Count the kinds of slips over all quantities, the commonest first, the unexplained last."""
    answers: Counter[str] = Counter()
    students: dict[str, int] = defaultdict(int)
    for report in reports:
        kinds = Counter(one.slip.kind if one.slip else "" for one in mistakes_of(report))
        answers += kinds
        for kind in kinds:
            students[kind] += 1
    total = answers.total()
    order = sorted(answers, key=lambda kind: (kind == "", -answers[kind]))
    return [
        KindRow(
            title=_title(kind, policy, words),
            answers=str(answers[kind]),
            students=str(students[kind]),
            share=percent_text(answers[kind] / total, words),
        )
        for kind in order
    ]


def _title(kind: str, policy: SlipPolicy, words: Words) -> str:
    names: Mapping[str, Message] = {
        "": message("not explained"),
        DECLARED: message("a mistake known for this formula"),
        USED: message("another number than the given or found one"),
        NOT_STEPPED_UP: message("a size that was not stepped up"),
    }
    if kind in names:
        return words.say(names[kind])
    generic = policy.kinds.get(SlipKind(kind)) if kind in set(SlipKind) else None
    return generic.title.of(words.language) if generic else kind


def _hint(
    quantity: Quantity | None,
    slip: SlipId,
    finding: Finding,
    declared: Mapping[str, Quantity],
    words: Words,
) -> str:
    """Say what was done: the hint that the student reads too."""
    if slip.kind == USED:
        used = declared.get(slip.detail)
        title = used.title if used else slip.detail
        return words.say(message("Another number was used for {title}.", title=title))
    own = {one.id: one.hint for one in quantity.slips} if quantity else {}
    hint = own.get(str(slip)) or finding.message.values.get("hint")
    return hint.of(words.language) if isinstance(hint, Texts) else words.say(finding.message)
