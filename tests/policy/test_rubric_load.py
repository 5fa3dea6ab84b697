"""The rubrics of a head of course: what a person marks by, and each fault as one problem."""

from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.policy.model import Policy
from gripcourse.policy.rubric import Level
from gripcourse.text.words import LANGUAGES
from gripcourse.usecases.authoring.validate import validated

if TYPE_CHECKING:
    from support.drafts import Draft

RUBRIC = "grader/rubric/general_view.toml"
LEVELS = """\
[[line.level]]
credit = 0
text = { en = "none", ru = "нет", uk = "немає" }
[[line.level]]
credit = 0.5
text = { en = "some", ru = "часть", uk = "частина" }
[[line.level]]
credit = 1
text = { en = "all", ru = "все", uk = "усі" }
"""


class TestTheReferenceCourse:
    def test_every_manual_quantity_has_a_rubric_that_is_the_whole_item(
        self, course: Course, policy: Policy
    ) -> None:
        holders = (*course.parts.values(), *course.schemes.values())
        declared = [one for holder in holders for one in holder.quantities.values()]
        manual = [one for one in declared if one.kind is Kind.MANUAL]
        assert manual
        for quantity in manual:
            lines = policy.rubrics[quantity.rubric].lines
            assert sum(line.share for line in lines) == pytest.approx(1)

    def test_every_line_is_written_in_every_language(self, policy: Policy) -> None:
        for rubric in policy.rubrics.values():
            for text in (rubric.title, *(line.text for line in rubric.lines)):
                assert all(text.of(language).strip() for language in LANGUAGES)


class TestCredit:
    def test_full_lines_earn_the_whole_item_and_empty_ones_nothing(self, policy: Policy) -> None:
        for rubric in policy.rubrics.values():
            assert rubric.credit(dict.fromkeys(rubric.by_id, 1.0)) == pytest.approx(1)
            assert rubric.credit(dict.fromkeys(rubric.by_id, 0.0)) == 0

    def test_a_line_earns_by_its_share(self, policy: Policy) -> None:
        drawing = policy.rubrics["general_view"]
        credit = drawing.credit({"sizes": 0.5, "assembly": 1, "standards": 0})
        assert credit == pytest.approx(0.4 * 0.5 + 0.3)


class TestLevels:
    def test_a_line_may_have_levels(self, draft: "Draft", sound: Course) -> None:
        text = (draft.root / RUBRIC).read_text(encoding="utf-8")
        draft.put(RUBRIC, f"{text}\n{LEVELS}".encode())
        assert draft.problems_of_policy(sound) == ()

    def test_a_level_has_a_credit_and_a_text(self, draft: "Draft", sound: Course) -> None:
        from gripcourse.policy.load import load_policy  # noqa: PLC0415 (of this test only)

        text = (draft.root / RUBRIC).read_text(encoding="utf-8")
        draft.put(RUBRIC, f"{text}\n{LEVELS}".encode())
        levels = (
            load_policy(replace(sound, root=draft.root)).rubrics["general_view"].lines[-1].levels
        )
        assert [level.credit for level in levels] == [0, 0.5, 1]
        assert [level.text.of("uk") for level in levels] == ["немає", "частина", "усі"]
        assert all(isinstance(level, Level) for level in levels)

    def test_levels_that_never_earn_the_whole_line_are_refused(
        self, draft: "Draft", sound: Course
    ) -> None:
        text = (draft.root / RUBRIC).read_text(encoding="utf-8")
        levels = LEVELS.replace("credit = 1\n", "credit = 0.75\n")
        problem = draft.put(RUBRIC, f"{text}\n{levels}".encode()).problem_of_policy(sound)
        assert (problem.file, problem.key) == (RUBRIC, "line[3].level")
        assert str(problem.what) == "No level earns the whole line."

    def test_two_levels_of_one_credit_are_refused(self, draft: "Draft", sound: Course) -> None:
        text = (draft.root / RUBRIC).read_text(encoding="utf-8")
        levels = LEVELS.replace("credit = 0.5", "credit = 1")
        problem = draft.put(RUBRIC, f"{text}\n{levels}".encode()).problem_of_policy(sound)
        assert (problem.file, problem.key) == (RUBRIC, "line[3].level")
        assert str(problem.what) == "Two levels have the credit 1."


