"""Deriving the tolerances of a policy from honest students."""

import csv
import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.errors import Problem
from gripcourse.machine.content import Readable, shown_name
from gripcourse.machine.files import write_text
from gripcourse.policy.load import policy_path
from gripcourse.policy.model import Policy
from gripcourse.simulation.mix import load_mix
from gripcourse.simulation.tolerance import AuditedBand, ToleranceAudit, audit_tolerances, to_write
from gripcourse.simulation.tolerance_policy import apply_tolerances
from gripcourse.variants.draw import draw
from gripcourse.variants.model import Variant
from gripcourse.variants.pays import MistakeCost, mistake_costs, paying_rules, uneven_costs
from gripcourse.variants.space import load_spaces
from gripcourse.variants.table import read_table

_HEADS = (
    "quantity", "unit", "answers", "refused", "relative_now", "absolute_now", "wrong_methods",
    "accepted_now", "relative_proposed", "absolute_proposed", "accepted_share_proposed",
    "by_absolute", "held_by_floor", "widest_spread", "ill_conditioned", "equal_to_right",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class ToleranceSample:
    """What an audit looks at: the issued table, and variants drawn besides."""

    table: Readable
    count: int
    seed: int


@dataclass(frozen=True, slots=True)
class Paying:
    """What mistakes cost over the issued table, and rules that pay.

    Attributes:
        costs: of each main result.
        uneven: of other answers, where they cost much more in some variants than in others.
        problems: rules that let guesses pay.
    """

    costs: tuple[MistakeCost, ...]
    uneven: tuple[MistakeCost, ...]
    problems: tuple[Problem, ...]


def variants_of(course: Course, sample: ToleranceSample) -> tuple[Variant, ...]:
    """Read the issued variants and draw further ones.

    Raises:
        GripcourseError: the table or the spaces cannot be used.
    """
    issued = read_table(sample.table, course)
    if not sample.count:
        return issued
    return (*issued, *draw(course, load_spaces(course), sample.count, sample.seed).variants)


def audit(
    course: Course,
    policy: Policy,
    variants: Sequence[Variant],
    workers: int,
    on_done: Callable[[], None],
) -> ToleranceAudit:
    """Audit the tolerances of a course; see `simulation.tolerance.audit_tolerances`."""
    return audit_tolerances(course, policy, load_mix(course), variants, workers, on_done)


def paying(course: Course, policy: Policy, sample: ToleranceSample) -> Paying:
    """Look into the issued table: what mistakes cost in it, and which rules let guesses pay.

    Raises:
        GripcourseError: the table cannot be used.
    """
    issued = read_table(sample.table, course)
    costs = mistake_costs(course, policy, issued)
    return Paying(
        costs=tuple(one for one in costs if one.is_main),
        uneven=tuple(one for one in uneven_costs(costs, policy) if not one.is_main),
        problems=tuple(paying_rules(course, policy, issued, shown_name(sample.table))),
    )


def apply(found: ToleranceAudit, course: Course, policy: Policy) -> int:
    """Write the proposed tolerances into the policy; return how many were changed.

    Raises:
        UsageError: the policy is written in a way that cannot be changed line by line.
        OSError: it cannot be written.
    """
    changed = {one.quantity.id: to_write(one, policy) for one in found.quantities if one.changes}
    path = policy_path(course.root)
    apply_tolerances(path, str(path.relative_to(course.root)), changed)
    return len(changed)


def write_audit(found: ToleranceAudit, path: Path) -> None:
    """Write the audit as CSV, a row per quantity."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(_HEADS)
    writer.writerows(_row(one) for one in found.quantities)
    write_text(path, stream.getvalue())


def _row(one: AuditedBand) -> tuple[object, ...]:
    tally = one.tally
    return (
        one.quantity.id, one.quantity.unit, tally.answers, tally.refused, one.now.relative,
        one.now.absolute, tally.slips, tally.accepted, one.proposed.relative,
        one.proposed.absolute, f"{one.price:.6f}", one.by_absolute, tally.on_floor,
        f"{tally.widest:.6f}", one.ill_conditioned, tally.same,
    )  # fmt: skip
