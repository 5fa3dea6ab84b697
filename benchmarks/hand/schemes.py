"""Which way a scheme is solved."""

from collections.abc import Callable, Mapping
from typing import Final

from hand.geared import cross_cylinder, pinion_racks, rack_parallelogram, wedge_slide
from hand.magnet import electromagnet
from hand.notebook import Notebook
from hand.pressed import plain_lever, slot_lever
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
    "link_lever_2": link_lever,
    "wedge_roller": wedge_roller,
    "slot_lever": slot_lever,
    "plain_lever": plain_lever,
    "rack_parallelogram": rack_parallelogram,
    "pinion_racks": pinion_racks,
    "wedge_slide": wedge_slide,
    "cross_cylinder": cross_cylinder,
    "vacuum_cups": vacuum_cups,
    "electromagnet": electromagnet,
}
