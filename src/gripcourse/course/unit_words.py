"""What to write instead of a unit that the table of units does not have."""

from gripcourse.text.units import read_unit
from gripcourse.text.words import Message, message


def unit_remedy(unit: str) -> Message:
    """Return our spelling of a unit, where a person would understand it; else where to look."""
    meant = read_unit(unit)
    if meant:
        return message("Write '{unit}': declarations spell units so.", unit=meant)
    return message("Write it as on the page that 'gripcourse schema' makes, for example 'N*m'.")
