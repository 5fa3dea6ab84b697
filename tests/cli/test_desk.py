"""The commands beside the server: links, publishing, collecting."""

import csv
import stat
import sys
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import pytest

from gripcourse.access.desk.links import Refused
from gripcourse.access.desk.store import open_desk
from gripcourse.cli import main as cli
from gripcourse.course.load import load_course
from gripcourse.errors import CourseError
from gripcourse.exports.grades import grades_text
from gripcourse.issuing.signature import key_path, read_key
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.database.home import home_of
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.grading.batch_tables import GRADES_CSV, GRADES_JSON, json_text
from gripcourse.usecases.issuing.handout import Handout
from gripcourse.usecases.issuing.issue import issue_order
from gripcourse.usecases.publishing.publish import current
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import hand_in
from gripcourse.usecases.serving.links import open_link
from support.classroom import Classroom

NOW = datetime(2026, 10, 1, tzinfo=UTC)
Run = Callable[..., str]


@pytest.fixture
def context(classroom: Classroom, policy: Policy) -> DeskContext:
    """A course of which only the register was written, and its id: no declarations."""
    course = classroom.course
    main = course.root / "variants" / "course.toml"
    main.parent.mkdir(exist_ok=True)
    main.write_text(f'id = "{course.id}"', encoding="utf-8")
    nothing = Handout("", (), ())
    issue_order(course, policy, classroom.order, 0, lambda _: None, issue_one=lambda *_: nothing)
    desk = open_desk(home_of(course.root), course.id)
    return DeskContext(course, policy, read_key(key_path(course.root)), desk)


@pytest.fixture
def run(
    context: DeskContext, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Run:
    monkeypatch.setattr("gripcourse.usecases.serving.desk.load_course", lambda _: context.course)

    def said(*arguments: str) -> str:
        course = ("--course", str(context.course.root), "--language", "en")
        monkeypatch.setattr(sys, "argv", ["gripcourse", *arguments, *course])
        with pytest.raises(SystemExit) as ended:
            cli.main()
        return f"{ended.value.code} {''.join(capsys.readouterr())}"

    return said


def test_links_are_written_for_their_owner_and_end_when_revoked(
    run: Run, context: DeskContext, tmp_path: Path
) -> None:
    out = tmp_path / "links.csv"
    command = ("links", "--address", "https://course.example/", "--out", str(out))

    def tokens() -> dict[str, str]:
        with out.open(encoding="utf-8-sig", newline="") as stream:
            found = {row["student"]: row["link"] for row in csv.DictReader(stream)}
        assert all(one.startswith("https://course.example/s/") for one in found.values())
        return {student: one.split("/")[-2] for student, one in found.items()}

    assert run(*command).startswith("0")
    assert stat.S_IMODE(out.stat().st_mode) == 0o600
    before = tokens()
    assert run(*command, "--revoke", "s02").startswith("0")
    after = tokens()
    opened = [open_link(context, one["s02"], NOW) for one in (before, after)]
    assert opened == [Refused.REVOKED, context.register()["s02"]]
    assert open_link(context, before["s01"], NOW) == context.register()["s01"]
    assert run("links", "--revoke", "nobody").startswith("2")
    assert run("links").startswith("2")


def test_what_is_handed_in_is_collected_and_results_are_published_and_withdrawn(
    run: Run, context: DeskContext, tmp_path: Path
) -> None:
    for data in (b"first", b"second"):
        hand_in(context, context.register()["s01"], NamedBytes("мой.XLSX", data), NOW)
    assert "1" in run("handed-in", "--out", str(tmp_path / "work"))
    assert (tmp_path / "work" / "s01.xlsx").read_bytes() == b"second"
    graded = tmp_path / "graded"
    assert run("release", str(graded)).startswith("2")
    graded.mkdir()
    (graded / GRADES_JSON).write_text(json_text([], Words("en")), encoding="utf-8")
    (graded / GRADES_CSV).write_text(grades_text([]), encoding="utf-8-sig")
    assert run("release", str(graded), "--by", "Ann", "--why", "end").startswith("0")
    published = current(context)
    assert published is not None
    assert (published.by, published.why) == ("Ann", "end")
    assert run("release", "--withdraw").startswith("0")
    assert current(context) is None
    assert run("release").startswith("2")


def test_a_link_to_sign_in_is_printed(run: Run, context: DeskContext) -> None:
    line = run("sign-in", "--by", "Ann", "--address", "https://course.example").split()[-1]
    token = line.removeprefix("https://course.example/desk/sign-in/")
    now = datetime.now(UTC)
    assert context.desk.begin_session(token, "session", now.replace(year=2099), now)
    assert context.desk.session_name("session", now) == "Ann"


def test_a_course_amid_a_change_hinders_no_link_and_no_collecting(
    run: Run, context: DeskContext, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They need the register, its key and the course's id; `release` tells points of the course."""
    monkeypatch.undo()
    with pytest.raises(CourseError):
        load_course(context.course.root)
    at = ("--address", "https://course.example")
    hand_in(context, context.register()["s01"], NamedBytes("a.xlsx", b"a"), NOW)
    links, work = tmp_path / "links.csv", tmp_path / "work"
    assert run("links", *at, "--out", str(links)).startswith("0")
    assert run("links", "--revoke", "s01").startswith("0")
    assert run("sign-in", *at).startswith("0")
    assert run("handed-in", "--out", str(work)).startswith("0")
    assert [one.name for one in work.iterdir()] == ["s01.xlsx"]
    assert run("release", "--withdraw").startswith("2")


def test_no_sign_in_is_offered_where_nobody_knows_the_address(run: Run) -> None:
    said = run("sign-in", "--by", "Ann")
    assert said.startswith("2")
    assert "--address" in said
    assert "/desk/" not in said
