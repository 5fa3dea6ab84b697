"""Two servers of one course on one PostgreSQL are one to a student, and outlive its absence."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from datetime import timedelta
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.access.desk.model import Allowance
from gripcourse.access.desk.store import open_desk
from gripcourse.machine.database.home import address_path
from gripcourse.usecases.issuing.issue import issue_order
from gripcourse.usecases.serving.desk import DeskContext
from support.classroom import KEY, open_classroom
from web.conftest import Server, quick_handout

if TYPE_CHECKING:
    from gripcourse.policy.model import Policy
    from support.postgres import Server as Database


@pytest.fixture(scope="module")
def shared(
    tmp_path_factory: pytest.TempPathFactory, policy: "Policy", postgresql: "Database"
) -> Iterator[Server]:
    """A class whose course names a database on a server."""
    folder = tmp_path_factory.mktemp("shared")
    classroom = open_classroom(folder, policy)
    course = classroom.course
    with postgresql.database() as place:
        address_path(course.root).write_text(place, encoding="utf-8")
        issue_order(course, policy, classroom.order, 0, lambda _: None, issue_one=quick_handout)
        context = DeskContext(course, policy, KEY, open_desk(place, course.id))
        yield Server(classroom, context, folder / "graded")


def upload(data: bytes) -> dict[str, tuple[str, bytes]]:
    return {"file": ("робота.xlsx", data)}


def test_checks_are_rationed_by_both_together(shared: Server, tmp_path: Path) -> None:
    filled, home, times = (
        shared.filled("s01", tmp_path),
        shared.home("s01"),
        shared.context.policy.check.times,
    )
    clients = [shared.client(), shared.client()]
    with ThreadPoolExecutor(2) as pool:
        asked = [pool.submit(clients[n % 2].post, f"{home}check", files=upload(filled))
                 for n in range(times + 3)]  # fmt: skip
    assert {one.result().status_code for one in asked} == {200}
    told = [one.told for one in shared.context.desk.checks("s01")]
    assert (told.count(True), len(told)) == (times, times + 3)
    # Nor is anything counted in a file, which another machine would not see.
    assert not list(shared.context.private.glob("checks*"))


def test_hand_ins_are_rationed_by_both_together_and_wait_no_longer_than_said(
    shared: Server, monkeypatch: pytest.MonkeyPatch
) -> None:
    rate = Allowance(4, 600)
    monkeypatch.setattr("gripcourse.web.acts.HAND_INS", rate)
    home = shared.home("s02")
    clients = [shared.client(), shared.client()]

    def ask(number: int) -> int:
        return clients[number % 2].post(f"{home}hand-in", files=upload(b"%d" % number)).status_code

    with ThreadPoolExecutor(2) as pool:
        answers = list(pool.map(ask, range(rate.times + 2)))
    assert sorted(answers) == [200] * rate.times + [429] * 2
    shared.clock.now += timedelta(seconds=rate.seconds)
    later = shared.client().post(f"{home}hand-in", files=upload(b"later"))
    assert (later.status_code, len(shared.context.desk.hand_ins("s02"))) == (200, 5)


def test_a_student_is_asked_to_try_again_while_the_database_is_away(
    shared: Server, postgresql: "Database"
) -> None:
    client, home = shared.client(), shared.home("s03")
    postgresql.stop()
    answer = client.post(f"{home}hand-in", files=upload(b"a work"))
    assert answer.status_code == 503
    assert "не сохраняется дважды" in answer.text
    assert str(postgresql.folder) not in answer.text
    postgresql.start()
    answers = [client.post(f"{home}hand-in", files=upload(b"a work")) for _ in range(2)]
    assert [one.status_code for one in answers] == [200, 200]
    assert [one.number for one in shared.context.desk.hand_ins("s03")] == [1]
