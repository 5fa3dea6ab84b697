"""A kind of document is one module and one template: the registry finds it, all others read it."""

import importlib.util
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.documents import kinds
from gripcourse.documents.kind import SampleDocument
from gripcourse.documents.pdf import render_html
from gripcourse.documents.registry import document_kinds
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.samples import printed_samples, samples
from gripcourse.usecases.authoring.styles import style_problems
from gripcourse.usecases.authoring.templates import filling_problems, read_templates
from support.howto import blocks

REPOSITORY = Path(__file__).parents[2]
HOWTO = "add-a-document.md"


@pytest.fixture(scope="module")
def sample(course: Course, policy: Policy) -> SampleDocument:
    return next(samples(course, policy, (), Words("en")))


@pytest.fixture
def followed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Do what the how-to says beside the program, and give the folder of the templates."""
    templates = tmp_path / "templates"
    shutil.copytree(REPOSITORY / "templates", templates)
    (template,), (module,) = blocks(HOWTO, "jinja"), blocks(HOWTO, "python")
    (templates / "reminder.html.j2").write_text(template, encoding="utf-8")
    folder = tmp_path / "kinds"
    folder.mkdir()
    (folder / "reminder.py").write_text(module, encoding="utf-8")
    monkeypatch.setattr(kinds, "__path__", [*kinds.__path__, str(folder)])
    yield templates
    sys.modules.pop("gripcourse.documents.kinds.reminder", None)
    vars(kinds).pop("reminder", None)


def test_every_module_brings_a_kind_of_its_name() -> None:
    found = [kind.id for kind in document_kinds()]
    written = [path.stem for path in Path(kinds.__path__[0]).glob("[!_]*.py")]
    assert found == sorted(written)


def test_every_kind_has_its_template_and_its_styles() -> None:
    templates = REPOSITORY / "templates"
    for kind in document_kinds():
        assert (templates / kind.template).is_file(), kind.id
        assert all((templates / "style" / name).is_file() for name in kind.styles), kind.id


def test_every_template_belongs_to_a_kind() -> None:
    pages = {path.name for path in (REPOSITORY / "templates").glob("*.j2")}
    known = {kind.template.partition(".")[0] for kind in document_kinds()}
    # A kind of several pages calls the others after its first.
    assert {one for one in pages if not one.startswith(tuple(known))} == set()


def test_names_of_samples_begin_with_their_kind(sample: SampleDocument) -> None:
    for kind in document_kinds():
        assert all(name.startswith(kind.id) for name in kind.samples(sample)), kind.id


def test_a_module_without_a_kind_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "kindless.py").write_text('"""Nothing."""\n', encoding="utf-8")
    monkeypatch.setattr(kinds, "__path__", [str(tmp_path)])
    with pytest.raises(TypeError, match="kindless has no KIND"):
        document_kinds()


class TestTheHowTo:
    def test_the_registry_knows_the_new_kind(self, followed: Path) -> None:
        assert followed.is_dir()
        assert "reminder" in {kind.id for kind in document_kinds()}

    def test_its_template_is_judged_and_its_page_says_what_it_shall(
        self, followed: Path, sample: SampleDocument
    ) -> None:
        document = printed_samples(sample)["reminder"]()
        read, problems = read_templates(followed)
        assert [*problems, *filling_problems([document], followed, sample.words, read)] == []
        assert style_problems(followed) == []
        page = render_html(document, followed, sample.words)
        assert "<h1>Given values</h1>" in page
        assert sample.issued.student.name in page

    def test_a_mistake_in_its_template_is_found(
        self, followed: Path, sample: SampleDocument
    ) -> None:
        path = followed / "reminder.html.j2"
        path.write_text(path.read_text(encoding="utf-8").replace("day | day", "dya | day"), "utf-8")
        read, _ = read_templates(followed)
        document = printed_samples(sample)["reminder"]()
        (problem,) = filling_problems([document], followed, sample.words, read)
        assert problem.file == "templates/reminder.html.j2"

    def test_the_gallery_shows_it(self, followed: Path) -> None:
        assert followed.is_dir()
        spec = importlib.util.spec_from_file_location("gallery", REPOSITORY / "scripts/gallery.py")
        assert spec is not None
        assert spec.loader is not None
        gallery = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(gallery)
        assert "reminder" in [kind.id for kind in gallery.unpictured()]
