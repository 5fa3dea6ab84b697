"""What to write instead of a unit that the table of units does not have."""

import re
from typing import Final

from gripcourse.text.units import known, read_unit
from gripcourse.text.words import Message, message

_BELOW: Final = re.compile(r"/\(([^()]*)\)")
_TIMES: Final = re.compile(r"(?<!\*)\*(?!\*)")
_OF_THERMOMETERS: Final = re.compile(r"[°º] ?[CFС]|℃|℉|deg_?[CF]|[Cc]elsius|[Ff]ahrenheit")


def unit_remedy(unit: str) -> Message:
    """Return our spelling of a unit, where a person would understand it; else where to look."""
    meant = read_unit(unit)
    if _OF_THERMOMETERS.search(unit):
        return message("Write 'degC' for a temperature, 'K' for a difference of two.")
    meant = meant or _without_brackets(unit)
    if meant:
        return message("Write '{unit}': declarations spell units so.", unit=meant)
    return message("Write it as on the page that 'gripcourse schema' makes, for example 'N*m'.")


def _without_brackets(unit: str) -> str | None:
    """Return `W/m**2/K` for `W/(m**2*K)`, None for what is no unit without brackets either."""
    plain = _BELOW.sub(lambda found: "/" + _TIMES.sub("/", found[1]), unit)
    return plain if known(plain) else None
