"""Whether the scores of a cohort can be relied on: reliability, equal difficulty, times."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.course.model import Course
from gripcourse.grading.analytics.difficulty import EqualDifficulty, equally_hard
from gripcourse.grading.analytics.reliability import reliability_table
from gripcourse.grading.analytics.shares import FEWEST, VIEWS, score_table, share_table
from gripcourse.grading.model import Report
from gripcourse.text.words import Message, Words, message


@dataclass(frozen=True, slots=True)
class ReliabilityRow:
    """Works that are compared by the same items: texts in the order of the columns."""

    title: str
    works: str
    items: str
    alphas: tuple[str, str]


def reliability_rows(
    reports: Sequence[Report], course: Course, words: Words
) -> list[ReliabilityRow]:
    """Return a row for all works, then one for each scheme; none that says nothing.

    Args:
        reports: of a cohort; what could not be judged says nothing.
        course: titles of the schemes.
        words: the reader's language.
    """
    if _are_too_few(reports):
        return []
    rows = []
    for found in reliability_table(share_table(reports)).to_dict("records"):
        alphas = [found[f"alpha_{view}"] for view in VIEWS]
        if all(_is_number(one) for one in alphas):
            rows.append(
                ReliabilityRow(
                    title=_title(str(found["scheme"]), course, words),
                    works=str(found["works"]),
                    items=str(found["count"]),
                    alphas=(_two(alphas[0], words), _two(alphas[1], words)),
                )
            )
    return rows


def difficulty_sentences(reports: Sequence[Report], words: Words) -> Iterator[str]:
    """Yield what the test of equally hard schemes says, with consequences and without them."""
    if _are_too_few(reports):
        return
    scores = score_table(share_table(reports))
    for view in VIEWS:
        found = equally_hard(scores[view], scores["scheme"])
        if found is not None:
            yield words.say(_told(view, _values(found, words)))


def _are_too_few(reports: Sequence[Report]) -> bool:
    """Tell whether nothing can be said of so few works, so that no table need be made of them."""
    return sum(report.judged for report in reports) < FEWEST


def _told(view: str, values: Mapping[str, str | int]) -> Message:
    if view == "with":
        return message(
            "Kruskal–Wallis test of {groups} schemes, {works} works, with consequences: "
            "H = {statistic}, p = {p}, ε² = {effect}.",
            **values,
        )
    return message(
        "Kruskal–Wallis test of {groups} schemes, {works} works, without consequences: "
        "H = {statistic}, p = {p}, ε² = {effect}.",
        **values,
    )


def time_sentence(reports: Sequence[Report], words: Words) -> str:
    """Say how often and how late works were handed in; nothing where no rule asks for it."""
    timed = [(one.student, one.timing) for one in reports if one.timing is not None]
    if not timed:
        return ""
    works = Counter({student: timing.of for student, timing in timed})
    said = message(
        "Works: {works}, students: {students}; handed in more than once: {again}; late works:"
        " {late}; handed in nobody knows when: {unknown}.",
        works=len(timed),
        students=len(works),
        again=sum(count > 1 for count in works.values()),
        late=sum(timing.days_late > 0 for _, timing in timed),
        unknown=sum(timing.is_unknown for _, timing in timed),
    )
    return words.say(said)


def _values(found: EqualDifficulty, words: Words) -> dict[str, str | int]:
    return {
        "groups": found.groups,
        "works": found.works,
        "statistic": words.number(found.statistic, 3),
        "p": words.number(found.p_value, 2),
        "effect": _two(found.effect, words),
    }


def _title(scheme: str, course: Course, words: Words) -> str:
    if not scheme:
        return words.say(message("all works, by sections"))
    return course.schemes[scheme].title.of(words.language) if scheme in course.schemes else scheme


def _two(value: float, words: Words) -> str:
    return words.number(round(value, 2), 3)


def _is_number(value: float | None) -> bool:
    return value is not None and value == value  # noqa: PLR0124 (not a number is not itself)
