"""What the use cases return, put into words as results."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from gripcourse.api.results import (
    CheckedAnswerResult,
    CheckedSectionResult,
    CheckResult,
    DrawingTallyResult,
    HandoutResult,
    IssueResult,
    ProblemResult,
    ProblemsResult,
    SolutionResult,
    SourceResult,
    ValueResult,
    VariantResult,
    VariantsResult,
)
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import Problem
from gripcourse.exports.make_report_result import finite
from gripcourse.text.units import unit_text
from gripcourse.text.words import Message, Words

if TYPE_CHECKING:
    # Who asks for one result should not wait for what makes the others.
    from gripcourse.usecases.grading.check import CheckedWorkbook
    from gripcourse.usecases.issuing.issue import Issuing
    from gripcourse.usecases.solving.solve import SolvedVariant
    from gripcourse.variants.model import Variant
    from gripcourse.variants.tally import Tally


def solution_result(solved: "SolvedVariant", words: Words) -> SolutionResult:
    """Put a solved variant into words."""
    plan = solved.plan
    values = {
        name: ValueResult(
            symbol=quantity.symbol.of(words.language),
            title=quantity.title.of(words.language),
            unit=quantity.unit,
            value=finite(solved.values[name]),
            kind=quantity.kind,
            section=quantity.section,
            source=_source_result(quantity, words),
        )
        for name, quantity in plan.quantities.items()
        if quantity.kind is not Kind.MANUAL
    }
    return SolutionResult(
        scheme=plan.scheme.id,
        variant=solved.variant.id,
        options=dict(plan.options),
        convention=plan.convention,
        values=values,
        assumed=solved.assumed,
    )


def problems_result(
    problems: Iterable[Problem], words: Words, notes: Iterable[Problem] = ()
) -> ProblemsResult:
    """Put problems and notes into words."""
    return ProblemsResult(
        tuple(_problem_result(one, words) for one in problems),
        tuple(_problem_result(one, words) for one in notes),
    )


def _problem_result(problem: Problem, words: Words) -> ProblemResult:
    return ProblemResult(
        file=problem.file,
        key=problem.key if isinstance(problem.key, str) else words.say(problem.key),
        what=words.say(problem.what),
        remedy=words.say(problem.remedy),
        excerpt=problem.excerpt,
        parameter=problem.parameter,
        step=problem.step,
    )


def variants_result(
    variants: "Iterable[Variant]", tallies: "Iterable[Tally]" = ()
) -> VariantsResult:
    """Make the result of a table of variants."""
    return VariantsResult(
        tuple(
            VariantResult(one.id, one.scheme, dict(one.options), dict(one.given))
            for one in variants
        ),
        tuple(DrawingTallyResult(one.scheme, one.tried, one.sound) for one in tallies),
    )


def issue_result(issuing: "Issuing", words: Words) -> IssueResult:
    """Put what was issued into words."""
    return IssueResult(
        handouts=tuple(
            HandoutResult(one.student, tuple(map(str, one.files)), _said(one.faults, words))
            for one in issuing.handouts
        ),
        notes=_said(issuing.notes, words),
    )


def check_result(checked: "CheckedWorkbook", words: Words) -> CheckResult:
    """Put a self-check into words."""
    answers = []
    for one in checked.checks:
        quantity = checked.plan.quantities[one.quantity]
        answers.append(
            CheckedAnswerResult(
                quantity=one.quantity,
                symbol=quantity.symbol.of(words.language),
                title=quantity.title.of(words.language),
                unit=unit_text(quantity.unit, words.language),
                state=one.state,
                value=finite(one.answer.value),
                typed=one.answer.typed,
                cell=one.answer.cell,
                message=words.say(one.message),
                remarks=_said(one.remarks, words),
                verdict=quantity.kind is Kind.VERDICT,
            )
        )
    titles = {one.id: one.title for one in checked.plan.course.sections}
    sections = (
        CheckedSectionResult(
            one.section, titles[one.section].of(words.language), one.state, words.say(one.message)
        )
        for one in checked.sections
    )
    remarks = _said(checked.remarks, words)
    return CheckResult("", tuple(answers), remarks, tuple(sections), checked.left)


def refused_check(problems: Iterable[Problem], words: Words) -> CheckResult:
    """Say why a file cannot be checked: that is for its sender to correct, and no exception."""
    said = (f"{words.say(one.what)} {words.say(one.remedy)}" for one in problems)
    return CheckResult(" ".join(said), (), ())


def _source_result(quantity: Quantity, words: Words) -> SourceResult:
    source = quantity.source
    return SourceResult(source.work, source.equation, source.told(words.language))


def _said(sentences: Sequence[Message], words: Words) -> tuple[str, ...]:
    return tuple(words.say(one) for one in sentences)
