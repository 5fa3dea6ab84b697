"""Every declared free body is in equilibrium with what the course computes, for drawn variants."""

from pathlib import Path

import pytest

from gripcourse.proofs.equilibrium.trials import prove_equilibrium
from gripcourse.proofs.model import Verdict
from gripcourse.proofs.prove import Subject
from gripcourse.text.words import Words

FOLDER = Path(__file__).parents[2] / "variants" / "equilibrium"

# What the course does not compute as equilibrium has it yet; strict: what is corrected goes here.
OPEN = {
    "bayonet_electric": "the force of an electric drive inside the gripper loads the joint",
    "carrier_beam": "the offset of the load is left out",
    "contact_object": "friction of every component has the sign of the axial one; unequal angles",
    "contact_prism_finger": "friction of every component has the sign of the axial one",
    "contact_swinging_finger": "friction of every component has the sign of the axial one",
    "cups_combined": "what tilts the object is taken for what turns it",
    "cups_lift": "the most loaded cross-beam is taken for a mean one",
    "cups_sideways": "what tilts the object is taken for what turns it",
    "cups_vertical_combined": "what turns the object is taken for what tilts it",
    "link_lever": "the pivot is loaded more by the smallest object in some variants",
    "poles_lift": "the most loaded pole is taken for a mean one",
    "poles_shear": "the most loaded pole is taken for a mean one",
    "prism_lever": "both faces of a tilted prism are taken for equal",
    "prisms_across": "the prism is sized by the grip force",
    "rack_parallelogram": "the pins of the parallelogram are loaded by a couple",
    "tangent_slider_losses": "the worst of both ends are added up",
}


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(
            path.stem,
            marks=[pytest.mark.xfail(reason=OPEN[path.stem])] if path.stem in OPEN else [],
        )
        for path in sorted(FOLDER.glob("*.toml"))
    ],
)
def test_the_course_computes_what_equilibrium_gives(subject: Subject, name: str) -> None:
    [mechanism] = [one for one in subject.mechanisms if one.id == name]
    result = prove_equilibrium(mechanism, subject.source, None)
    words = Words("en")
    assert result.verdict is Verdict.HOLDS, "\n".join(one.say(words) for one in result.problems)
