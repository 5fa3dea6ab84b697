"""Mistakes in the steps that schemes share, and which mistakes belong to a scheme."""

from math import pi, sqrt
from typing import Final

from hand.mistakes_across import CYLINDERS_ACROSS, WEDGE_SLIDES
from hand.mistakes_fingers import LINKS, THREE, WEDGES
from hand.mistakes_frames import MAGNET, VACUUM
from hand.mistakes_geared import PARALLELOGRAMS, PINIONS
from hand.mistakes_pressed import PLATES, SLOT_LEVERS
from hand.mistakes_pushed import PRISMS, ROCKERS, SLOTS
from hand.mistakes_turned import SCREW, WORM
from hand.notebook import Notebook, cosine, sine
from hand.wrong import Mistake, mistake, row_below, row_beside, times

_GRIP: Final = (
    mistake(
        "grip: one jaw holds all",
        grip_force=lambda n, right: right * _jaws(n),
    ),
    mistake("grip: K or K_s left out", grip_force=lambda n, right: right / _factor(n)),
    mistake(
        "grip: sine and cosine of the load's angle exchanged",
        load_axial=lambda n, _: n["load"] * cosine(n["load_elevation"]) * sine(n["load_angle"]),
        load_normal=lambda n, _: n["load"] * cosine(n["load_elevation"]) * cosine(n["load_angle"]),
    ),
    mistake(
        "grip: the safety factor twice",
        grip_force=lambda n, right: right * n.get("safety_factor", 1.0),
    ),
    mistake(
        "grip: weight without inertia",
        lifting_load=lambda n, _: n["mass"] * n["gravity"],
    ),
    mistake("grip: kilograms taken for newtons", lifting_load=lambda n, _: n["mass"]),
)

_CYLINDER: Final = (
    mistake(
        "cylinder: efficiency multiplied",
        drive_force=lambda n, right: right * n["mechanism_efficiency"] ** 2,
    ),
    mistake(
        "cylinder: radius for the diameter",
        bore_required=lambda n, right: right if "bore_without_rod" in n else right / 2,
        bore_without_rod=times(0.5),
    ),
    mistake(
        "cylinder: its efficiency left out of the bore",
        bore_required=lambda n, right: (
            right if "bore_without_rod" in n else right * sqrt(n["cylinder_efficiency"])
        ),
        bore_without_rod=lambda n, right: right * sqrt(n["cylinder_efficiency"]),
    ),
    mistake(
        "cylinder: flow in litres a second",
        supply_flow=times(1 / 60),
    ),
    mistake(
        "cylinder: stroke as travel over the ratio",
        stroke_required=lambda n, _: n["jaw_travel"] / n["velocity_ratio"],
    ),
    mistake("cylinder: stroke one row too short", stroke=row_below("strokes of cylinders")),
    mistake(
        "cylinder: area with the radius squared left out",
        piston_area=lambda n, _: pi * n["bore"] / 4,
    ),
)

_JAWS: Final = (
    mistake(
        "jaws: mean of the moduli",
        reduced_modulus=lambda n, _: (n["elastic_modulus_jaw"] + n["elastic_modulus_object"]) / 2,
    ),
    mistake(
        "jaws: root of the contact stress left out",
        contact_stress=lambda n, right: (
            right**3 / n["contact_factor"] ** 2 if "contact_factor" in n else right**2 / 0.418
        ),
    ),
    mistake(
        "jaws: allowed stress not squared",
        jaw_width_required=lambda n, right: right * n["contact_stress_allowed"],
    ),
    mistake(
        "jaws: diameter for the radius of curvature",
        reduced_radius=times(2),
    ),
)

_LEVER: Final = (
    mistake(
        "lever: moment in N·mm",
        lever_bending_moment=times(1000),
    ),
    mistake("lever: six left out of the section", lever_thickness_required=times(1 / sqrt(6))),
    mistake(
        "lever: hole left out of the section",
        lever_stress=lambda n, _: (
            6000 * n["lever_bending_moment"] / (n["lever_width"] * n["lever_thickness_first"] ** 2)
        ),
    ),
    mistake(
        "pin: radius for the diameter",
        pin_diameter_required=times(0.5),
    ),
    mistake(
        "pin: one shear plane for two, or two for one",
        pin_diameter_required=lambda n, right: (
            right * sqrt(n["shear_planes"] / (3 - n["shear_planes"]))
        ),
    ),
    mistake(
        "pin: bearing on half the circumference",
        bearing_stress=times(2 / pi),
    ),
    mistake(
        "pin: one row too small",
        pin_diameter_first=row_below("diameters of pins"),
    ),
)

_MOUNT: Final = (
    mistake(
        "flange: K left out",
        mount_bending=lambda n, right: right / n["dynamic_factor"],
        mount_torque=lambda n, right: right / n["dynamic_factor"],
    ),
    mistake("flange: moment in N·mm", mount_bending=times(1000)),
    mistake(
        "flange: one row too small",
        flange_first=row_below("flanges of grippers", "nominal"),
    ),
    mistake(
        "flange: bolt circle of another row",
        flange_bolt_circle=row_beside("flanges of grippers", "bolt circle"),
    ),
    mistake("bayonet: load left out", mount_axial=lambda n, _: n["drive_force_actual"] / 1000),
    mistake(
        "cylinder: one bore long beside its stroke",
        drive_length=lambda n, right: n["stroke"] + n["bore"] if "bore" in n else right,
    ),
)

_LEVERS: Final = (*_CYLINDER, *_JAWS, *_LEVER, *_MOUNT)
_TURNED: Final = (*_JAWS, *_LEVER, *_MOUNT)

_OF_SCHEMES: Final = {
    "screw": (*SCREW, *_GRIP, *_TURNED),
    "worm_sector": (*WORM, *_GRIP, *_TURNED),
    "tangent_slider": (*ROCKERS, *_GRIP, *_LEVERS),
    "prism_lever": (*PRISMS, *_GRIP, *_LEVERS),
    "slot_crosshead": (*SLOTS, *_GRIP, *_LEVERS),
    "link_lever_3": (*LINKS, *THREE, *_GRIP, *_LEVERS),
    "wedge_roller_3": (*WEDGES, *THREE, *_GRIP, *_LEVERS),
    "link_lever_2": (*LINKS, *_GRIP, *_LEVERS),
    "wedge_roller": (*WEDGES, *_GRIP, *_LEVERS),
    "slot_lever": (*SLOT_LEVERS, *_GRIP, *_LEVERS),
    "plain_lever": (*PLATES, *_GRIP, *_LEVERS),
    "rack_parallelogram": (*PARALLELOGRAMS, *_GRIP, *_LEVERS),
    "pinion_racks": (*PINIONS, *_GRIP, *_LEVERS),
    "wedge_slide": (*WEDGE_SLIDES, *_GRIP, *_LEVERS),
    "cross_cylinder": (*CYLINDERS_ACROSS, *_GRIP, *_LEVERS),
    "vacuum_cups": VACUUM,
    "electromagnet": MAGNET,
}


def mistakes_of(scheme: str) -> tuple[Mistake, ...]:
    """Return the mistakes that are tried in a scheme."""
    return _OF_SCHEMES[scheme]


def _factor(n: Notebook) -> float:
    """Return the factor that a grip force has beside the load."""
    name = "safety_factor" if n.option("grip_model").startswith("contact") else "dynamic_factor"
    return n[name]


def _jaws(n: Notebook) -> float:
    """Return how many jaws hold by friction; 1 where other models count otherwise."""
    if n.option("grip_model") not in {"", "friction", "prism_along"}:
        return 1.0
    return n.get("finger_count", 2.0)
