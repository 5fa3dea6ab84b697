"""What an assignment sheet says at its end: what to hand in, and how it is judged."""

from collections.abc import Iterator

from gripcourse.course.note import NotedDocument, notes_of
from gripcourse.course.quantity import Convention
from gripcourse.policy.model import Policy
from gripcourse.solver.asked import cited_works
from gripcourse.solver.plan import Plan
from gripcourse.text.amounts import percent_text
from gripcourse.text.words import LANGUAGES, Message, Texts, Words, message


def hand_in(plan: Plan, words: Words) -> Iterator[Message]:
    """Yield what is to be handed in."""
    yield message(
        "The workbook that was issued with this sheet, with your answers in its marked cells. "
        "Do not change the given values: answers are judged against the values of this sheet."
    )
    if plan.manual:
        titles = "; ".join(quantity.title.of(words.language) for quantity in plan.manual)
        yield message("The instructor marks from a rubric: {titles}.", titles=titles)


def course_notes(plan: Plan, words: Words) -> Iterator[str]:
    """Yield what the course itself says about its quantities."""
    for text in notes_of(
        plan.course.notes, NotedDocument.ASSIGNMENT, plan.scheme.id, plan.quantities
    ):
        yield text.of(words.language)


def judging_rules(plan: Plan, policy: Policy, words: Words) -> Iterator[Message]:
    """Yield how answers are judged, and what numbers in brackets mean."""
    yield message(
        "An answer is right when it differs from the expected value by no more than {band}, unless "
        "another tolerance is printed beside the quantity.",
        band=percent_text(policy.tolerance.relative, words),
    )
    yield from _works(plan)
    yield from _carried(policy, words)
    yield message(
        "Sizes that you accept from a series are design decisions. They are judged by their rule: "
        "an entry of the series, not below the required value and not wastefully above it. Your "
        "own choice is used in everything that follows."
    )
    yield from _errata(plan, policy, words)
    yield message(
        "Write numbers with a decimal comma or a decimal point, in the unit beside the cell, and "
        "keep at least four significant figures. An empty cell is no answer; it is not read as "
        "zero."
    )


def _works(plan: Plan) -> Iterator[Message]:
    works = cited_works(plan)
    if works:
        yield message(
            "In square brackets: the number of the work and its equation. {works}",
            works=Texts({
                language: "; ".join(
                    f"[{number}] {work.title.of(language)}"
                    for number, work in enumerate(works, start=1)
                )
                for language in LANGUAGES
            }),
        )  # fmt: skip


def _carried(policy: Policy, words: Words) -> Iterator[Message]:
    if policy.carried_credit >= 1:
        yield message(
            "A mistake costs its points once: an answer that follows from your own earlier numbers "
            "counts in full."
        )
    elif policy.carried_credit > 0:
        yield message(
            "A mistake is not charged twice: an answer that follows from your own earlier numbers "
            "earns {share} of its points.",
            share=percent_text(policy.carried_credit, words),
        )


def _errata(plan: Plan, policy: Policy, words: Words) -> Iterator[Message]:
    if not any(one.as_printed for one in plan.quantities.values()):
        return
    if plan.convention is Convention.AS_PRINTED:
        yield message("The reference follows the formulas as the sources print them.")
    elif policy.printed_credit is None:
        yield message("The sources have known misprints; only the corrected formulas count.")
    elif policy.printed_credit >= 1:
        yield message(
            "The sources have known misprints. An answer computed exactly as they print a formula "
            "counts in full, with a remark on what is right."
        )
    else:
        yield message(
            "The sources have known misprints. An answer computed exactly as they print a formula "
            "earns {share} of its points, with a remark on what is right.",
            share=percent_text(policy.printed_credit, words),
        )
