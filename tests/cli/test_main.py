"""The command line end to end: what it prints, what it leaves behind, and its exit code."""

import json
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from gripcourse.api.results import SolutionResult
from gripcourse.cli import main as cli
from gripcourse.cli.options import NEEDS_PERSON
from gripcourse.machine.database.home import gradebook_path
from support.command_line import Run, call
from support.pages import no_pages

REPOSITORY = Path(__file__).parents[2]
SCHEME = "rack_parallelogram"
ROSTER = """\
student,name,group,email,language,variant
s01,Иванова Анна,РТК-41,,ru,
s02,Шевченко Оксана,РТК-41,,uk,007
"""


Command = Callable[..., Run]


@pytest.fixture(scope="module", autouse=True)
def _no_pages() -> Iterator[None]:
    with no_pages():
        yield


@pytest.fixture
def gripcourse(tmp_path: Path) -> Command:
    """Call the command line in an empty folder, speaking English."""

    def run(*arguments: object, home: Path = tmp_path, system: str = "C") -> Run:
        return call(home, *arguments, system=system)

    return run


@pytest.fixture
def course(gripcourse: Command, tmp_path: Path) -> Path:
    """A course of one's own with a small roster."""
    root = tmp_path / "course"
    assert gripcourse("init", root).code == 0
    (root / "variants" / "roster.csv").write_text(ROSTER, encoding="utf-8")
    return root


@dataclass(frozen=True, slots=True)
class Term:
    """A folder with a course, its handed out assignments and one graded work, and what was said."""

    folder: Path
    issued: Run
    graded: Run

    def again(self, folder: Path) -> "Term":
        """Copy the folder for a story of its own."""
        shutil.copytree(self.folder, folder, dirs_exist_ok=True)
        return Term(folder, self.issued, self.graded)

    @property
    def own(self) -> Path:
        """The workbook that was handed out to the first student."""
        return self.folder / "assignments" / "s01" / "s01.xlsx"

    @property
    def place(self) -> tuple[object, ...]:
        return ("--course", self.folder / "course", "--workers", 0, "--date", "2026-09-07")


@pytest.fixture(scope="module")
def term(tmp_path_factory: pytest.TempPathFactory) -> Term:
    """Issue to two students and grade a workbook in which nothing is written, once."""
    folder = tmp_path_factory.mktemp("term")
    assert call(folder, "init", folder / "course").code == 0
    roster = folder / "course" / "variants" / "roster.csv"
    roster.write_text(ROSTER, encoding="utf-8")
    nothing = Run(0, "", "")
    begun = Term(folder, nothing, nothing)
    out = folder / "assignments"
    issued = call(folder, "issue", *begun.place, "--roster", roster, "--out", out)
    graded = call(folder, "grade", *begun.place, begun.own, "--out", folder / "graded", "--json")
    return Term(folder, issued, graded)


def table_with(course: Path, column: str, value: str) -> Path:
    """Change a cell of the first variant of the main table."""
    rows = (course / "variants" / "tables" / "main.csv").read_text(encoding="utf-8-sig")
    cells = [row.split(",") for row in rows.splitlines()]
    cells[1][cells[0].index(column)] = value
    table = course.parent / "changed.csv"
    table.write_text("\n".join(",".join(row) for row in cells) + "\n", encoding="utf-8")
    return table


def left_behind(folder: Path, but: Sequence[str] = ()) -> set[str]:
    return {path.name for path in folder.iterdir()} - set(but)


def refused(run: Run, *said: str) -> None:
    """Check that a call was refused with one line that says all of this."""
    assert run.code == cli.WRONG_USE
    assert len(run.problems) == 1, run.err
    assert all(part in run.problems[0] for part in said), run.err
    assert "Traceback" not in run.out + run.err
    assert not run.problems[0].startswith(":")


