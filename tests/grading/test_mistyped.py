"""A number whose digits were exchanged, lost or doubled in typing is wrong by itself alone."""

from collections.abc import Callable
from decimal import Decimal
from typing import TYPE_CHECKING

import pytest

from gripcourse.submission.model import Answer

if TYPE_CHECKING:
    from conftest import Case

Typed = Callable[[str, float, int], Answer]
SAID = "Digits may have been exchanged, lost or doubled when it was typed."


def _written(number: float, figures: int) -> str:
    return f"{number:.{figures - 1}e}"


def _exchanged(number: float) -> float:
    """Exchange the first two digits that differ, of four figures."""
    digits, power = _written(number, 4).split("e")
    signs = list(digits.replace(".", ""))
    place = next(at for at in range(3) if signs[at] != signs[at + 1])
    signs[place], signs[place + 1] = signs[place + 1], signs[place]
    return float(f"0.{''.join(signs)}e{int(power) + 1}")


def _lost(number: float) -> float:
    """Lose the second of five figures."""
    text = f"{Decimal(_written(number, 5)):f}"
    return float(text[0] + text[2:])


def _doubled(number: float) -> float:
    """Type the second of three figures twice."""
    digits, power = _written(number, 3).split("e")
    return float(f"{digits[:3]}{digits[2:]}e{power}")


@pytest.mark.parametrize("mistype", [_exchanged, _lost, _doubled])
def test_a_verdict_is_that_of_the_number_which_was_meant(
    hydraulic: "Case", typed: Typed, mistype: Callable[[float], float]
) -> None:
    """Nothing else is computed with the stress, so that its digits alone tell what was meant."""
    number = mistype(hydraulic.reference["bearing_stress"])
    otherwise = {**hydraulic.answers, "bearing_ok": 1 - hydraulic.reference["bearing_ok"]}
    for answers in (hydraulic.answers, otherwise):
        written = {**answers, "bearing_stress": typed("bearing_stress", number, 4)}
        stress = hydraulic.findings(written)["bearing_stress"]
        assert stress.points == 0
        assert SAID in map(str, stress.remarks)
    assert hydraulic.lost({**hydraulic.answers, "bearing_stress": written["bearing_stress"]}) == {
        "bearing_stress"
    }


def test_any_other_wrong_number_is_no_slip_of_the_fingers(hydraulic: "Case", typed: Typed) -> None:
    right = hydraulic.reference["bearing_stress"]
    said = 0
    for step in range(100):
        answer = typed("bearing_stress", float(f"{right * (1.31 + 0.013 * step):.4g}"), 4)
        finding = hydraulic.findings({**hydraulic.answers, "bearing_stress": answer})
        said += SAID in map(str, finding["bearing_stress"].remarks)
    assert said <= 1


def test_who_goes_on_with_it_makes_one_mistake_too(hydraulic: "Case", typed: Typed) -> None:
    number = _exchanged(hydraulic.reference["grip_force"])
    answers = hydraulic.following(grip_force=number)
    written = {**answers, "grip_force": typed("grip_force", number, 4)}
    assert hydraulic.lost(written) == {"grip_force"}


def test_a_number_of_two_figures_tells_nothing(hydraulic: "Case", typed: Typed) -> None:
    first, second = _written(hydraulic.reference["bearing_stress"], 2)[:3].split(".")
    power = int(_written(hydraulic.reference["bearing_stress"], 2).split("e")[1])
    number = float(f"{second}.{first}e{power}")
    answer = typed("bearing_stress", number, 2)
    finding = hydraulic.findings({**hydraulic.answers, "bearing_stress": answer})
    assert SAID not in map(str, finding["bearing_stress"].remarks)
