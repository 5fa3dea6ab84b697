from pathlib import Path

import pytest

from tests_of_changes import tests_of as chosen


@pytest.fixture
def root(tmp_path: Path) -> Path:
    for path in (
        "tests/test_repository.py",
        "tests/formula/test_parse.py",
        "tests/formula/test_tree.py",
        "tests/formula/conftest.py",
        "tests/scripts/test_system_packages.py",
        "tests/course/test_load.py",
        "tests/docs/test_pages.py",
        "tests/benchmarks/test_import.py",
        "tests/usecases/authoring/test_templates.py",
        "tests/documents/test_assignment_sheet.py",
        "tests/documents/report/test_cohort.py",
    ):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).touch()
    return tmp_path


@pytest.mark.parametrize(
    ("changed", "tests"),
    [
        ([], []),
        (["src/gripcourse/formula/parse.py"], ["tests/formula/test_parse.py"]),
        (["src/gripcourse/formula/without_a_test.py"], []),
        (["tests/formula/test_tree.py"], ["tests/formula/test_tree.py"]),
        (["tests/formula/conftest.py", "tests/formula/test_tree.py"], ["tests/formula"]),
        (["tests/formula/test_that_was_removed.py"], []),
        (
            ["scripts/system-packages"],
            ["tests/benchmarks/test_import.py", "tests/scripts/test_system_packages.py"],
        ),
        (["benchmarks/solve.py"], ["tests/benchmarks/test_import.py"]),
        (["benchmarks/results.md"], []),
        (["variants/course.toml"], ["tests/course"]),
        (
            ["templates/style/cohort.css"],
            ["tests/documents/report/test_cohort.py", "tests/usecases/authoring/test_templates.py"],
        ),
        (
            ["templates/assignment.html.j2"],
            [
                "tests/documents/test_assignment_sheet.py",
                "tests/usecases/authoring/test_templates.py",
            ],
        ),
        (["docs/index.md"], ["tests/docs/test_pages.py"]),
    ],
)
def test_a_change_is_tested_by_its_mirror_and_by_what_holds_for_all(
    changed: list[str], tests: list[str], root: Path
) -> None:
    assert chosen(changed, root) == sorted([*tests, "tests/test_repository.py"])
