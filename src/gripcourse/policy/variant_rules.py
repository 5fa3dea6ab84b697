"""Reading what a policy demands of variants: the table `[variants]` of `grader/policy.toml`."""

from gripcourse.course.toml_table import Table
from gripcourse.policy.model import VariantRules
from gripcourse.policy.slips import DECLARED, SlipKind
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

_SHARES = ("shared_points", "shared_section_points", "step_margin", "weak_item",
           "same_size", "same_end")  # fmt: skip


def read_variant_rules(table: Table) -> VariantRules:
    """Read the rules for variants; every fault goes to the table's list of problems."""
    table.known_keys()
    shared, section, margin, weak, size, end = (table.share(name) for name in _SHARES)
    return VariantRules(
        shared_points=shared,
        shared_section_points=section,
        slip_bands=table.at_least("slip_bands", 0.0),
        keep_apart=_kinds(table),
        step_margin=margin,
        steps_ratio=table.at_least("steps_ratio", 1.0),
        weak_item=weak,
        same_size=size,
        same_end=end,
        verdict_no=_shares(table, "verdict_no"),
    )


def _shares(table: Table, name: str) -> tuple[float, float]:
    """Read the ends of a range of shares."""
    if not table.has(name):
        table.add(name, message("This key is missing."), message("Write it like [0.3, 0.7]."))
    low, high = table.pair(name, (0.0, 1.0))
    if not 0 <= low < high <= 1:
        table.add(
            name,
            message("The shares are {low} and {high}.", low=low, high=high),
            message("Write two numbers from 0 to 1, the smaller first."),
        )
    return low, high


def _kinds(table: Table) -> tuple[str, ...]:
    known = {DECLARED, *SlipKind}
    kinds = table.strings("keep_apart")
    for kind in kinds:
        if kind not in known:
            table.add(
                "keep_apart",
                message("There is no kind of slip '{name}'.", name=kind),
                did_you_mean(kind, known),
            )
    return kinds
