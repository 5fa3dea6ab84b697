"""What courses were written with for earlier versions of the program, by what it is called now.

Whoever comes with such a course is told so, and `renew` writes it as it is read today. The first
versions knew one subject, so that words of it stand here and nowhere else in the program.
"""

from typing import Final

from gripcourse.course.shape import Former

EXAMPLE: Final = {"guide": Former("as_printed")}
KINEMATICS: Final = {
    # What moved was taken to fall; its direction is declared now.
    "jaw": Former("output", {"direction": "falls"}),
    "jaws": Former("outputs"),
}
ATLAS_ROW: Final = {one: Former(f"size.{one}") for one in ("inclination", "diameter")}
VIEW: Final = {"uses": Former("behind")}
VIEW_PART: Final = {"density_per": Former("")}  # the mass takes the density of the part's material
ELEMENTS: Final = {
    "end_view": {"at": Former(""), "shift": Former("")},  # it stands where there is room
}
ELEMENT_KINDS: Final = {"jaw": "contact", "prism": "vee"}
