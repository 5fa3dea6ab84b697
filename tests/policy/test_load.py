"""The policy of a head of course: each fault is one problem."""

import re
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.model import Course
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import FigureRule, Policy, Reveal

if TYPE_CHECKING:
    from support.drafts import Draft

POLICY = "grader/policy.toml"
LEAST = "least = 0                 # told only where it is certain: a cell keeps 5,00 as 5\n"


@pytest.mark.parametrize(
    ("old", "new", "key", "what", "remedy"),
    [
        (
            "grip = 15",
            "grip = 20",
            "points.section",
            "add up to 105, the total is 100.",
            "Change a section or the total.",
        ),
        ("total = 100", 'total = "hundred"', "points.total", "wrong type", "a number"),
        (
            "general_view = 15",
            "general_view = 15\ngrips = 0",
            "points.section.grips",
            "The course has no section 'grips'.",
            "Did you mean 'grip'?",
        ),
        (
            "elements = 25\ngeneral_view = 15",
            "elements = 40",
            "points.section.general_view",
            "The section 'general_view' has no points.",
            "0 where it is not marked",
        ),
        (
            "scheme = 25\ndrive = 20",
            "scheme = 55\ndrive = -10",
            "points.section.drive",
            "The points are negative.",
            "0 or a positive number",
        ),
        (
            "relative = 0.01",
            "relative = -0.01",
            "tolerance.relative",
            "The tolerance −0.01 is negative.",
            "0 or a positive number",
        ),
        (
            "relative = 0.01",
            "relative = 0.06",
            "tolerance.relative",
            "With 0.06 here works that compute nothing earn points.",
            "Write at most 0.05.",
        ),
        (
            "calculated = 0.65",
            "calculated = 0.2",
            "credit.calculated",
            "With 0.2 here works that compute nothing earn points.",
            "Write at least 0.5.",
        ),
        (
            "figures = 3 ",
            "figures = 1 ",
            "rounding.figures",
            "With 1 here works that compute nothing earn points.",
            "Write at least 2.",
        ),
        (
            '"mm" = 0.01',
            '"mm" = -0.01',
            "tolerance.floor.mm",
            "The tolerance −0.01 is negative.",
            "0 or a positive number",
        ),
        (
            '"mm" = 0.01',
            '"mmm" = 0.01',
            "tolerance.floor.mmm",
            "The unit 'mmm' is not known.",
            "for example 'N*m'",
        ),
        (
            "rack_height = 0.25",
            "rack_hight = 0.25",
            "weight.quantity.rack_hight",
            "There is no 'rack_hight' in the course.",
            "Did you mean 'rack_height'?",
        ),
        (
            "rack_height = 0.25",
            "rack_height = -1",
            "weight.quantity.rack_height",
            "The weight −1 is negative.",
            "0 or a positive number",
        ),
        (
            "verdict = 0.5",
            "",
            "weight.kind.verdict",
            "This key is missing.",
            "the weight of a quantity of this kind",
        ),
        (
            "[credit]",
            "[quantity_tolerance.bor]\nrelative = 0.1\n[credit]",
            "quantity_tolerance.bor",
            "There is no 'bor' in the course.",
            "Did you mean 'bore'?",
        ),
        (
            "[credit]",
            "[quantity_tolerance.bore]\nfloor = 0.1\n[credit]",
            "quantity_tolerance.bore.floor",
            "This key means nothing here.",
            "",
        ),
        (
            "grip_force = 5",
            "grip_forse = 5",
            "points.quantity.grip_forse",
            "There is no 'grip_forse' in the course.",
            "Did you mean 'grip_force'?",
        ),
        (
            "grip_force = 5",
            "grip_force = 15",
            "points.quantity",
            "the main results of the section 'grip' have 15 points, the section has 15",
            "Leave points",
        ),
        ("carried = 1.0", "carried = 1.5", "credit.carried", "The share is 1.5.", "from 0 to 1"),
        ("carried = 1.0", 'carried = "all"', "credit.carried", "wrong type", "a number"),
        ("carried = 1.0", "", "credit.carried", "This key is missing.", "Write '"),
        (
            'reveal = "nothing"',
            'reveal = "noting"',
            "report.reveal",
            "There is no level 'noting'.",
            "Did you mean 'nothing'?",
        ),
        (
            "shared_points = 0.10",
            "shared_points = -0.10",
            "variants.shared_points",
            "The share is −0.1.",
            "from 0 to 1",
        ),
        (
            "shared_section_points = 0.50",
            "shared_section_points = 1.5",
            "variants.shared_section_points",
            "The share is 1.5.",
            "from 0 to 1",
        ),
        (
            "slip_bands = 2",
            "slip_bands = -1",
            "variants.slip_bands",
            "The number is −1.",
            "0 or more",
        ),
        ("steps_ratio = 2.5", "steps_ratio = 0.5", "variants.steps_ratio", "is 0.5", "1 or more"),
        ("weak_item = 0.25", "weak_item = 2", "variants.weak_item", "The share is 2.", "from 0"),
        (
            'keep_apart = ["declared"]',
            'keep_apart = ["declared", "gravity_left_off"]',
            "variants.keep_apart",
            "There is no kind of slip 'gravity_left_off'.",
            "Did you mean 'gravity_left_out'?",
        ),
        (
            "step_margin = 0.01",
            "step_margins = 0.01",
            "variants.step_margins",
            "This key means nothing here.",
            "Did you mean 'step_margin'?",
        ),
        ("most = 0", "most = -1", "figures.most", "The number is −1.", "from 0 on"),
        ("least = 0 ", "least = 2.5 ", "figures.least", "number is 2.5.", "a whole number"),
        (
            LEAST + "most = 0\n",
            "least = 3\nmost = 2\n",
            "figures.most",
            "At most 2 figures are fewer than at least 3.",
            "Write a larger number",
        ),
        ("credit = 1.0 ", "credit = 2 ", "figures.credit", "The share is 2.", "from 0 to 1"),
        ("least = 0 ", "leest = 0 ", "figures.leest", "means nothing here", "'least'"),
        (
            "odds = 1e3",
            "odds = 0.5",
            "likeness.odds",
            "Odds of 0.5 to one speak against copying.",
            "0 to look for nothing",
        ),
        ("odds = 1e3", "", "likeness.odds", "This key is missing.", "Write '"),
        ("answers = 3", "answers = 2.5", "likeness.answers", "number is 2.5", "a whole number"),
        ("answers = 3", "answer = 3", "likeness.answer", "means nothing here", "'answers'"),
        ("[report]", "[reports]", "reports", "This key means nothing here.", "'report'"),
    ],
)
def test_a_fault_of_the_policy_is_told_with_its_key(
    draft: "Draft", old: str, new: str, key: str, what: str, remedy: str
) -> None:
    problems = draft.edit(POLICY, old, new).problems()
    misspelt = {"reports": "report", "variants.step_margins": "variants.step_margin"}
    if key in misspelt:  # so another is missing
        assert [problem.key for problem in problems] == [key, misspelt[key]]
    else:
        assert len(problems) == 1, [str(problem.what) for problem in problems]
    assert (problems[0].file, problems[0].key) == (POLICY, key)
    assert what in str(problems[0].what)
    assert remedy in str(problems[0].remedy)