@pytest.mark.parametrize(
    ("old", "new", "key", "said"),
    [
        ("share = 0.4", "share = 0.5", "line", ("add up to 1.1, not to 1", "Change a share")),
        ("share = 0.4", "", "line[1].share", ("This key is missing.", "Write '")),
        ("share = 0.4", 'share = "most"', "line[1].share", ("wrong type", "a number")),
        ('id = "sizes"', "", "line[1].id", ("This key is missing.", "Write '")),
        ('id = "sizes"', 'id = "Размеры"', "line[1].id", ("is no id", "lower-case Latin letters")),
        ('id = "sizes"', 'id = "points"', "line[1].id", ("column of the table", "another name")),
        ('id = "assembly"', 'id = "sizes"', "line[2].id", ("Two lines have the id", "of its own")),
        ("share = 0.4", "shar = 0.4\nshare = 0.4", "line[1].shar", ("means nothing", "'share'?")),
        (', uk = "Креслення загального вигляду"', "", "title.uk", ("missing", "en, ru, uk")),
        ("[[line]]", "[[lines]]", "lines", ("This key means nothing here.", "'line'?")),
    ],
)
def test_a_fault_of_a_rubric_is_told_with_file_and_key(
    draft: "Draft", sound: Course, old: str, new: str, key: str, said: tuple[str, str]
) -> None:
    what, remedy = said
    problems = draft.edit(RUBRIC, old, new).problems_of_policy(sound)
    if old == "[[line]]":  # a line is lost with it, and its share is missing
        assert [problem.key for problem in problems] == ["lines", "line"]
    else:
        assert len(problems) == 1, [str(problem.what) for problem in problems]
    assert (problems[0].file, problems[0].key) == (RUBRIC, key)
    assert what in str(problems[0].what)
    assert remedy in str(problems[0].remedy)


@pytest.mark.parametrize("lines", ["", "line = []"])
def test_a_rubric_without_lines_is_refused_by_validate(draft: "Draft", lines: str) -> None:
    title = 'title = { en = "Drawing", ru = "Чертёж", uk = "Креслення" }'
    draft.put(RUBRIC, f"{title}\n{lines}".encode())
    (problem,) = (one for one in validated(draft.root).problems if one.file == RUBRIC)
    assert (problem.file, problem.key) == (RUBRIC, "line")
    assert str(problem.what) == "The rubric has no lines."
    assert "[[line]]" in str(problem.remedy)


@pytest.mark.parametrize("share", ["0", "-0.4", "1.4"])
def test_a_share_that_is_none_is_refused(draft: "Draft", sound: Course, share: str) -> None:
    problems = draft.edit(RUBRIC, "share = 0.4", f"share = {share}").problems_of_policy(sound)
    assert (problems[0].file, problems[0].key) == (RUBRIC, "line[1].share")
    assert "above 0, at most 1" in str(problems[0].remedy)


def test_a_rubric_that_is_no_toml_is_one_problem(draft: "Draft", sound: Course) -> None:
    problem = draft.put(RUBRIC, b"title = {").problem_of_policy(sound)
    assert problem.file == RUBRIC
    assert "A bracket" in str(problem.what)


def test_faults_of_all_rubrics_come_with_those_of_the_policy(draft: "Draft", sound: Course) -> None:
    draft.edit(RUBRIC, "share = 0.4", "share = 0.5")
    draft.edit("grader/rubric/kinematic_diagram.toml", "share = 0.4", "share = 0.3")
    draft.edit("grader/policy.toml", "carried = 1.0", "carried = 2.0")
    files = [problem.file for problem in draft.problems_of_policy(sound)]
    assert files == [RUBRIC, "grader/rubric/kinematic_diagram.toml", "grader/policy.toml"]


def test_a_manual_quantity_without_the_name_of_a_rubric_is_refused(draft: "Draft") -> None:
    part = "variants/sections/drawings.toml"
    problem = draft.edit(part, 'rubric = "general_view"', 'rubric = ""').problem()
    assert (problem.file, problem.key) == (part, "quantity.general_view_drawing.rubric")
    assert "grader/rubric" in str(problem.remedy)
