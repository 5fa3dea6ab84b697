"""A server that runs while its instructor edits the course."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from html import unescape
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.gradebook.journal import regrades
from gripcourse.gradebook.store import Gradebook
from gripcourse.machine.content import NamedBytes
from gripcourse.usecases.serving.hand_in import hand_in
from gripcourse.usecases.serving.living import LivingCourse, state_of
from web.conftest import form_key, sign_in

if TYPE_CHECKING:
    from gripcourse.usecases.serving.desk import DeskContext
    from web.conftest import Server

CARRIED = "carried = 1.0 "
HALF = "carried = 0.5 "
SEVEN = "carried = 7.0 "


@pytest.fixture
def files(server: "Server") -> Iterator[Path]:
    """The folder of the server's course; policy and main file are as they were after the test."""
    root = server.context.course.root
    edited = [root / "grader" / "policy.toml", root / "variants" / "course.toml"]
    before = [path.read_bytes() for path in edited]
    yield root
    for path, content in zip(edited, before, strict=True):
        path.write_bytes(content)


@pytest.fixture
def living(server: "Server") -> LivingCourse:
    """The course of a server that looks at each request."""
    return LivingCourse(server.context, seconds=0)


def edit(path: Path, before: str, after: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert before in text
    path.write_text(text.replace(before, after), encoding="utf-8")


def edit_policy(root: Path, before: str, after: str) -> None:
    edit(root / "grader" / "policy.toml", before, after)


def unexpected(_: "DeskContext") -> None:
    raise AssertionError


def test_an_edited_policy_counts_from_the_next_look_on(living: LivingCourse, files: Path) -> None:
    edit_policy(files, CARRIED, HALF)
    told = list[float]()
    living.look(lambda now: told.append(now.policy.carried_credit))
    assert (living.context.policy.carried_credit, told) == (0.5, [0.5])
    living.look(unexpected)


def test_an_edited_course_counts_from_the_next_look_on(living: LivingCourse, files: Path) -> None:
    edit(files / "variants" / "course.toml", 'en = "Design of a', 'en = "New design of a')
    living.look(lambda _: None)
    assert living.context.course.title.of("en") == "New design of a robot gripper"


def test_a_file_that_says_the_same_again_changes_nothing(living: LivingCourse, files: Path) -> None:
    edit_policy(files, CARRIED, HALF)
    living.look(lambda _: None)
    path = files / "grader" / "policy.toml"
    path.write_bytes(path.read_bytes())
    living.look(unexpected)


def test_between_two_looks_nothing_is_looked_at(server: "Server", files: Path) -> None:
    living = LivingCourse(server.context, seconds=1000)
    assert living.is_due
    living.look(unexpected)
    edit_policy(files, CARRIED, HALF)
    assert not living.is_due
    living.look(unexpected)


def test_what_changes_while_a_server_begins_is_seen(server: "Server", files: Path) -> None:
    seen = state_of(files)
    edit_policy(files, CARRIED, HALF)
    living = LivingCourse(server.context, seen, seconds=0)
    living.look(lambda _: None)
    assert living.context.policy.carried_credit == 0.5


def test_of_many_that_come_at_once_one_reads_and_all_go_on_with_the_new(
    server: "Server", files: Path
) -> None:
    edit_policy(files, CARRIED, HALF)
    living = LivingCourse(server.context, (), seconds=1000)
    told = list[float]()

    def ask(_: int) -> float:
        living.look(lambda now: told.append(now.policy.carried_credit))
        return living.context.policy.carried_credit

    with ThreadPoolExecutor(8) as pool:
        assert set(pool.map(ask, range(8))) == {0.5}
    assert told == [0.5]


def test_a_faulty_policy_leaves_the_one_before_and_is_said_until_it_is_mended(
    living: LivingCourse, files: Path
) -> None:
    edit_policy(files, CARRIED, SEVEN)
    living.look(unexpected)
    (fault,) = living.faults
    assert (fault.file, fault.key) == ("grader/policy.toml", "credit.carried")
    assert living.context.policy.carried_credit == 1.0
    edit_policy(files, SEVEN, HALF)
    living.look(lambda _: None)
    assert (living.faults, living.context.policy.carried_credit) == ((), 0.5)


def test_a_file_that_is_half_written_leaves_what_was_before(
    living: LivingCourse, files: Path
) -> None:
    path = files / "variants" / "course.toml"
    path.write_bytes(path.read_bytes()[:200])
    living.look(unexpected)
    assert living.faults
    assert living.context.course.sections


def test_another_course_in_its_place_is_refused(living: LivingCourse, files: Path) -> None:
    edit(files / "variants" / "course.toml", 'id = "gripper-design"', 'id = "another"')
    living.look(unexpected)
    (fault,) = living.faults
    assert (fault.file, fault.key) == ("variants/course.toml", "id")
    assert living.context.course.id == "gripper-design"


def test_a_student_is_told_by_the_edited_policy_how_often_numbers_are_compared(
    server: "Server", files: Path
) -> None:
    client = server.client()
    assert "3" in client.get(f"{server.home('s02')}").text
    edit_policy(files, "times = 3 ", "times = 8642 ")
    assert "8642" in client.get(f"{server.home('s02')}").text.replace("\N{NO-BREAK SPACE}", "")


def test_a_check_is_done_by_workers_that_know_the_edited_policy(
    server: "Server", files: Path, filled: bytes
) -> None:
    client = server.client()
    upload = {"file": ("work.xlsx", filled)}
    edit_policy(files, "times = 3 ", "times = 8642 ")  # others asked for the same student
    before = client.post(f"{server.home('s01')}check", files=upload)
    edit_policy(files, 'tells = "sections"', 'tells = "reading" ')
    after = client.post(f"{server.home('s01')}check", files=upload)
    assert (before.status_code, after.status_code) == (200, 200)
    assert [one.told for one in server.context.desk.checks("s01")][-2:] == [True, False]


def test_a_regrade_at_the_desk_is_by_the_edited_policy(
    server: "Server", files: Path, filled: bytes, tmp_path: Path
) -> None:
    issued = server.classroom.register["s01"]
    hand_in(server.context, issued, NamedBytes("work.xlsx", filled), server.clock.now)
    server.grade(tmp_path)
    client = sign_in(server)
    form = {"form_key": form_key(client)}
    assert 'name="seen"' not in client.post("/desk/regrading", data=form).text
    edit_policy(files, CARRIED, HALF)
    page = unescape(client.post("/desk/regrading", data=form).text)
    assert 'name="seen"' in page
    assert "credit.carried" in page


def test_the_desk_says_what_is_faulty_and_grades_nothing_by_it(
    server: "Server", files: Path
) -> None:
    client = sign_in(server)
    form = {"form_key": form_key(client)}
    edit_policy(files, CARRIED, SEVEN)
    page = unescape(client.get("/desk/").text)
    assert "grader/policy.toml: credit.carried: " in page
    book = Gradebook(server.context.desk.engine)
    applied = len(regrades(book))
    for path in ("regrading", "regrading/apply", "grading"):
        refused = client.post(f"/desk/{path}", data={**form, "why": "so", "seen": ""})
        assert refused.status_code == 409
        assert "grader/policy.toml: credit.carried: " in unescape(refused.text)
    assert len(regrades(book)) == applied
    edit_policy(files, SEVEN, CARRIED)
    assert "credit.carried" not in client.get("/desk/").text