def test_a_missing_table_is_one_problem(draft: "Draft") -> None:
    text = (draft.root / POLICY).read_text(encoding="utf-8")
    draft.put(POLICY, re.sub(r"(?m)^\[credit\][^\[]*", "", text).encode())
    assert [problem.key for problem in draft.problems()] == ["credit"]


def test_printed_versions_can_be_refused(draft: "Draft") -> None:
    draft.edit(POLICY, "printed = 1.0", "printed = false")
    assert draft.problems() == ()


def test_points_of_the_sections_add_up(policy: Policy, course: Course) -> None:
    assert sum(policy.section_points.values()) == policy.total
    assert policy.section_points.keys() == {section.id for section in course.sections}


def test_the_reference_is_kept_from_students_unless_the_policy_reveals_it(policy: Policy) -> None:
    assert policy.reveal is Reveal.NOTHING


def test_a_policy_may_be_silent_about_figures_and_likeness(draft: "Draft", policy: Policy) -> None:
    text = (draft.root / POLICY).read_text(encoding="utf-8")
    start, end = text.index("[figures]"), text.index("[report]")
    draft.put(POLICY, (text[:start] + text[end:]).encode())
    silent = load_policy(draft.load())
    assert silent.figure_rule == FigureRule(0, 0, 1.0)
    assert silent.likeness == policy.likeness
