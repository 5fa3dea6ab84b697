"""Mistakes in the steps of suction cups and of electromagnets on a beam."""

from math import log10, pi, sqrt
from typing import Final

from hand.notebook import Notebook
from hand.wrong import Mistake, mistake, row_below, row_beside, times

_EJECTORS = "single-stage vacuum ejectors"


def _spread(n: Notebook) -> float:
    """Return what an offset adds to the share of the outermost cup, by the pull."""
    return n["load_offset"] * n["cup_x"] / (1e6 * n["tilt_square_sum"])


_BEAM: Final[tuple[Mistake, ...]] = (
    mistake(
        "beam: load in the middle, a quarter of the length",
        beam_moment=lambda n, right: right + n["lifting_load"] * n["object_length"] / 8000,
    ),
    mistake(
        "beam: offset left out",
        beam_moment=lambda n, _: n["lifting_load"] * n["object_length"] / 8000,
    ),
    mistake("beam: six left out of the section", beam_height_by_strength=times(1 / sqrt(6))),
    mistake(
        "beam: height not cubed",
        beam_deflection=lambda n, right: right * n["beam_height_first"] ** 2,
    ),
    mistake("beam: root for the cube root", beam_height_by_stiffness=lambda _, right: right**1.5),
    mistake("flange: moment in N·mm", mount_bending=times(1000)),
    mistake("flange: one row too small", flange_first=row_below("flanges of grippers", "nominal")),
    mistake(
        "flange: bolt circle of another row",
        flange_bolt_circle=row_beside("flanges of grippers", "bolt circle"),
    ),
    mistake("safety factor left out", holding_force=lambda n, right: right / n["safety_factor"]),
    mistake("safety factor twice", holding_force=lambda n, right: right * n["safety_factor"]),
    mistake("weight without inertia", lifting_load=lambda n, _: n["mass"] * n["gravity"]),
    mistake(
        "thickness of the plate in cm",
        mass=lambda n, right: right if "mass" in n.sheet.given else right / 10,
    ),
)

VACUUM: Final[tuple[Mistake, ...]] = (
    mistake(
        "friction multiplied",
        holding_force=lambda n, right: (
            right + n["safety_factor"] * n["shear_load"] * (n["friction"] - 1 / n["friction"])
            if "shear_load" in n
            else right
        ),
    ),
    mistake(
        "pitch by the gaps",
        cup_pitch_x=lambda n, _: n["object_length"] / max(n["cup_columns"] - 1, 1),
    ),
    mistake("all cups at the outermost distance", cup_x=lambda n, _: n["object_length"] / 2),
    mistake(
        "one row in the sum of squares", tilt_square_sum=lambda n, right: right / n["cup_rows"]
    ),
    mistake("offset left out of the share", tilt_share=lambda n, _: 1 / n["cup_count"]),
    mistake(
        "twice the offset in the share", tilt_share=lambda n, _: 1 / n["cup_count"] + 2 * _spread(n)
    ),
    mistake(
        "millibars for kPa", atmospheric_pressure=lambda n, _: 101.325 - 12.5 * n["altitude"] / 100
    ),
    mistake("radius for the diameter of the cups", cup_diameter_required=times(0.5)),
    mistake("cups one row too small", cup_diameter_first=row_below("diameters of suction cups")),
    mistake("one cup for all", holding_force_actual=lambda n, right: right / n["cup_count"]),
    mistake("suction of one cup", suction_flow=lambda n, right: right / n["cup_count"]),
    mistake("nozzle of another row", ejector_nozzle=row_below(_EJECTORS, "nozzle")),
    mistake("litres a minute taken as litres a second", hose_bore_required=times(sqrt(60))),
    mistake("cylinder for the cone of a cup", cup_volume=times(3)),
    mistake(
        "hose left out of the volume",
        evacuated_volume=lambda n, _: n["cup_count"] * n["cup_volume"],
    ),
    mistake(
        "decimal logarithm",
        evacuation_time_ideal=lambda n, _: (
            n["evacuated_volume"]
            * 60
            / (1000 * n["ejector_suction"])
            * log10(n["atmospheric_pressure"] / n["residual_pressure"])
        ),
    ),
    mistake("half the width of the cross-beam", cross_moment=times(2)),
    mistake("area of cups by their radius", cup_area_required=times(0.25)),
    *_BEAM,
)


def _gap(n: Notebook) -> float:
    return n["air_gap"] + n["iron_path"] / n["permeability"]


MAGNET: Final[tuple[Mistake, ...]] = (
    mistake("one gap of two", equivalent_gap=lambda n, _: _gap(n)),
    mistake("steel left out of the circuit", equivalent_gap=lambda n, _: 2 * n["air_gap"]),
    mistake("one pole to a magnet", pole_count=times(0.5)),
    mistake("factor two left out of the pull", pole_area_required=times(0.5)),
    mistake(
        "flux density not squared",
        pole_force_first=lambda n, right: right / n["flux_density_design"],
    ),
    mistake("radius for the diameter of the core", core_diameter_required=times(0.5)),
    mistake("core one row too small", core_diameter_first=row_below("Ra10")),
    mistake("offset left out of the share", pole_share=lambda n, _: 1 / n["pole_count"]),
    mistake("middles of the magnets for the poles", outer_pole_x=lambda n, _: n["magnet_x"]),
    mistake("turns round the core", turn_length=lambda n, _: pi * n["core_diameter"]),
    mistake("turn in mm beside Ω·mm²/m", wire_area_required=times(1000)),
    mistake("radius for the diameter of the wire", wire_diameter_required=times(0.5)),
    mistake("wire one row too small", wire_diameter=row_below("diameters of winding wire")),
    mistake(
        "current times resistance squared",
        coil_power=lambda n, _: n["coil_current"] * n["coil_resistance"] ** 2,
    ),
    mistake("power of one magnet", total_power=lambda n, _: n["coil_power"]),
    mistake("all turns on one coil", coil_height=times(2)),
    mistake("surface of one coil", cooling_surface=times(0.5)),
    mistake(
        "duty factor left out", temperature_rise=lambda n, right: right * 100 / n["duty_factor"]
    ),
    mistake(
        "area of the pole by its radius left out",
        pole_area=lambda n, _: pi * n["core_diameter"] ** 2,
    ),
    mistake("force of one pole for all", holding_force_actual=lambda n, _: n["pole_force"]),
    mistake("whole edge of the pole", plate_thickness_required=times(0.5)),
    *_BEAM,
)