class TestHappyPaths:
    def test_the_reference_course_is_valid(self, gripcourse: Command) -> None:
        run = gripcourse("validate")
        assert (run.code, run.out.strip()) == (0, "The course is valid.")

    def test_a_variant_is_solved_as_json(self, gripcourse: Command) -> None:
        run = gripcourse("solve", "001", "--json")
        plain = json.loads(run.out)
        values = plain["values"]
        assert SolutionResult.from_dict(plain).variant == "001"
        assert run.code == 0
        assert values["lifting_load"]["unit"] == "N"
        assert values["lifting_load"]["value"] > 0

    def test_the_guides_example_is_solved_with_values_set_by_hand(
        self, gripcourse: Command
    ) -> None:
        """Guide §5: F = 1.3·900/(2·0.15) = 3900 N."""
        run = gripcourse("solve", "--scheme", SCHEME, "--set", "gravity=10", "--json")
        assert json.loads(run.out)["values"]["grip_force"]["value"] == pytest.approx(3900)

    def test_the_reference_is_written_in_english_unless_told_otherwise(
        self, gripcourse: Command, tmp_path: Path
    ) -> None:
        # The course with the fewest schemes: one page of each takes half a second.
        course = ("--course", REPOSITORY / "examples" / "belt_drive")
        run = gripcourse("reference", *course, "--out", "pages", system="ru_RU.UTF-8")
        pages = {path.name: path for path in (tmp_path / "pages").iterdir()}
        assert run.code == 0
        assert {"index.html", "flat_belt.html", "v_belt.html"} <= pages.keys()
        assert '<html lang="en">' in pages["index.html"].read_text(encoding="utf-8")

    @pytest.mark.parametrize(
        ("language", "title"),
        [
            ("en", "grip force (normal force at one jaw)"),
            ("ru", "усилие зажима (нормальная сила на одной губке)"),
            ("uk", "зусилля затискання (нормальна сила на одній губці)"),
        ],
    )
    def test_declared_titles_are_in_the_chosen_language(
        self, gripcourse: Command, language: str, title: str
    ) -> None:
        run = gripcourse("solve", "001", "--language", language)
        assert run.code == 0
        assert title.split(" (", maxsplit=1)[0] in run.out

    def test_a_drawn_table_is_said_and_can_be_solved(
        self, gripcourse: Command, tmp_path: Path
    ) -> None:
        table = tmp_path / "drawn.csv"
        run = gripcourse(
            *("variants", "draw", "--count", 2, "--seed", 1),
            *("--scheme", SCHEME, "--out", table),
        )
        assert run.code == 0
        assert str(table) in run.out
        assert "%" in run.out
        assert gripcourse("solve", "002", "--table", table).code == 0

    @pytest.mark.usefixtures("few_slips_counted")
    def test_an_audit_says_with_its_exit_code_whether_somebody_must_look(
        self, gripcourse: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        table, out = tmp_path / "drawn.csv", tmp_path / "audit"
        drawing = ("variants", "draw", "--count", 4, "--seed", 1, "--scheme", "wedge_slide")
        gripcourse(*drawing, "--out", table)
        certificate = "gripcourse.documents.report.certificate.certificate"
        monkeypatch.setattr(certificate, lambda *_: b"%PDF of it")  # nobody reads it here
        audit = ("variants", "audit", "--workers", 0, "--table", table, "--out", out)
        sound = gripcourse(*audit)
        assert (sound.code, sound.err) == (cli.DONE, "")
        assert "The table keeps all rules." in sound.out
        assert str(out / "certificate.pdf") in sound.out
        assert (out / "certificate.pdf").read_bytes() == b"%PDF of it"
        head, first, *rest = table.read_text(encoding="utf-8-sig").splitlines()
        twin = ",".join(["twin", *first.split(",")[1:]])
        table.write_text("\n".join([head, first, *rest, twin]) + "\n", encoding="utf-8")
        doubled = gripcourse(*audit)
        assert doubled.code == NEEDS_PERSON
        assert "Too near to another variant: 2." in doubled.out

    def test_an_imported_table_is_counted(self, gripcourse: Command, tmp_path: Path) -> None:
        drawn, out = tmp_path / "drawn.csv", tmp_path / "own.csv"
        gripcourse("variants", "draw", "--count", 3, "--seed", 1, "--out", drawn)
        run = gripcourse("variants", "import", drawn, "--out", out)
        assert (run.code, run.out.strip()) == (0, f"3 variants were written to {out}.")

    def test_a_folder_that_is_a_course_is_used_without_being_named(
        self, gripcourse: Command, course: Path
    ) -> None:
        text = (course / "variants" / "course.toml").read_text(encoding="utf-8")
        broken = text.replace('convention = "corrected"', 'convention = "corected"')
        (course / "variants" / "course.toml").write_text(broken, encoding="utf-8")
        run = gripcourse("validate", "--scheme", SCHEME, home=course)
        refused(run, "course.toml", "corected")

    def test_the_program_runs_as_a_module_and_starts_without_heavy_libraries(self) -> None:
        libraries = (
            *("numpy", "pandas", "weasyprint", "matplotlib", "openpyxl", "scipy", "pint"),
            "sqlalchemy",
        )
        heavy = set(libraries)
        code = f"import gripcourse.cli.main, sys; print(sorted({heavy} & set(sys.modules)))"
        done = subprocess.run(  # noqa: S603 (our own interpreter)
            [sys.executable, "-c", code], capture_output=True, text=True, check=True
        )
        assert done.stdout.strip() == "[]"
        called = subprocess.run(
            [sys.executable, "-m", "gripcourse", "--help"],
            capture_output=True,
            text=True,
            check=True,
        )
        assert "grade" in called.stdout

    def test_what_was_graded_before_is_looked_at_without_the_course(self) -> None:
        course = {"numpy", "openpyxl", "gripcourse.course.model", "gripcourse.grading.model"}
        looks = "import gripcourse.cli.grade, gripcourse.usecases.grading.as_before, sys"
        done = subprocess.run(  # noqa: S603 (our own interpreter)
            [sys.executable, "-c", f"{looks}; print(sorted({course} & set(sys.modules)))"],
            capture_output=True, text=True, check=True,
        )  # fmt: skip
        assert done.stdout.strip() == "[]"


class TestWrongUse:
    @pytest.mark.parametrize(
        ("arguments", "said"),
        [
            pytest.param(["solve", "999"], ["no variant '999'"], id="unknown variant"),
            pytest.param(["solve"], ["--scheme"], id="neither variant nor scheme"),
            pytest.param(["solve", "001", "--set", "mass=5"], ["--scheme"], id="set of a variant"),
            pytest.param(["solve", "--scheme", "four_bar"], ["four_bar", SCHEME], id="scheme"),
            pytest.param(
                ["solve", "--scheme", SCHEME, "--set", "mass=-5"],
                ["mass", "0.001"],
                id="negative mass",
            ),
            pytest.param(
                ["solve", "--scheme", SCHEME, "--set", "friction=0"],
                ["friction", "0.01"],
                id="zero friction",
            ),
            pytest.param(
                ["solve", "--scheme", SCHEME, "--set", "mas=5"], ["mas", "'mass'"], id="misspelt"
            ),
            pytest.param(
                ["solve", "--scheme", SCHEME, "--set", "mass"], ["name=value"], id="no value"
            ),
            pytest.param(
                ["solve", "--scheme", SCHEME, "--option", "drive=steam"],
                ["steam", "hydraulic", "pneumatic"],
                id="unknown option",
            ),
            pytest.param(["solve", "001", "--language", "de"], ["de", "uk"], id="language"),
            pytest.param(["solve", "001", "--convention", "x"], ["corrected"], id="convention"),
            pytest.param(["solve", "001", "--table", "no.csv"], ["no.csv"], id="no table"),
            pytest.param(["validate", "--course", "nowhere"], ["nowhere"], id="no course"),
            pytest.param(
                ["variants", "draw", "--count", 2, "--seed", 1, "--scheme", "four_bar"],
                ["--scheme", "four_bar"],
                id="no space",
            ),
            pytest.param(["variants", "import", "own.csv"], ["own.csv"], id="no table to import"),
            pytest.param(["grade", "no.xlsx", "--out", "out"], ["no.xlsx"], id="nothing to grade"),
            pytest.param(["check", "no.xlsx"], ["no.xlsx"], id="nothing to check"),
            pytest.param(["mark"], ["--table", "--list"], id="nothing to mark"),
            pytest.param(["mark", "s01"], ["a student and an item"], id="no item"),
            pytest.param(
                ["mark", "--list", "--table", "marks.csv"], ["--list"], id="two marks at once"
            ),
            pytest.param(
                ["mark", "--list", "--gradebook", "no.sqlite"],
                ["no.sqlite", "gripcourse grade"],
                id="no gradebook",
            ),
            pytest.param(
                ["issue", "--roster", "no.csv", "--out", "out"], ["no.csv"], id="no roster"
            ),
        ],
    )
    def test_one_line_says_what_and_where_and_nothing_is_written(
        self, gripcourse: Command, tmp_path: Path, arguments: list[object], said: list[str]
    ) -> None:
        refused(gripcourse(*arguments), *said)
        assert left_behind(tmp_path) == set()

    def test_every_path_that_is_not_there_has_its_line(self, gripcourse: Command) -> None:
        run = gripcourse("grade", "a.xlsx", "b.xlsx", "--out", "out")
        assert run.code == cli.WRONG_USE
        assert [line.split(":")[0] for line in run.problems] == ["a.xlsx", "b.xlsx"]

    @pytest.mark.parametrize(
        "arguments",
        [
            ["nope"],
            ["grade", "a.xlsx"],
            ["grade", "a.xlsx", "--out", "out", "--date", "2026-13-01"],
            ["variants", "draw", "--count", "0", "--seed", "1"],
            ["mark", "s01", "general_view_drawing", "--points", "viel"],
        ],
    )
    def test_the_parsers_own_refusals_have_the_same_code(
        self, gripcourse: Command, tmp_path: Path, arguments: list[str]
    ) -> None:
        run = gripcourse(*arguments)
        assert run.code == cli.WRONG_USE
        assert "Traceback" not in run.err
        assert left_behind(tmp_path) == set()

    def test_a_file_that_is_no_workbook_is_refused_with_its_reason(
        self, gripcourse: Command, tmp_path: Path
    ) -> None:
        file = tmp_path / "ответы.xlsx"
        file.write_bytes("усилие;3900".encode("cp1251"))
        refused(gripcourse("check", file), "ответы.xlsx", ".xlsx")

    @pytest.mark.parametrize(
        ("column", "value"), [("mass [kg]", "-5"), ("friction", "0"), ("scheme", "four_bar")]
    )
    def test_a_bad_cell_of_a_table_is_named_by_file_row_and_column(
        self, gripcourse: Command, course: Path, column: str, value: str
    ) -> None:
        table = table_with(course, column, value)
        out = course.parent / "assignments"
        roster = course / "variants" / "roster.csv"
        run = gripcourse(
            *("issue", "--course", course, "--roster", roster),
            *("--table", table, "--out", out),
        )
        refused(run, "changed.csv", "row 2", column.split(maxsplit=1)[0])
        assert not out.exists()
        assert not gradebook_path(course).exists()

    @pytest.mark.parametrize(
        ("content", "said"),
        [
            pytest.param(b"student,name\n\xff\0\n", ["not in UTF-8", "line 2"], id="no text"),
            pytest.param((ROSTER + "s01,Петров,,,,\n").encode(), ["row 4", "s01"], id="doubled id"),
            pytest.param(b"", ["roster.csv"], id="empty"),
            pytest.param(b"student,name\n", ["no students"], id="headings only"),
            pytest.param("шифр\ns01\n".encode(), ["name"], id="no names"),
        ],
    )
    def test_a_bad_roster_is_refused_and_nothing_is_issued(
        self, gripcourse: Command, course: Path, content: bytes, said: list[str]
    ) -> None:
        roster = course / "variants" / "roster.csv"
        roster.write_bytes(content)
        out = course.parent / "assignments"
        run = gripcourse("issue", "--course", course, "--roster", roster, "--out", out)
        refused(run, "roster.csv", *said)
        assert not out.exists()
        assert not gradebook_path(course).exists()

    def test_a_damaged_gradebook_is_refused_before_anything_is_graded(
        self, gripcourse: Command, course: Path, tmp_path: Path
    ) -> None:
        file, book = tmp_path / "s01.xlsx", tmp_path / "book.sqlite"
        file.write_bytes(b"")
        book.write_text("student;points\n" * 100, encoding="utf-8")
        run = gripcourse(
            *("grade", file, "--course", course, "--gradebook", book, "--out", tmp_path / "out")
        )
        refused(run, "book.sqlite", "not a database", "backup")
        assert not (tmp_path / "out").exists()

    def test_a_place_that_cannot_be_written_is_named(
        self, gripcourse: Command, tmp_path: Path
    ) -> None:
        (tmp_path / "file").write_text("…", encoding="utf-8")
        out = tmp_path / "file" / "drawn.csv"
        refused(gripcourse("variants", "draw", "--count", 1, "--seed", 1, "--out", out), "file")

    def test_one_file_is_not_written_twice(self, gripcourse: Command, tmp_path: Path) -> None:
        run = gripcourse("solve", "001", "--pdf", "--xlsx", "--out", "solution.pdf")
        refused(run, "--out", "two documents")
        assert left_behind(tmp_path) == set()

    def test_the_demo_never_removes_what_it_did_not_make(
        self, gripcourse: Command, tmp_path: Path
    ) -> None:
        work = tmp_path / "submissions" / "s01.xlsx"
        work.parent.mkdir()
        work.write_bytes(b"somebody's work")
        refused(gripcourse("demo", "--out", tmp_path), str(tmp_path), "not empty")
        assert work.read_bytes() == b"somebody's work"
        assert left_behind(tmp_path) == {"submissions"}

    def test_problems_are_said_in_the_language_of_the_system(self, gripcourse: Command) -> None:
        said = [
            gripcourse("solve", "999", system=system).err
            for system in ("C", "de_DE.UTF-8", "ru_RU.UTF-8", "uk_UA.UTF-8")
        ]
        assert said[0] == said[1]
        assert len(set(said)) == 3


class TestOurMistakes:
    @pytest.mark.parametrize(
        "fault",
        [
            MemoryError(),
            RuntimeError("can't start new thread"),
            ImportError("mtrand.so: failed to map segment from shared object"),
        ],
    )
    def test_too_little_memory_is_no_mistake_of_ours(
        self, gripcourse: Command, monkeypatch: pytest.MonkeyPatch, fault: Exception
    ) -> None:
        def fail(*_: object, **__: object) -> None:
            raise fault

        monkeypatch.setattr("gripcourse.usecases.authoring.validate.validated", fail)
        run = gripcourse("validate")
        assert run.code == cli.WRONG_USE
        assert "too little memory" in run.err

    def test_where_neither_results_nor_complaints_can_be_written_the_code_says_it(self) -> None:
        with Path("/dev/full").open("wb") as full:
            done = subprocess.run(
                [sys.executable, "-m", "gripcourse", "--version"],
                stdout=full,
                stderr=full,
                check=False,
            )
        assert done.returncode == cli.WRONG_USE

    def test_an_unforeseen_failure_is_a_sentence_a_log_and_its_own_code(
        self, gripcourse: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        def fail(_root: Path, **_: object) -> None:
            raise ZeroDivisionError

        monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
        monkeypatch.setattr("gripcourse.usecases.authoring.validate.validated", fail)
        run = gripcourse("validate")
        assert run.code == cli.OUR_MISTAKE
        assert len(run.problems) == 1
        assert "Traceback" not in run.err
        (log,) = tmp_path.glob("gripcourse-incident-*.log")
        assert str(log) in run.err
        assert "ZeroDivisionError" in log.read_text(encoding="utf-8")


def test_a_course_from_issue_to_grades(gripcourse: Command, term: Term, tmp_path: Path) -> None:
    """Issue, check, grade: the codes say whether somebody must look."""
    assert term.issued.code == cli.DONE
    assert str(term.folder / "assignments") in term.issued.out

    assert term.graded.code == cli.DONE
    (report,) = json.loads(term.graded.out)["reports"]
    assert report["student"] == "s01"
    assert report["score"] == 0
    assert {one["outcome"] for one in report["findings"]} == {"blank", "manual"}

    story = term.again(tmp_path)
    checked = gripcourse(
        "check", story.own, "--course", story.folder / "course", "--language", "uk"
    )
    assert checked.code == cli.DONE
    assert "зусилля затискання" in checked.out

    other = tmp_path / "s02.xlsx"
    other.write_bytes(story.own.read_bytes())
    looked_at = gripcourse("grade", *story.place, other, "--out", tmp_path / "graded")
    assert looked_at.code == NEEDS_PERSON
    assert "who handed this in?" in looked_at.out
    assert "Traceback" not in looked_at.out + looked_at.err


def test_numbers_are_traced_to_a_variant_of_the_table(gripcourse: Command) -> None:
    solved = json.loads(gripcourse("solve", "006", "--json").out)["values"]
    computed = {name: one["value"] for name, one in solved.items() if one["kind"] == "formula"}
    numbers = [
        f"{value:.4g}".replace(".", ",") for value in list(computed.values())[:8] if value > 0
    ]
    run = gripcourse("trace", *numbers)
    assert run.code == 0
    assert "006" in run.out.splitlines()[3]
    assert set(list(computed)[:8]) & set(re.findall(r"\w+", run.out))


def test_what_is_no_number_cannot_be_traced(gripcourse: Command) -> None:
    run = gripcourse("trace", "12-13", "--quantity", "drive_forc=5")
    assert run.code == 2
    assert len(run.problems) == 2
    both = gripcourse("trace", "12", "--table", "a.csv", "--issued", ".")
    assert both.code == 2
    assert "exclude each other" in both.err


def test_a_drawing_from_waiting_to_marked(gripcourse: Command, term: Term, tmp_path: Path) -> None:
    """Grade, look what waits, mark, grade again: the codes say whether somebody must look."""
    story = term.again(tmp_path)
    course, own, place = story.folder / "course", story.own, story.place
    graded = tmp_path / "graded"

    listed = gripcourse("mark", "--list", "--course", course)
    assert listed.code == NEEDS_PERSON
    assert all(part in listed.out for part in ("s01", "general_view_drawing", "s01.xlsx"))

    order = ("mark", "s01", "general_view_drawing", "--course", course, "--by", "Петров")
    refused(gripcourse(*order, "--points", "99,5"), "--points", "99.5", "from 0 to")
    lines = ("--line", "sizes=1", "--line", "assembly=0,5", "--line", "standards=1")
    marked = gripcourse(*order, *lines, "--comment", "Нет масштаба")
    assert marked.code == cli.DONE
    assert "(s01), general view drawing (general_view_drawing): " in marked.out
    assert "already the same" in gripcourse(*order, *lines, "--comment", "Нет масштаба").out

    again = gripcourse("grade", *place, own, "--out", graded, "--json")
    assert again.code == cli.DONE
    (report,) = json.loads(again.out)["reports"]
    drawing = next(o for o in report["findings"] if o["quantity"] == "general_view_drawing")
    assert drawing["decision"]["marker"] == "Петров"
    assert report["score"] == pytest.approx(0.85 * drawing["max_points"])

    table = tmp_path / "marks.csv"
    table.write_text("filled in", encoding="utf-8")
    assert gripcourse("mark", "--list", "--course", course, "--out", table).code == NEEDS_PERSON
    assert (tmp_path / "marks.before-1.csv").read_text(encoding="utf-8") == "filled in"
    other = next(o["quantity"] for o in report["findings"] if o["outcome"] == "manual")
    table.write_text(f"student,quantity,credit\ns01,{other},1.5\n", encoding="utf-8")
    refused(gripcourse("mark", "--table", table, "--course", course), "row 2, column credit", "1.5")
    table.write_text(f'student,quantity,credit\ns01,{other},"0,5"\n', encoding="utf-8")
    assert gripcourse("mark", "--table", table, "--course", course).code == cli.DONE
    nothing = gripcourse("mark", "--list", "--course", course)
    assert (nothing.code, nothing.out.strip()) == (cli.DONE, "Nothing waits for the instructor.")


def test_a_regrade_from_showing_to_undoing(gripcourse: Command, term: Term, tmp_path: Path) -> None:
    """Change the policy, look, apply, publish, take back: the codes say what is left to do."""
    story = term.again(tmp_path)
    at = ("--course", story.folder / "course")
    files = (story.own, "--workers", 0, *at)
    assert gripcourse("regrade", *files).code == cli.DONE

    policy = story.folder / "course" / "grader" / "policy.toml"
    text = policy.read_text(encoding="utf-8")
    policy.write_text(text.replace("kinematic_diagram = 4", "kinematic_diagram = 5"), "utf-8")
    shown = gripcourse("regrade", *files)
    assert shown.code == NEEDS_PERSON
    assert all(
        one in shown.out for one in ("s01", "the policy", "(kinematic_diagram): ", "1 unchanged")
    )
    assert "kinematic_diagram" not in gripcourse("regrade", *files, "--only", "raised").out

    refused(gripcourse("regrade", *files, "--only", "raise"), "'raise'", "'raised'")
    refused(gripcourse("regrade", *files, "--apply"), "needs a reason")
    refused(gripcourse("undo", "--why", "no", *at), "No regrade stands")
    refused(gripcourse("history", "s09", *at), "<student>", "'s09'")
    refused(gripcourse("publish", "s09", *at), "<student>", "s09")

    assert gripcourse("publish", *at).code == cli.DONE
    signed = ("--by", "Петров", "--why", "диаграмма важнее")
    assert gripcourse("regrade", *files, "--apply", *signed).code == cli.DONE
    assert gripcourse("regrade", *files).code == cli.DONE
    assert gripcourse("undo", "--why", "поспешили", *at).code == cli.DONE
    told = gripcourse("history", "s01", *at).out
    assert all(one in told for one in ("Attempt 1", "Петров", "диаграмма важнее", "поспешили"))

    refused(gripcourse("waive", "s01", "--why", "болезнь", "--until", "soon", *at), "'soon'")
    refused(gripcourse("waive", "s01", *at), "needs a reason")
    assert gripcourse("waive", "s01", "--why", "болезнь", *at).code == cli.DONE
    assert "болезнь" in gripcourse("history", "s01", *at).out
    out = ("--out", tmp_path / "graded")
    refused(gripcourse("grade", *files, *out, "--handed-in", "soon"), "--handed-in", "'soon'")


def test_what_was_kept_is_told_amid_a_change_that_the_course_does_not_bear(
    gripcourse: Command, term: Term, tmp_path: Path
) -> None:
    """A history needs the course's id; what it calls quantities is all that the rest gives it."""
    story = term.again(tmp_path)
    at = ("--course", story.folder / "course")
    before = gripcourse("history", "s01", *at)
    scheme = next((story.folder / "course" / "variants" / "schemes").glob("*/scheme.toml"))
    scheme.write_text("", encoding="utf-8")
    assert gripcourse("mark", "--list", *at).code == cli.WRONG_USE

    told = gripcourse("history", "s01", *at)
    assert (told.code, told.out) == (cli.DONE, before.out)
    assert "called by their ids" in told.err
    refused(gripcourse("history", "s09", *at), "<student>", "'s09'")
    assert gripcourse("waive", "s01", "--why", "болезнь", *at).code == cli.DONE
    assert "болезнь" in gripcourse("history", "s01", *at).out


def test_a_variant_is_drawn(gripcourse: Command, tmp_path: Path) -> None:
    run = gripcourse("draw", "002", "--student-name", "Иванова А.", "--out", "views")
    assert run.code == 0
    paths = [tmp_path / line for line in run.out.split()]
    assert [path.suffix for path in paths] == [".dxf", ".svg"]
    assert "Иванова А." in paths[1].read_text(encoding="utf-8")


def test_an_unknown_variant_is_not_drawn(gripcourse: Command) -> None:
    run = gripcourse("draw", "999")
    assert run.code == 2
    assert "The table has no variant '999'." in run.err


def test_a_date_to_be_written_that_is_none_is_said_to_be_left_out_of_account(
    gripcourse: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "abc")
    run = gripcourse("solve", "--scheme", SCHEME)
    assert run.code == 0
    assert "SOURCE_DATE_EPOCH is 'abc'" in run.err
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    assert gripcourse("solve", "--scheme", SCHEME).err == ""
