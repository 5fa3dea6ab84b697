"""The generic slips of a head of course: each fault is one problem, with its key and a remedy."""

from typing import TYPE_CHECKING

import pytest

from gripcourse.policy.model import Policy
from gripcourse.policy.slips import SlipKind

if TYPE_CHECKING:
    from support.drafts import Draft

SLIPS = "grader/slips.toml"


@pytest.mark.parametrize(
    ("old", "new", "key", "what", "remedy"),
    [
        (
            "[kind.sign]",
            "[kind.sing]",
            "kind.sing",
            "There is no kind of slip 'sing'.",
            "Did you mean 'sign'?",
        ),
        ("certain = 0.9", "certain = 1.5", "naming.certain", "The number is 1.5.", "below 1"),
        ("tie = 4.0", "tie = 1.0", "naming.tie", "The number is 1.", "a number above 1"),
        ("spread = 1.5", "spread = 0", "naming.spread", "The number is 0.", "a number above 0"),
        (
            "prior = 6.0\ncredit = 0.5",
            "prior = -6.0\ncredit = 0.5",
            "kind.unit.prior",
            "The number is −6.",
            "a number above 0",
        ),
        (
            "prior = 6.0\ncredit = 0.5",
            "prior = 6.0\ncredit = 2",
            "kind.unit.credit",
            "The share is 2.",
            "from 0 to 1",
        ),
        (
            '"kgf", "Pa"',
            '"kilogram-force", "Pa"',
            "kind.unit.units",
            "The unit 'kilogram-force' is not known.",
            "gripcourse schema",
        ),
        (
            "The value is in {unit}; it is asked for in {asked}.",
            "The value is in {unti}; it is asked in {asked}.",
            "kind.unit.hint.en",
            "a place 'unti' that nothing fills",
            "Did you mean 'unit'?",
        ),
        (
            '[["_at_min", "_at_max"],',
            '[["_at_min"],',
            "kind.wrong_end.pairs",
            "wrong type",
            "pairs of endings",
        ),
        ('title = { en = "a sign", ', "title = { ", "kind.sign.title.en", "missing", "all of en"),
        ("[naming]", "[names]", "names", "This key means nothing here.", "naming"),
    ],
)
def test_a_fault_of_the_slips_is_told_with_its_key(
    draft: "Draft", old: str, new: str, key: str, what: str, remedy: str
) -> None:
    problems = draft.edit(SLIPS, old, new).problems()
    if key == "names":  # the table is misspelt, so another is missing
        assert [problem.key for problem in problems] == ["names", "naming"]
    else:
        assert len(problems) == 1, [str(problem.what) for problem in problems]
    assert (problems[0].file, problems[0].key) == (SLIPS, key)
    assert what in str(problems[0].what)
    assert remedy in str(problems[0].remedy)


def test_a_course_without_the_file_is_told_so(draft: "Draft") -> None:
    problem = draft.remove(SLIPS).problem()
    assert (problem.file, str(problem.what)) == (SLIPS, "The file is missing.")


def test_a_kind_may_be_left_out(draft: "Draft") -> None:
    text = (draft.root / SLIPS).read_text(encoding="utf-8")
    draft.put(SLIPS, text[: text.index("[kind.other_row]")].encode())
    assert draft.problems() == ()


def test_the_course_looks_for_every_kind(policy: Policy) -> None:
    assert policy.slips.kinds.keys() == set(SlipKind)


@pytest.mark.parametrize(
    ("old", "new", "key", "what"),
    [
        ("last_digit = 1.0", "last_digit = -1", "rounding.last_digit", "The number is −1."),
        ("figures = 3", "figures = 0", "rounding.figures", "The number is 0."),
        ("gravity = [9.8, 10]", "gravty = [9.8]", "rounding.habits.gravty", "means nothing here"),
        ("pi = [3.14]", "pi = 3.14", "rounding.habits.pi", "wrong type"),
        ("widest = 40", 'widest = "wide"', "rounding.widest", "wrong type"),
    ],
)
def test_a_fault_of_the_rounding_rules_is_told_with_its_key(
    draft: "Draft", old: str, new: str, key: str, what: str
) -> None:
    problem = draft.edit("grader/policy.toml", old, new).problem()
    assert problem.key == key
    assert what in str(problem.what)


def test_shortened_constants_are_read_in_the_unit_of_the_constant(policy: Policy) -> None:
    assert policy.habits == {"pi": (3.14,), "gravity": (9.8, 10.0)}


@pytest.mark.parametrize(
    "same",
    ["grip_force*force_ratio/mechanism_efficiency", "force_ratio*grip_force/mechanism_efficiency"],
)
def test_a_slip_that_computes_the_right_value_is_refused(draft: "Draft", same: str) -> None:
    problem = draft.edit(
        "variants/sections/drive_force.toml", "grip_force*force_ratio*mechanism_efficiency", same
    ).problem()
    assert problem.key == "quantity.drive_force.slip.efficiency_multiplied"
    assert str(problem.what) == "The slip equals the right formula."
