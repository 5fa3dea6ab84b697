"""Bodies that stand in each other: a check of shapes is handed in, and refuses variants."""

from collections.abc import Mapping

import numpy as np
import pytest

from gripcourse.cli.text import audit_text
from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.text.words import LANGUAGES, Texts, Words
from gripcourse.usecases.solving.audit import WrittenAudit
from gripcourse.variants.audit import audit
from gripcourse.variants.draw import draw
from gripcourse.variants.feasible import Array
from gripcourse.variants.overlaps import Overlap
from gripcourse.variants.screening import sifter
from gripcourse.variants.space import load_spaces

HEAVY = 20.0  # kg
OPEN = Texts(dict.fromkeys(LANGUAGES, "open"))
WEDGE, OBJECT = (Texts(dict.fromkeys(LANGUAGES, one)) for one in ("wedge", "object"))


def deep(scheme: str, values: Mapping[str, Array]) -> list[Overlap | None]:
    """Let heavy objects reach into the wedge."""
    assert scheme == "screw"
    assert np.isfinite(values["mass"]).all()
    return [
        Overlap((WEDGE, OBJECT), OPEN, float(one) / 10) if one > HEAVY else None
        for one in values["mass"]
    ]


def test_candidates_with_overlapping_bodies_are_not_drawn(course: Course, policy: Policy) -> None:
    spaces = [one for one in load_spaces(course) if one.scheme == "screw"]
    drawn = draw(course, spaces, 6, 5, sifter(policy, len(course.sections), deep))
    assert all(one.given["mass"] <= HEAVY for one in drawn.variants)
    (tally,) = drawn.tallies
    (told,) = (one for one in tally.set_aside if "wedge" in str(one.what))
    assert str(told.what) == "wedge and object stand in each other"
    assert told.count > 0


@pytest.mark.usefixtures("few_slips_counted")
def test_an_audit_names_the_worst_pair_of_bodies(course: Course, policy: Policy) -> None:
    spaces = [one for one in load_spaces(course) if one.scheme == "screw"]
    variants = draw(course, spaces, 12, 5).variants
    found = audit(course, policy, variants, spaces, deep)
    heavy = [one for one in found.variants if one.variant.given["mass"] > HEAVY]
    assert heavy
    assert [one for one in found.variants if one.overlap is not None] == heavy
    assert not any(one.passed for one in heavy)
    assert found.overlaps == len(heavy)
    assert audit(course, policy, variants, spaces).overlaps is None


@pytest.mark.usefixtures("few_slips_counted")
def test_of_bodies_the_audit_speaks_only_where_some_were_looked_at(
    course: Course, policy: Policy
) -> None:
    spaces = [one for one in load_spaces(course) if one.scheme == "screw"]
    found = audit(
        course,
        policy,
        draw(course, spaces, 4, 5).variants,
        spaces,
        lambda _, v: [None] * len(v["mass"]),
    )
    said = [audit_text(WrittenAudit("t.csv", found, (), tested), Words("en")) for tested in (0, 3)]
    assert "bodies" not in said[0]
    assert "No bodies stand in each other; variants looked at: 3." in said[1]
