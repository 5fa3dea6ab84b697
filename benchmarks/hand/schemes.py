"""Which way a scheme is solved."""

from collections.abc import Callable, Mapping
from typing import Final

from hand.magnet import electromagnet
from hand.notebook import Notebook
from hand.pushed import link_lever, prism_lever, slot_crosshead, tangent_slider, wedge_roller
from hand.turned import screw, worm_sector
from hand.vacuum import vacuum_cups

SCHEMES: Final[Mapping[str, Callable[[Notebook], None]]] = {
    "screw": screw,
    "worm_sector": worm_sector,
    "tangent_slider": tangent_slider,
    "prism_lever": prism_lever,
    "slot_crosshead": slot_crosshead,
    "link_lever_3": link_lever,
    "wedge_roller_3": wedge_roller,
    "vacuum_cups": vacuum_cups,
    "electromagnet": electromagnet,
}
