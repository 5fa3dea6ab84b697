"""A template or a style sheet that cannot be used is named before anybody gets a document."""

import re
import shutil
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import pytest
from jinja2 import Environment, nodes

from gripcourse.course.model import Course
from gripcourse.documents.pdf import Document
from gripcourse.errors import Problem
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.samples import samples
from gripcourse.usecases.authoring.styles import first_families, style_problems
from gripcourse.usecases.authoring.templates import (
    filling_problems,
    read_templates,
    sample_documents,
)

REPOSITORY = Path(__file__).parents[3]
WORDS = Words("ru")

Spoil = Callable[..., list[Problem]]


@pytest.fixture(scope="module")
def documents(course: Course, policy: Policy) -> list[Document]:
    """Without spaces: the certificate is printed in tests of its own."""
    made, problems = sample_documents(next(samples(course, policy, (), WORDS)))
    assert problems == []
    return made


@pytest.fixture(scope="module", autouse=True)
def _read_once() -> Iterator[None]:
    """Take what a text of a template was read as before: of thirty a test changes one."""
    parse = Environment.parse
    trees: dict[tuple[str, str | None], nodes.Template] = {}

    def parsed(self: Environment, source: str, name: str | None, file: str) -> nodes.Template:
        if (source, name) not in trees:
            trees[source, name] = parse(self, source, name, file)
        return trees[source, name]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Environment, "parse", parsed)
        yield


@pytest.fixture
def spoiled(documents: list[Document], tmp_path: Path) -> Spoil:
    """Replace text in templates, (file, old, new) each, and judge them.

    Where whole templates are changed, only their documents are filled: nobody else takes them in.
    """

    def spoil(*edits: tuple[str, str, str]) -> list[Problem]:
        templates = tmp_path / "templates"
        shutil.copytree(REPOSITORY / "templates", templates)
        for file, old, new in edits:
            path = templates / file
            text = path.read_text(encoding="utf-8")
            assert old in text
            path.write_text(text.replace(old, new, 1), encoding="utf-8")
        read, problems = read_templates(templates)
        changed = {file for file, _, _ in edits}
        whole = changed and changed <= {one.template for one in documents}
        filled = [one for one in documents if not whole or one.template in changed]
        return [*problems, *filling_problems(filled, templates, WORDS, read)]

    return spoil


def line_of(file: str, text: str) -> str:
    lines = (REPOSITORY / "templates" / file).read_text(encoding="utf-8").splitlines()
    return f"line {next(number for number, line in enumerate(lines, 1) if text in line)}"


def test_the_templates_of_the_reference_course_are_right(spoiled: Spoil) -> None:
    assert spoiled() == []


# Several at a time, none of which hides another: file, text, what it becomes, what is said of it.
FAULTS = {
    "of what is written": (
        ("student.html.j2", "{% if causes %}", "{% if causes }", "unexpected '}'", "Correct"),
        ("cohort.html.j2", "<h1>", "<h1>{% include 'parts/gone' %}", "parts/gone", "parts/"),
        ("parts/given.html.j2", "| symbol", "| symbl", "filter 'symbl'", "'symbol'"),
        ("solution.html.j2", "{% if view %}", "{% if view is emty %}", "test 'emty'", "Known here"),
    ),
    "of names": (
        ("student.html.j2", "<h1>{{ student }}", "<h1>{{ studnet }}", "'studnet'", "'student'"),
        ("parts/answers.html.j2", "in rows %}", "in rwos %}", "'rwos'", ""),
        ("parts/behind.html.j2", "in causes %}", "in cuases %}", "'cuases'", "'causes'"),
        ("reference_scheme.html.j2", "{{ title }}", "{{ titel }}", "'titel'", "'title'"),
    ),
    "of a part of a value": (
        ("parts/behind.html.j2", "{{ cause.count }}", "{{ cause.cuont }}", "'cuont'", "name"),
    ),
    "of what is computed": (
        (
            "parts/result.html.j2",
            "{{ earned",
            "{{ 1 / 0 }}{{ earned",
            "division by zero",
            "Correct",
        ),
    ),
}


