"""Names of slips: one way to write them, one to read them."""

import pytest

from gripcourse.policy.slips import DECLARED, SlipKind
from gripcourse.slips.model import USED, SlipId


@pytest.mark.parametrize("kind", [*SlipKind, USED])
def test_what_was_written_is_read_again(kind: str) -> None:
    slip = SlipId(kind, "mm>cm")
    assert str(slip) == f"{kind}:mm>cm"
    assert SlipId.parse(str(slip)) == slip


def test_a_declared_slip_stands_under_its_own_id() -> None:
    slip = SlipId.declared("one_jaw_only")
    assert (str(slip), slip.kind) == ("one_jaw_only", DECLARED)
    assert SlipId.parse("one_jaw_only") == slip


def test_a_number_used_wrongly_names_its_quantity() -> None:
    assert SlipId.parse("used:mass") == SlipId.used("mass")
    assert SlipId.used("mass").detail == "mass"
