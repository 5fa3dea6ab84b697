"""What several tests of an author's work share."""

from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.machine.resources import TEMPLATES
from gripcourse.usecases.authoring.templates import Templates, all_templates

BELTS = Path(__file__).parents[3] / "examples" / "belt_drive"


@pytest.fixture(scope="session")
def templates_read() -> Templates:
    """What is read in the templates, which are the program's: once, and not for every mistake."""
    return all_templates(BELTS / TEMPLATES, load_course(BELTS).language)


@pytest.fixture
def same_templates(templates_read: Templates, monkeypatch: pytest.MonkeyPatch) -> None:
    """No template is read again, however little is remembered."""
    monkeypatch.setattr(
        "gripcourse.usecases.authoring.validate.all_templates", lambda *_: templates_read
    )
