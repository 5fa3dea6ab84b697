"""What the command line can do with a course, a program can."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import gripcourse as gc
from gripcourse.cli.demo.students import correct
from gripcourse.course.load import load_course
from gripcourse.course.quantity import Kind
from gripcourse.errors import CourseError, TableError, UsageError
from gripcourse.grading.model import Outcome
from gripcourse.grading.self_check import State
from gripcourse.machine.resources import COURSE_FOLDERS, deadlines_path
from gripcourse.policy.model import Tells
from gripcourse.policy.time_rules import LateRule
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

SCHEME = "rack_parallelogram"
SMALL = Path(__file__).parents[1] / "variants" / "small_course"


@pytest.fixture(scope="module")
def handed_in(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """A right workbook and one with an early slip, as a web page would receive them."""
    folder = tmp_path_factory.mktemp("uploads")
    return {
        student: issued.hand_in(student, behaviour, folder / f"{student}.xlsx").read_bytes()
        for student, behaviour in (("s01", correct), ("s02", forget_one_jaw))
    }


class TestSolving:
    def test_a_variant_of_a_table_is_a_table_of_values(self, own: gc.Course, table: Path) -> None:
        values = own.solve("001", table=table)
        heads = ["id", "symbol", "title", "unit", "value", "kind", "section", "source"]
        assert list(values.columns) == heads
        by_id = values.set_index("id")
        assert by_id.loc["mass", "value"] == 60
        assert by_id.loc["grip_force", "unit"] == "N"
        assert values["value"].dtype == "float64"

    def test_a_scheme_is_solved_with_values_of_ones_own(self, own: gc.Course) -> None:
        """Guide §5: F = 1.3·900/(2·0.15) = 3900 N."""
        for gravity in (10, 10.0, "10", "10,0"):
            values = own.solve_scheme(SCHEME, given={"gravity": gravity}).set_index("id")
            assert values.loc["grip_force", "value"] == pytest.approx(3900)

    def test_titles_are_in_the_language_that_is_asked_for(self, own: gc.Course) -> None:
        found = {
            language: own.speaking(language).scheme_solution(SCHEME).values["grip_force"].title
            for language in ("en", "ru", "uk")
        }
        assert len(set(found.values())) == 3

    def test_each_value_is_told_with_what_it_is(self, own: gc.Course) -> None:
        solution = own.speaking("ru").scheme_solution(SCHEME, {"gravity": 10})
        assert (solution.scheme, solution.convention) == (SCHEME, "corrected")
        assert solution.to_dict()["values"]["grip_force"] == {
            "value": 3900.0,
            "unit": "N",
            "symbol": "F",
            "title": "усилие зажима (нормальная сила на одной губке)",
            "kind": "formula",
            "section": "grip",
            "source": {"work": "guide", "equation": "§5", "note": "K = 1,1…1,3 по формуле 2"},
        }
        assert solution.values["gravity"].kind is Kind.CONSTANT
        assert solution.values["mass"].kind is Kind.GIVEN
        assert "general_view_drawing" not in solution.values
        assert "θ_откр" in {one.symbol for one in solution.values.values()}

    def test_what_is_assumed_is_told(self, own: gc.Course) -> None:
        assert own.scheme_solution(SCHEME, {"grip_force": 4000}).assumed == ("grip_force",)

    def test_a_wrong_name_is_refused_by_its_parameter(self, own: gc.Course) -> None:
        with pytest.raises(UsageError, match=r"^given: mas: .*Did you mean 'mass'\?") as caught:
            own.solve_scheme(SCHEME, given={"mas": 60})
        assert caught.value.problems[0].parameter == "given"

    def test_what_is_chosen_by_name_must_be_known(self, own: gc.Course) -> None:
        with pytest.raises(UsageError, match=r"^convention: There is no convention 'gide'"):
            own.scheme_solution(SCHEME, convention="gide")
        with pytest.raises(UsageError, match=r"^language: There is no language 'de'"):
            own.speaking("de")


class TestReadersTakeBytes:
    def test_a_table_from_bytes_is_the_table_from_its_file(
        self, own: gc.Course, table: Path
    ) -> None:
        read = own.variants(table)
        assert own.variants(table.read_bytes()) == read
        assert own.variants(("mine.csv", table.read_bytes())) == read
        assert own.variants(str(table)) == read

    def test_a_bad_table_is_named_as_it_came(self, own: gc.Course) -> None:
        with pytest.raises(TableError, match=r"mine\.csv"):
            own.variants(("mine.csv", b""))

    def test_a_roster_from_bytes_is_issued_to(
        self, classroom: "Classroom", tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        # A real sheet takes longer than all the rest, and nobody reads this one.
        sheet = "gripcourse.usecases.issuing.handout.assignment_sheet"
        monkeypatch.setattr(sheet, lambda *_: b"%PDF-1.7\n")
        course = gc.Course(classroom.course, classroom.policy, "en")
        done = course.issue(
            b"student,name\na1,Anna\n", tmp_path / "out", table=classroom.order.table
        )
        (handout,) = done.handouts
        assert handout.faults == ()
        assert [Path(one).is_file() for one in handout.files] == [True, True]
        assert gc.IssueResult.from_dict(done.to_dict()) == done


class TestChecking:
    def test_bytes_are_checked_without_register_and_key(
        self, own: gc.Course, handed_in: dict[str, bytes], tmp_path: Path
    ) -> None:
        rule = replace(own.policy.check, tells=Tells.ANSWERS)
        telling = gc.Course(own.definition, replace(own.policy, check=rule), "en")
        checked = telling.check(handed_in["s02"], ledger=tmp_path / "checks", who="s02")
        states = {one.quantity: one.state for one in checked.answers}
        assert checked.refusal == ""
        assert states["grip_force"] is State.INCONSISTENT
        assert states["drive_force"] is State.CONSISTENT

    def test_which_answer_does_not_fit_is_told_only_where_the_policy_says_so(
        self, own: gc.Course, handed_in: dict[str, bytes]
    ) -> None:
        checked = own.check(handed_in["s02"])
        assert {one.state for one in checked.answers} <= {State.READ, State.BLANK}

    def test_a_foreign_file_is_no_exception(self, own: gc.Course) -> None:
        checked = own.check(b"not a workbook")
        assert "plain text" in checked.refusal
        assert checked.answers == ()

    def test_a_file_that_is_not_there_is_one(self, own: gc.Course, tmp_path: Path) -> None:
        with pytest.raises(gc.GripcourseError, match=r"no\.xlsx: There is no such file") as refused:
            own.check(tmp_path / "no.xlsx")
        assert isinstance(refused.value.__cause__, FileNotFoundError)


class TestGrading:
    def test_bytes_are_graded_and_nothing_is_written(
        self,
        own: gc.Course,
        handed_in: dict[str, bytes],
        tmp_path: Path,
        monkeypatch: pytest.MonkeyPatch,
    ) -> None:
        monkeypatch.chdir(tmp_path)
        files = [(f"{name}.xlsx", data) for name, data in handed_in.items()]
        graded = own.grade([*files, ("s03.xlsx", b"")])
        right, slipped, empty = graded.reports
        assert right.score == right.max_score
        first = next(one for one in slipped.findings if one.quantity == "grip_force")
        assert first.outcome is Outcome.SLIP
        assert (empty.student, empty.judged, empty.score) == ("s03", False, None)
        assert [flag.code for flag in empty.flags] == ["rejected"]
        assert graded.needs_person
        assert list(tmp_path.iterdir()) == []

    def test_what_cannot_be_used_is_refused_before_anything_is_graded(
        self, own: gc.Course, handed_in: dict[str, bytes], tmp_path: Path
    ) -> None:
        done: list[object] = []
        late = replace(own.policy, late=LateRule(0.1, 0.5, 0, "Europe/Kyiv"))
        course = replace(own, policy=late)
        table = deadlines_path(own.root)
        files, book = [("s01.xlsx", handed_in["s01"])], tmp_path / "book.sqlite"
        try:
            for row, said in ((",,some day", "some day"), (",s0l,2026-12-08", "no student 's0l'")):
                table.write_text(f"group,student,deadline\n{row}\n", encoding="utf-8")
                with pytest.raises(gc.GripcourseError, match=said):
                    course.grade(files, gradebook=book, on_done=done.append)
        finally:
            table.unlink()
        with pytest.raises(gc.GripcourseError, match="tomorrow"):
            course.grade(files, gradebook=book, handed_in=["tomorrow"], on_done=done.append)
        assert (done, book.exists()) == ([], False)

    def test_two_files_of_one_name_are_two(
        self, own: gc.Course, handed_in: dict[str, bytes]
    ) -> None:
        graded = own.grade([("answers.xlsx", data) for data in handed_in.values()])
        assert [one.student for one in graded.reports] == ["s01", "s02"]

    def test_a_name_that_another_s_workbook_contradicts_goes_to_a_person(
        self, own: gc.Course, handed_in: dict[str, bytes]
    ) -> None:
        files = [("group/s02.xlsx", handed_in["s01"])]
        (report,) = own.grade(files).reports
        assert (report.student, report.judged) == ("", False)
        (decided,) = own.grade(files, whose={"group/s02.xlsx": "s02"}).reports
        assert decided.student == "s02"
        assert "issued_to_other" in {flag.code for flag in decided.flags}

    def test_an_order_of_folders_of_one_s_own_says_whose_a_file_is(self, own: gc.Course) -> None:
        files = [("group 41/s02 - answers.txt.xlsx", b"no workbook")]
        assert [one.student for one in own.grade(files).reports] == [""]
        ordered = own.grade(files, pattern="group */{id} - *.xlsx")
        assert [one.student for one in ordered.reports] == ["s02"]
        with pytest.raises(gc.GripcourseError) as refused:
            own.grade(files, pattern=41)  # type: ignore[arg-type]
        assert [one.parameter for one in refused.value.problems] == ["pattern"]


class TestCourses:
    def test_a_folder_that_is_no_course_is_refused(self, tmp_path: Path) -> None:
        with pytest.raises(UsageError) as caught:
            gc.Course.load(tmp_path)
        assert caught.value.problems[0].step is gc.NextStep.MAKE_COURSE

    def test_what_cannot_be_loaded_can_be_validated(self, tmp_path: Path) -> None:
        for folder in COURSE_FOLDERS:
            (tmp_path / folder).mkdir()
        (tmp_path / "variants" / "course.toml").write_text("id = \n", encoding="utf-8")
        with pytest.raises(CourseError):
            gc.Course.load(tmp_path)
        found = gc.validate(tmp_path, "ru")
        assert not found.valid
        assert found.problems[0].file.endswith("course.toml")
        assert gc.ProblemsResult.from_dict(found.to_dict()) == found

    def test_variants_are_drawn_and_written_where_that_is_asked(
        self, own: gc.Course, tmp_path: Path
    ) -> None:
        out = tmp_path / "drawn.csv"
        small = gc.Course(load_course(SMALL), own.policy, "en")
        drawn = small.draw_variants(2, 1, freely=True, out=out)
        assert [one.id for one in drawn.variants] == ["001", "002"]
        assert small.draw_variants(2, 1, freely=True) == drawn
        assert small.variants(out).variants == drawn.variants
        assert gc.VariantsResult.from_dict(drawn.to_dict()) == drawn
