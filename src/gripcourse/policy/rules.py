"""Loading the policy's rules on figures and on likeness; a policy may be silent about either."""

from gripcourse.course.toml_table import Table
from gripcourse.policy.model import CheckRule, FigureRule, LikenessRule, Tells
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message


def read_figure_rule(table: Table | None) -> FigureRule:
    """Read how many figures answers should have; a policy that says nothing asks for nothing."""
    if table is None:
        return FigureRule(0, 0, 1.0)
    table.known_keys()
    least, most = (_whole(table, name) for name in ("least", "most"))
    if 0 < most < least:
        table.add(
            "most",
            message(
                "At most {most} figures are fewer than at least {least}.", most=most, least=least
            ),
            message("Write a larger number, or 0 for no bound."),
        )
    return FigureRule(least, most, table.share("credit", 1.0))


def read_likeness_rule(table: Table | None) -> LikenessRule:
    """Read when copying is suspected; a policy that says nothing has our defaults."""
    if table is None:
        return LikenessRule(1e3, 3, 3)
    table.known_keys()
    odds = table.number("odds")
    if odds != 0 and odds < 1:
        table.add(
            "odds",
            message("Odds of {odds} to one speak against copying.", odds=odds),
            message("Write a large number, for example 1e3, or 0 to look for nothing."),
        )
    answers, same_creator = _whole(table, "answers"), _whole(table, "same_creator")
    return LikenessRule(odds, answers, same_creator)


def read_check_rule(table: Table | None) -> CheckRule:
    """Read what a self-check tells; a policy that says nothing has our defaults."""
    if table is None:
        return CheckRule(Tells.SECTIONS, 3)
    table.known_keys()
    written, levels = table.text("tells"), list(Tells)
    if written not in levels:
        table.add(
            "tells",
            message("There is no level '{level}'.", level=written),
            did_you_mean(written, levels),
        )
    return CheckRule(Tells(written) if written in levels else Tells.READING, _whole(table, "times"))


def _whole(table: Table, name: str) -> int:
    value = table.number(name, 0.0)
    if value < 0 or value != int(value):
        table.add(
            name,
            message("The number is {value}.", value=value),
            message("Write a whole number from 0 on."),
        )
        return 0
    return int(value)
