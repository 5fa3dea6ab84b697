"""Templates tried by another process: what it finds is what this one would."""

import shutil
from dataclasses import dataclass
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.source_files import SourceFiles, source_files
from gripcourse.machine.jobs import warm
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.resources import template_folders
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.usecases.authoring.judged_before import FilesSeen, files_seen
from gripcourse.usecases.authoring.template_trial import (
    TemplateTrial,
    Tried,
    begun_apart,
    trial_of,
    trial_problems,
)
from gripcourse.usecases.authoring.templates import Templates, all_templates

REPOSITORY = Path(__file__).parents[3]
COURSE = REPOSITORY / "examples" / "belt_drive"
SHEET = "assignment.html.j2"


@dataclass(frozen=True)
class Tries:
    """A course whose sheet asks a value for what it does not have: only filling it shows that."""

    root: Path
    files: SourceFiles | None
    policy: Policy
    trial: TemplateTrial
    read: Templates

    @property
    def templates(self) -> Path:
        return self.root / "templates"

    @property
    def look(self) -> FilesSeen:
        return files_seen(self.root, template_folders(self.templates))

    def said(self, tried: Tried | None) -> list[str]:
        found = trial_problems(self.trial, self.policy, self.templates, self.look, self.read, tried)
        return [f"{one.file} {one.key} {one.what}" for one in found]

    def begun(self) -> Tried:
        return begun_apart(self.root, self.files, self.policy, self.templates, self.read)


@pytest.fixture(scope="module")
def tries(tmp_path_factory: pytest.TempPathFactory) -> Tries:
    warm._dismiss_all()  # noqa: SLF001 (one that other tests started may keep its courses elsewhere)
    root = Path(shutil.copytree(COURSE, tmp_path_factory.mktemp("tried") / "course"))
    (root / "templates").mkdir(exist_ok=True)
    plain = (REPOSITORY / "templates" / SHEET).read_text(encoding="utf-8")
    wrong = plain.replace("{% block content %}", "{% block content %}{{ course.nothing }}")
    assert wrong != plain
    (root / "templates" / SHEET).write_text(wrong, encoding="utf-8")
    course, files = load_course(root), source_files(root)
    read = all_templates(root / "templates", course.language)
    return Tries(root, files, load_policy(course), trial_of(course, files), read)


@pytest.fixture(scope="module")
def here(tries: Tries) -> list[str]:
    """What this process says that tries them alone."""
    return tries.said(None)


def test_what_another_process_finds_wrong_is_told_by_this_one(
    tries: Tries, here: list[str]
) -> None:
    assert f"templates/{SHEET}" in here[0]
    begun = tries.begun()
    outcome = begun()
    assert isinstance(outcome, list)
    assert outcome
    assert tries.said(lambda: outcome) == here


@pytest.mark.parametrize("outcome", [Lost("It is gone.\n"), None], ids=["died", "kept nothing"])
def test_what_another_process_cannot_try_is_tried_here(
    tries: Tries, here: list[str], outcome: Lost | None
) -> None:
    assert tries.said(lambda: outcome) == here


def test_another_process_that_has_no_kept_course_says_so(tries: Tries, tmp_path: Path) -> None:
    elsewhere = Path(shutil.copytree(tries.root, tmp_path / "course"))
    declared = elsewhere / "variants" / "course.toml"
    declared.write_text(declared.read_text(encoding="utf-8") + "\n# more\n", encoding="utf-8")
    begun = begun_apart(elsewhere, tries.files, tries.policy, elsewhere / "templates", tries.read)
    assert begun() is None