@pytest.mark.parametrize("faults", FAULTS.values(), ids=FAULTS)
def test_a_fault_is_named_with_its_file_its_line_and_a_remedy(
    spoiled: Spoil, faults: Sequence[tuple[str, str, str, str, str]]
) -> None:
    problems = spoiled(*(one[:3] for one in faults))
    found = {one.file: one for one in problems}
    assert sorted(one.file for one in problems) == sorted(
        f"templates/{file}" for file, *_ in faults
    )
    for file, old, _, what, remedy in faults:
        problem = found[f"templates/{file}"]
        assert problem.key == line_of(file, old)
        assert what in str(problem.what)
        assert remedy in str(problem.remedy)


def test_all_faults_of_all_templates_come_at_once(spoiled: Spoil) -> None:
    found = spoiled(
        ("student.html.j2", "<h1>{{ student }}", "<h1>{{ studnet }}"),
        ("cohort.html.j2", "{% if slips %}", "{% if slips }"),
        ("parts/marked.html.j2", "{{ item.said }}", "{{ item.said | bold }}"),
        ("solution.html.j2", "parts/calculation.html.j2", "parts/calculations.html.j2"),
    )
    assert {problem.file.removeprefix("templates/") for problem in found} == {
        *("student.html.j2", "cohort.html.j2", "parts/marked.html.j2", "solution.html.j2"),
    }


def test_a_template_that_is_not_utf8_is_named(tmp_path: Path) -> None:
    (tmp_path / "student.html.j2").write_bytes("Отчёт".encode("cp1251"))
    read, (problem,) = read_templates(tmp_path)
    assert "student.html.j2" not in read
    assert problem.file == "templates/student.html.j2"
    assert "UTF-8" in str(problem.what)


def test_the_style_sheets_of_the_reference_course_are_right() -> None:
    assert style_problems(REPOSITORY / "templates") == []


def test_a_font_that_this_machine_lacks_is_named_where_it_is_asked_for(tmp_path: Path) -> None:
    templates = tmp_path / "templates"
    shutil.copytree(REPOSITORY / "templates", templates)
    sheet = templates / "style" / "student.css"
    sheet.write_text('p { color: red }\n\nh1 { font: bold 9pt/1.2 "No Such Family", serif }\n')
    found = {problem.file: problem for problem in style_problems(templates)}
    assert set(found) == {"templates/style/student.css"}
    font = found["templates/style/student.css"]
    assert font.key == "line 3"
    assert re.search(r"No Such Family is missing, .+ is used\.", str(font.what))
    assert str(font.remedy) == "Install this font, or name one that is installed."


def test_what_a_course_lacks_is_taken_from_the_engines_look(tmp_path: Path) -> None:
    own = tmp_path / "templates"
    assert read_templates(own)[0].keys() == read_templates(REPOSITORY / "templates")[0].keys()
    assert style_problems(own) == []
    (own / "style").mkdir(parents=True)
    (own / "style" / "page.css").write_text('p { font-family: "No Such Family" }\n')
    (own / "student.html.j2").write_text("{{ studnet }}")
    read, problems = read_templates(own)
    assert problems == []
    assert set(read["student.html.j2"].asked) == {"studnet"}
    assert [problem.file for problem in style_problems(own)] == ["templates/style/page.css"]


@pytest.mark.parametrize(
    ("style", "families"),
    [
        ('p { font: 9pt "PT Sans", "DejaVu Sans", sans-serif }', {"PT Sans": 1}),
        ("p { font-family: Georgia, serif }", {"Georgia": 1}),
        ("p { font: italic bold 1.2em/1.1 Fira Sans, x }", {"Fira Sans": 1}),
        ("/* font: 9pt Old */\np { font-family: 'New' }", {"New": 2}),
        ("p { font-family: sans-serif; font-weight: bold; font-size: 9pt }", {}),
        ("p { font-family: var(--text) }", {}),
        ("@font-face { font-family: Own; src: url(data:x) } p { font-family: Own }", {}),
    ],
)
def test_the_first_family_of_each_list_is_what_a_style_sheet_asks_for(
    style: str, families: dict[str, int]
) -> None:
    assert first_families(style) == families
