"""What the certificate of a table of variants says of each rule: the limit and what was found."""

from collections.abc import Iterator
from dataclasses import dataclass

from gripcourse.course.model import Course
from gripcourse.text.amounts import percent_text
from gripcourse.text.words import Message, Words, message
from gripcourse.variants.audit import VariantAudit


@dataclass(frozen=True, slots=True)
class CertificateLine:
    """A line of the table of checks."""

    what: Message
    limit: str
    found: str
    kept: bool


def tested_for_bodies(audit: VariantAudit, course: Course) -> int:
    """Count the variants whose bodies are looked at: those of schemes whose view shows bodies."""
    views = {id_: scheme.view for id_, scheme in course.schemes.items()}
    shown = {id_ for id_, view in views.items() if view is not None and view.bodies}
    return sum(one.variant.scheme in shown for one in audit.variants)


def check_lines(audit: VariantAudit, tested: int, words: Words) -> Iterator[CertificateLine]:
    """Yield the lines of the table of checks.

    Args:
        audit: what was found out.
        tested: variants whose bodies were looked at.
        words: the language of the certificate.
    """
    rules, apart = audit.rules, audit.apart

    def variants(found: int) -> str:
        return words.say(message("{count} of {all}", count=found, all=len(audit.variants)))

    broken = sum(bool(one.broken) for one in audit.variants)
    yield CertificateLine(
        message("Variants that cannot be solved or break a constraint of their space"),
        "0",
        variants(broken),
        not broken,
    )
    near = sum(bool(one.slips) for one in audit.variants)
    yield CertificateLine(
        message("Variants in which a slip gives the right result to within {bands} tolerances",
                bands=rules.slip_bands),
        "0", variants(near), not near,
    )  # fmt: skip
    edges = sum(bool(one.edges) for one in audit.variants)
    yield CertificateLine(
        message("Variants in which a size changes when an answer it is taken for moves by {share}",
                share=percent_text(rules.step_margin, words)),
        "0", variants(edges), not edges,
    )  # fmt: skip
    if audit.overlaps is not None and tested:
        yield CertificateLine(
            message("Variants with bodies that stand in each other, open and with the greatest and"
                    " the smallest object"),
            "0", _interference(audit.overlaps, tested, words), not audit.overlaps,
        )  # fmt: skip
    yield CertificateLine(message("Answers of the longest assignment over those of the shortest"),
               words.number(rules.steps_ratio, 3), words.number(audit.ratio, 3),
               audit.alike_steps)  # fmt: skip
    whole = float(apart.whole.share.max(initial=0.0))
    yield CertificateLine(
        message("Points of computed quantities that one student gets with another's answers"),
        percent_text(rules.shared_points, words), percent_text(whole, words),
        not apart.whole.above,
    )  # fmt: skip
    section = max((float(one.share.max(initial=0.0)) for one in apart.sections), default=0.0)
    yield CertificateLine(
        message("The same inside one section"),
        percent_text(rules.shared_section_points, words), percent_text(section, words),
        not any(one.above for one in apart.sections),
    )  # fmt: skip


def _interference(overlaps: int, tested: int, words: Words) -> str:
    if overlaps:
        return words.say(message("{count} of {all}", count=overlaps, all=tested))
    return words.say(message("no interference in {count} variants", count=tested))
