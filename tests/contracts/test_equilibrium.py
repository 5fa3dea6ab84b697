"""Every declared free body is in equilibrium with what the course computes, for drawn variants.

Each claim is tried with one combination of options of every scheme that it is about;
`gripcourse validate --prove` tries more, and benchmarks/equilibrium.py thousands of variants.
"""

from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.proofs.equilibrium.check import load_mechanisms
from gripcourse.proofs.equilibrium.model import Mechanism
from gripcourse.proofs.equilibrium.trials import prove_equilibrium
from gripcourse.proofs.model import Verdict
from gripcourse.proofs.prove import Subject
from gripcourse.text.words import Words

FOLDER = Path(__file__).parents[2] / "variants" / "equilibrium"


@pytest.fixture(scope="module")
def mechanisms(course: Course) -> dict[str, Mechanism]:
    """Everything that the course declares, by name."""
    return {one.id: one for one in load_mechanisms(course)}


@pytest.mark.parametrize("name", [path.stem for path in sorted(FOLDER.glob("*.toml"))])
def test_the_course_computes_what_equilibrium_gives(
    subject: Subject, mechanisms: dict[str, Mechanism], name: str
) -> None:
    result = prove_equilibrium(mechanisms[name], subject.source, None, most=1)
    words = Words("en")
    assert result.verdict is Verdict.HOLDS, "\n".join(one.say(words) for one in result.problems)
