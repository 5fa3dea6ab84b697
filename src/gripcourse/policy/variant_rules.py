"""Reading what a policy demands of variants: the table `[variants]` of `grader/policy.toml`."""

from gripcourse.course.toml_table import Table
from gripcourse.policy.model import VariantRules
from gripcourse.policy.slips import DECLARED, SlipKind
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

_SHARES = ("shared_points", "shared_section_points", "step_margin", "weak_item")


def read_variant_rules(table: Table) -> VariantRules:
    """Read the rules for variants; every fault goes to the table's list of problems."""
    table.known_keys()
    shared, section, margin, weak = (table.share(name) for name in _SHARES)
    return VariantRules(
        shared_points=shared,
        shared_section_points=section,
        slip_bands=table.at_least("slip_bands", 0.0),
        keep_apart=_kinds(table),
        step_margin=margin,
        steps_ratio=table.at_least("steps_ratio", 1.0),
        weak_item=weak,
    )


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
