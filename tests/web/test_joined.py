"""Who had two ids sees at the desk what was handed in under either, and nobody else does."""

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import timedelta
from typing import TYPE_CHECKING

import pytest

from gripcourse.issuing.withdrawal import Withdrawal
from gripcourse.machine.database.home import home_of
from gripcourse.usecases.marks.withdraw import withdraw
from gripcourse.usecases.serving.hand_in import collect_hand_ins
from gripcourse.usecases.serving.taken import checks_of

if TYPE_CHECKING:
    from pathlib import Path

    from starlette.testclient import TestClient

    from conftest import Server


@dataclass(frozen=True, slots=True)
class Sent:
    """What was handed in under the second id before both were joined."""

    number: int
    data: bytes


def join(server: "Server", *, undo: bool = False) -> None:
    root, at = server.context.course.root, server.clock.now
    wanted = Withdrawal("s03", "" if undo else "s01", undo, "Один человек", "Петров", at)
    withdraw(wanted, root, home_of(root))


def send(server: "Server", student: str, data: bytes, name: str = "работа.xlsx") -> int:
    """Hand a file in by a personal link; return the number of its receipt."""
    server.clock.now += timedelta(minutes=1)
    files = {"file": (name, data)}
    assert server.client().post(f"{server.home(student)}hand-in", files=files).status_code == 200
    return server.context.desk.hand_ins(student)[-1].number


@pytest.fixture
def sent(server: "Server") -> Iterator[Sent]:
    # Long after whatever other tests hand in: between two ids of one person the clock decides.
    server.clock.now += timedelta(days=100)
    data = f"PK {server.clock.now}".encode()
    made = Sent(send(server, "s03", data), data)
    link = server.home("s03")
    join(server)
    assert f"receipt/{made.number}?of=s03" in server.client().get(link).text
    yield made
    join(server, undo=True)


def test_the_person_sees_files_and_receipts_of_either_id(server: "Server", sent: Sent) -> None:
    own = send(server, "s01", b"PK handed in under the first id")
    client, home = server.client(), server.home("s01")
    page = client.get(home).text
    assert f"receipt/{own}" in page
    assert f"receipt/{sent.number}?of=s03" in page
    receipt = client.get(f"{home}receipt/{sent.number}?of=s03")
    assert f"file/{sent.number}?of=s03" in receipt.text
    assert client.get(f"{home}file/{sent.number}?of=s03").content == sent.data
    assert client.get(f"{home}file/{own}").content == b"PK handed in under the first id"


def test_nobody_else_sees_them(server: "Server", sent: Sent) -> None:
    client, home = server.client(), server.home("s02")
    assert "of=s03" not in client.get(home).text
    for of in ("s03", "s01", "s02/../s03", "%00"):
        for kind in ("receipt", "file"):
            assert client.get(f"{home}{kind}/{sent.number}?of={of}").status_code == 404


def test_who_is_two_again_sees_only_their_own(server: "Server", sent: Sent) -> None:
    join(server, undo=True)
    try:
        client = server.client()
        assert client.get(f"{server.home('s01')}file/{sent.number}?of=s03").status_code == 404
        assert client.get(f"{server.home('s03')}file/{sent.number}").content == sent.data
    finally:
        join(server)


def test_the_instructor_opens_them_from_the_page_of_the_person(
    sent: Sent, signed_in: "TestClient"
) -> None:
    page = signed_in.get("/desk/student/s01").text
    assert f"/desk/student/s03/file/{sent.number}" in page
    assert signed_in.get(f"/desk/student/s03/file/{sent.number}").content == sent.data


def test_of_both_ids_the_last_workbook_is_collected_and_called_like_the_person(
    server: "Server", sent: Sent, tmp_path: "Path"
) -> None:
    found = collect_hand_ins(server.context, tmp_path / "one")
    assert {path.name for path, one in found.items() if one.student == "s01"} == {"s01.xlsx"}
    assert (tmp_path / "one" / "s01.xlsx").read_bytes() == sent.data
    send(server, "s01", b"PK later")
    collect_hand_ins(server.context, tmp_path / "two")
    assert (tmp_path / "two" / "s01.xlsx").read_bytes() == b"PK later"


def test_a_workbook_of_the_second_sheet_is_checked_as_the_persons_own(
    server: "Server", tmp_path: "Path"
) -> None:
    upload = {"file": ("работа.xlsx", server.filled("s03", tmp_path))}
    check, client = f"{server.home('s01')}check", server.client()
    of_another = "Эта книга выдана другому студенту"
    assert of_another in client.post(check, files=upload).text
    join(server)
    try:
        assert of_another not in client.post(check, files=upload).text
    finally:
        join(server, undo=True)


def test_self_checks_of_the_second_id_are_the_persons(server: "Server") -> None:
    desk = server.context.desk
    own, of_second = len(desk.checks("s01")), len(desk.checks("s03"))
    desk.log_check("s03", "0" * 64, None, server.clock.now)

    def checks(student: str) -> int:
        return len(checks_of(desk, student, server.context.joins()))

    assert checks("s01") == own
    join(server)
    try:
        assert checks("s01") == own + of_second + 1
    finally:
        join(server, undo=True)
    assert (checks("s01"), checks("s03")) == (own, of_second + 1)
