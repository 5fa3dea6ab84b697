"""The certificate of a table of variants, for the instructor: what was demanded and what was found.

It is kept with the table: it names the file by its digest, and every number of the rules.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from functools import partial
from itertools import groupby

import numpy as np

from gripcourse.course.compose import declared_in
from gripcourse.course.model import Course
from gripcourse.documents.pdf import Chart, Document, render_pdf
from gripcourse.documents.report.certificate_checks import check_lines, tested_for_bodies
from gripcourse.documents.report.charts import share_plot
from gripcourse.documents.report.columns import aligned, aligned_cells
from gripcourse.documents.report.monotony import alike_rows, size_rows
from gripcourse.documents.report.slip_titles import SlipTitles
from gripcourse.documents.report.verdict_shares import verdict_rows
from gripcourse.policy.model import Policy
from gripcourse.slips.model import DECLARED
from gripcourse.text.amounts import amount_text, percent_text, points_text
from gripcourse.text.words import Message, Words, message
from gripcourse.variants.apart import Shares
from gripcourse.variants.audit import CheckedScheme, VariantAudit
from gripcourse.variants.fair import DifficultySpread, Steps
from gripcourse.variants.overlaps import overlap_text
from gripcourse.variants.pairs import Pair
from gripcourse.variants.slip_distance import SlipCount

TEMPLATE = "certificate.html.j2"
STYLES = ("page.css", "formula.css", "certificate.css")

_MOST = 40  # rows of a table on paper; all of them are in the CSV files
_PAIRS = 20
_MOST_SHARE = 0.99  # of the pairs


@dataclass(frozen=True, slots=True)
class CertificateSource:
    """The table that was audited: name of the file and SHA-256 of its bytes."""

    name: str
    digest: str


def certificate(
    audit: VariantAudit,
    source: CertificateSource,
    course: Course,
    policy: Policy,
    words: Words,
    day: date,
) -> bytes:
    """Make the certificate as a PDF file.

    Args:
        audit: what was found out.
        source: the table.
        course: titles, declarations and the folder with the templates.
        policy: titles of the kinds of slips.
        words: the language of the certificate.
        day: that is printed.
    """
    values = certificate_values(audit, source, course, policy, words) | {"day": day}
    return render_pdf(Document(TEMPLATE, STYLES, values), course.root / "templates", words)


def certificate_values(
    audit: VariantAudit, source: CertificateSource, course: Course, policy: Policy, words: Words
) -> dict[str, object]:
    """Return what the template needs but the day; see `certificate` for the arguments."""
    found = declared_in(course, (one.composition for one in audit.steps))
    declared = {id_: quantity.title.of(words.language) for id_, quantity in found.items()}
    slips = SlipTitles(found, policy, words)
    titles = {id_: scheme.title.of(words.language) for id_, scheme in course.schemes.items()}
    flagged = [one for one in audit.variants if not one.passed]
    weak = audit.weak_items
    alike = alike_rows(audit, titles, declared, words)
    return {
        "course": course.title.of(words.language),
        "source": source,
        "count": len(audit.variants),
        "passed": audit.passed,
        "checks": [(words.say(one.what), one.limit, one.found, one.kept)
                   for one in check_lines(audit, tested_for_bodies(audit, course), words)],
        "plot": Chart(partial(share_plot, audit.apart.whole.histogram.tolist(),
                              audit.rules.shared_points, words)),
        "sections": aligned_cells([
            _section(section.title.of(words.language), shares, audit.apart.pairs, words)
            for section, shares in zip(course.sections, audit.apart.sections, strict=True)
        ]),
        "section_limit": audit.rules.shared_section_points,
        "beside": audit.beside,
        "beyond": bool(audit.apart.beyond),
        "pairs": _pairs(audit, declared, words),
        "flagged": [(one.variant.id, titles[one.variant.scheme],
                     [words.say(said) for said in _sentences(one, audit, declared, slips)])
                    for one in flagged[:_MOST]],
        "flagged_rest": len(flagged[_MOST:]),
        "steps": [_steps(titles[scheme], tuple(found)) for scheme, found in _by_scheme(audit)],
        "margins": [(_title(declared, one.quantity), one.near, one.variants)
                    for one in audit.margins if one.near],
        "weak": _weak_rows(weak[:_MOST], titles, declared, words),
        "weak_rest": len(weak[_MOST:]),
        "weak_limit": audit.rules.weak_item,
        "verdicts": verdict_rows(audit, declared, words),
        "sizes": size_rows(audit, declared, words),
        "alike": alike[:_MOST],
        "alike_rest": len(alike[_MOST:]),
        "rules": audit.rules,
        "slips_counted": audit.slips_counted,
        "slips": aligned_cells(
            [_slips(kind, counts, slips, words) for kind, counts in _by_kind(audit)]
        ),
    }  # fmt: skip


def _section(title: str, shares: Shares, pairs: int, words: Words) -> tuple[str, ...]:
    return (
        title,
        percent_text(float(shares.share.max(initial=0.0)), words),
        str(shares.above),
        percent_text(_below(shares, pairs), words),
    )


def _below(shares: Shares, pairs: int) -> float:
    """Return the whole percent, as a share, that most pairs stay below."""
    done = np.cumsum(shares.histogram)
    return float(np.searchsorted(done, _MOST_SHARE * pairs) + 1) / 100 if pairs else 0.0


def _pairs(
    audit: VariantAudit, declared: Mapping[str, str], words: Words
) -> list[tuple[str, str, tuple[str, ...], str]]:
    """Return for the nearest pairs their variants, shares, and what is the same."""
    pairs = audit.pairs[:_PAIRS]
    shares = aligned_cells([("", *_shares(pair, words)) for pair in pairs])
    return [
        (
            audit.variants[pair.own].variant.id,
            audit.variants[pair.other].variant.id,
            written[1:],
            "; ".join(_title(declared, one) for one in pair.equal),
        )
        for pair, written in zip(pairs, shares, strict=True)
    ]


def _shares(pair: Pair, words: Words) -> Iterator[str]:
    for share in (pair.share, max(pair.sections), pair.sizes, pair.given, pair.followed):
        yield percent_text(share, words)


def _sentences(
    checked: CheckedScheme, audit: VariantAudit, declared: Mapping[str, str], slips: SlipTitles
) -> Iterator[Message]:
    yield from checked.broken
    for quantity, slip in checked.slips:
        title = slips.of(quantity, slip)
        yield message("the slip '{slip}' gives nearly the right result: {quantity}",
                      slip=title, quantity=_title(declared, quantity))  # fmt: skip
    for quantity in checked.edges:
        yield message("the size lies at the edge of its step: {quantity}",
                      quantity=_title(declared, quantity))  # fmt: skip
    if checked.overlap is not None:
        yield overlap_text(checked.overlap)
    if checked.above and checked.nearest is not None:
        other = audit.variants[checked.nearest.other].variant.id
        yield message("too near to another variant; the nearest is {variant}", variant=other)


def _scheme_of(steps: Steps) -> str:
    return steps.composition.scheme


def _by_scheme(audit: VariantAudit) -> Iterator[tuple[str, Iterable[Steps]]]:
    yield from groupby(sorted(audit.steps, key=_scheme_of), _scheme_of)


def _steps(title: str, steps: Sequence[Steps]) -> tuple[str, ...]:
    return (
        title,
        str(sum(one.variants for one in steps)),
        _range([one.computed for one in steps]),
        _range([one.decided for one in steps]),
        _range([one.read for one in steps]),
        _range([one.total for one in steps]),
        _range([one.chain for one in steps]),
    )


def _range(counts: Sequence[int]) -> str:
    low, high = min(counts), max(counts)
    return str(low) if low == high else f"{low}–{high}"


def _weak_rows(
    spreads: Sequence[DifficultySpread],
    titles: Mapping[str, str],
    declared: Mapping[str, str],
    words: Words,
) -> list[tuple[str, ...]]:
    points = aligned([points_text(one.points, words) for one in spreads])
    equal = aligned([percent_text(one.equal, words) for one in spreads])
    return [
        (titles[one.scheme], _title(declared, one.quantity), mark, _extent(one, words), share)
        for one, mark, share in zip(spreads, points, equal, strict=True)
    ]


def _extent(spread: DifficultySpread, words: Words) -> str:
    ends = (amount_text(one, spread.unit, words, 4) for one in (spread.lowest, spread.highest))
    return " … ".join(dict.fromkeys(ends))


def _by_kind(audit: VariantAudit) -> Iterator[tuple[str, list[SlipCount]]]:
    kinds: dict[str, list[SlipCount]] = {}
    for one in audit.slips:
        kinds.setdefault(one.kind, []).append(one)
    yield from sorted(kinds.items(), key=lambda one: (one[0] != DECLARED, -_mean(_varying(one[1]))))


def _slips(
    kind: str, counts: Sequence[SlipCount], slips: SlipTitles, words: Words
) -> tuple[str, ...]:
    sometimes = _varying(counts)
    return (
        slips.of_kind(kind),
        str(len(counts)),
        str(len(counts) - len(sometimes)),
        str(sum(one.near > 0 for one in sometimes)),
        percent_text(_mean(sometimes), words),
    )


def _varying(counts: Sequence[SlipCount]) -> list[SlipCount]:
    """Leave slips out that change nothing in any variant."""
    return [one for one in counts if one.near < one.variants]


def _mean(counts: Sequence[SlipCount]) -> float:
    variants = sum(one.variants for one in counts)
    return sum(one.near for one in counts) / variants if variants else 0.0


def _title(declared: Mapping[str, str], quantity: str) -> str:
    return declared.get(quantity, quantity)
