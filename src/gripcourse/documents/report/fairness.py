"""Whether schemes and variants were equally hard: scores of those who had the same one."""

import math
import statistics
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from gripcourse.course.model import Course
from gripcourse.documents.report.totals import spread
from gripcourse.grading.model import Report
from gripcourse.text.amounts import percent_text
from gripcourse.text.words import Words, message

_FEWEST: Final = 2  # students with the same variant, and on either side of a comparison
_TELLING: Final = 2.0  # standard errors


@dataclass(frozen=True, slots=True)
class Difference:
    """How a group's mean differs from everybody else's: shares of one, and its standard error."""

    away: float
    error: float

    @property
    def telling(self) -> bool:
        """Whether chance is an unlikely explanation."""
        return abs(self.away) > _TELLING * self.error


@dataclass(frozen=True, slots=True)
class FairnessRow:
    """A scheme or a variant: texts in the order of the columns.

    Attributes:
        title: of the scheme, or the variant's number.
        inside: whether it is a variant below its scheme.
        variants: how many different ones; empty for a variant.
        students: how many files were judged.
        mean, deviation, extent: of their scores.
        difference: from everybody else, with its standard error; a dash where there is none.
        telling: whether it is larger than chance would make it.
    """

    title: str
    inside: bool
    variants: str
    students: str
    mean: str
    deviation: str
    extent: str
    difference: str
    telling: bool


def fairness_rows(reports: Sequence[Report], course: Course, words: Words) -> list[FairnessRow]:
    """Return a row for each scheme, below it one for each variant that several students had.

    Args:
        reports: of the cohort; what could not be judged says nothing.
        course: titles of the schemes.
        words: the reader's language.
    """
    scored = {
        place: report.score / report.max_score
        for place, report in enumerate(reports)
        if report.judged and report.max_score
    }
    schemes: dict[str, dict[str, list[int]]] = defaultdict(lambda: defaultdict(list))
    for place in scored:
        schemes[reports[place].scheme][reports[place].variant].append(place)
    rows = []
    for scheme, variants in sorted(schemes.items()):
        places = [place for group in variants.values() for place in group]
        title = course.schemes[scheme].title.of(words.language) if scheme in course.schemes else ""
        rows.append(_row(title or scheme, str(len(variants)), places, scored, words))
        rows += [
            _row(words.say(message("variant {variant}", variant=variant)), "", group, scored, words)
            for variant, group in sorted(variants.items())
            if len(group) >= _FEWEST
        ]
    return rows


def difference(group: Sequence[float], others: Sequence[float]) -> Difference | None:
    """Compare two groups of scores; None where one is too small to have a spread.

    The standard error is Welch's: the groups need neither one size nor one spread.
    """
    if len(group) < _FEWEST or len(others) < _FEWEST:
        return None
    error = math.sqrt(
        statistics.variance(group) / len(group) + statistics.variance(others) / len(others)
    )
    return Difference(statistics.fmean(group) - statistics.fmean(others), error)


def _row(
    title: str, variants: str, places: Sequence[int], scored: Mapping[int, float], words: Words
) -> FairnessRow:
    group = [scored[place] for place in places]
    inside = set(places)
    found = spread(group)
    apart = difference(group, [score for place, score in scored.items() if place not in inside])
    return FairnessRow(
        title=title,
        inside=not variants,
        variants=variants,
        students=str(len(group)),
        mean=_share(found.mean, words),
        deviation=_share(found.deviation, words),
        extent=extent_text(found.lowest, found.highest, words),
        difference="—" if apart is None else _signed(apart, words),
        telling=apart is not None and apart.telling,
    )


def extent_text(lowest: float | None, highest: float | None, words: Words) -> str:
    """Write from where to where scores reach, as percentages."""
    if lowest is None or highest is None:
        return "—"
    return f"{percent_text(lowest, words)} … {percent_text(highest, words)}"


def _signed(found: Difference, words: Words) -> str:
    away, error = 100 * found.away, 100 * found.error
    sign = "−" if away < 0 else "+"
    return f"{sign}{words.number(round(abs(away), 1), 4)} ± {words.number(round(error, 1), 4)}"


def _share(share: float | None, words: Words) -> str:
    return "—" if share is None else percent_text(share, words)
