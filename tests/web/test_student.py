"""A student's way: open the link, check, hand in, see the result, ask for another look."""

import asyncio
import hashlib
import re
from dataclasses import replace
from datetime import UTC, date, datetime, time, timedelta
from html import unescape
from pathlib import Path
from typing import TYPE_CHECKING
from zoneinfo import ZoneInfo

import pytest

from gripcourse.documents.pdf import template_environment
from gripcourse.errors import UsageError
from gripcourse.text.amounts import NO_BREAK_SPACE
from gripcourse.text.words import Words
from gripcourse.usecases.issuing.handout import Handout, IssuingContext
from gripcourse.usecases.issuing.issue import issue_order
from gripcourse.usecases.serving.hand_in import kept_path, latest
from gripcourse.web.pages import hour_of
from web.conftest import BEGAN

if TYPE_CHECKING:
    from starlette.types import Message

    from gripcourse.course.model import Course
    from gripcourse.variants.model import Issued
    from web.conftest import Server


def upload(data: bytes, name: str = "мой ответ.xlsx") -> dict[str, tuple[str, bytes]]:
    return {"file": (name, data)}


@pytest.mark.parametrize(
    ("student", "language", "word"),
    [("s01", "ru", "Задание"), ("s02", "uk", "Завдання"), ("s03", "en", "Assignment")],
)
def test_a_link_opens_the_students_own_assignment_in_their_language(
    server: "Server", student: str, language: str, word: str
) -> None:
    page = server.client().get(server.home(student)).text
    issued = server.classroom.register[student]
    assert f'<html lang="{language}">' in page
    assert {word, issued.student.name, issued.variant.id} <= set(re.findall(r"[^<>]+", page))


def test_the_link_that_is_printed_on_a_sheet_opens_its_owners_page_until_it_ends(
    server: "Server",
) -> None:
    course, order = server.context.course, server.classroom.order
    addressed = replace(course, address="https://course.example.org/")
    printed: dict[str, str] = {}

    def look(context: IssuingContext, entry: "Issued") -> Handout:
        printed[entry.student.id] = context.links.get(entry.student.id, "")
        return Handout(entry.student.id, (), ())

    def issue(course: "Course", days: int) -> dict[str, str]:
        asked = replace(order, link_days=days)
        issue_order(course, server.context.policy, asked, 0, lambda _: None, issue_one=look)
        return dict(printed)

    assert set(issue(addressed, 0).values()) == {""}
    with pytest.raises(UsageError) as refused:
        issue(course, 30)
    assert [one.parameter for one in refused.value.problems] == ["link_days"]
    links = issue(addressed, 30)
    assert links == issue(addressed, 30)
    client = server.client()
    for student, link in links.items():
        assert link.startswith("https://course.example.org/s/")
        path = link.removeprefix("https://course.example.org")
        name = server.classroom.register[student].student.name
        assert name in client.get(path).text
        server.clock.now += timedelta(days=30)
        assert client.get(path).status_code == 410
        server.clock.now = BEGAN


def test_the_documents_that_were_issued_can_be_taken_away(server: "Server") -> None:
    client, home = server.client(), server.home("s01")
    assert client.get(f"{home}assignment.pdf").content.startswith(b"%PDF")
    assert (
        client.get(f"{home}workbook.xlsx").content == server.classroom.workbook("s01").read_bytes()
    )


def test_a_check_says_how_each_answer_was_read_and_how_many_are_left(
    server: "Server", filled: bytes
) -> None:
    client, home = server.client(), server.home("s01")
    times = server.context.policy.check.times
    told = sum(one.told for one in server.context.desk.checks("s01"))
    left = times - told - 1  # the browser has asked too, if it was here before
    page = unescape(client.post(f"{home}check", files=upload(filled)).text)
    assert page.count('class="state-read"') > 20
    assert f"{left} из {times}" in page
    assert f"{left} из {times}" in unescape(client.get(home).text)
    logged = server.context.desk.checks("s01")[-1]
    assert (logged.digest, logged.told, logged.at) == (
        hashlib.sha256(filled).hexdigest(),
        True,
        server.clock.now,
    )


def test_a_workbook_without_a_complete_section_is_checked_for_nothing(server: "Server") -> None:
    """Who tries it early on must not lose what tells something later."""
    home, before = server.home("s03"), server.context.desk.checks("s03")
    blank = server.classroom.workbook("s03").read_bytes()
    page = unescape(server.client().post(f"{home}check", files=upload(blank)).text)
    times = server.context.policy.check.times
    assert "answer everything in this section first" in page
    assert f"{times - sum(one.told for one in before)} of {times}" in page
    assert not server.context.desk.checks("s03")[-1].told


def test_numbers_of_anothers_workbook_are_not_compared(server: "Server", filled: bytes) -> None:
    """A friend's questions would otherwise be one's own."""
    page = server.client().post(f"{server.home('s03')}check", files=upload(filled)).text
    assert "This workbook was issued to another student" in page
    assert page.count('class="state-read"') > 20
    assert "Sections" not in page
    assert not server.context.desk.checks("s03")[-1].told


def test_a_yes_is_understood_as_yes(server: "Server", filled: bytes) -> None:
    page = unescape(server.client().post(f"{server.home('s03')}check", files=upload(filled)).text)
    said = set(re.findall(r'data-label="Understood as">([^<]*)<', page))
    assert said & {"yes", "no"}
    assert not said & {"0", "1"}


def test_a_file_that_is_no_workbook_is_refused_in_the_students_language(server: "Server") -> None:
    page = server.client().post(f"{server.home('s02')}check", files=upload(b"PK nothing")).text
    assert 'role="alert"' in page
    assert re.search("[іїє]", page)


def test_a_receipt_is_for_bytes_that_a_new_server_still_has(
    server: "Server", filled: bytes
) -> None:
    home = server.home("s01")
    receipt = server.client().post(f"{home}hand-in", files=upload(filled, "../../work.xlsx"))
    digest = hashlib.sha256(filled).hexdigest()
    number = len(server.context.desk.hand_ins("s01"))
    assert str(receipt.url).endswith(f"/receipt/{number}")
    assert digest in receipt.text
    assert "work.xlsx" in receipt.text
    assert ".." not in receipt.text
    assert kept_path(server.context, digest).read_bytes() == filled
    again = server.client()  # of another process
    assert again.get(f"{home}receipt/{number}").text == receipt.text
    assert again.get(f"{home}file/{number}").content == filled


def test_two_clicks_are_one_hand_in(server: "Server", tmp_path: Path) -> None:
    client, home, data = server.client(), server.home("s02"), server.filled("s02", tmp_path)
    before = len(server.context.desk.hand_ins("s02"))
    answers = [client.post(f"{home}hand-in", files=upload(data)) for _ in range(2)]
    assert [str(one.url) for one in answers] == [f"http://testserver{home}receipt/{before + 1}"] * 2
    assert len(server.context.desk.hand_ins("s02")) == before + 1


def test_a_file_after_the_last_day_is_kept_and_called_late(server: "Server") -> None:
    server.clock.now = datetime(2026, 12, 2, 12, tzinfo=UTC)
    client, home = server.client(), server.home("s03")
    assert "after the last day" in client.post(f"{home}hand-in", files=upload(b"late")).text


@pytest.mark.parametrize(
    ("hour", "written"), [(time(18), "18:00 UTC+3"), (time(23, 59, 59), ""), (None, "")]
)
def test_a_deadline_within_a_day_is_told_with_its_hour(hour: time | None, written: str) -> None:
    zone = ZoneInfo("Europe/Moscow")
    deadline = None if hour is None else datetime.combine(date(2026, 12, 1), hour, zone)
    assert hour_of(deadline, Words("ru")).replace(NO_BREAK_SPACE, " ") == written


def test_the_page_says_that_the_last_day_is_over_before_anything_is_sent(server: "Server") -> None:
    client, home = server.client(), server.home("s03", days=90)
    assert "is over" not in client.get(home).text
    server.clock.now = datetime(2026, 12, 2, 12, tzinfo=UTC)
    assert "is over" in client.get(home).text


def test_a_clock_that_goes_back_and_two_tabs_lose_nothing_and_keep_the_order(
    server: "Server",
) -> None:
    tabs, home = [server.client(), server.client()], server.home("s03", days=90)
    before = len(server.context.desk.hand_ins("s03"))
    for number, hours in enumerate((50, 2, 1)):
        server.clock.now = BEGAN + timedelta(hours=hours)
        answer = tabs[number % 2].post(f"{home}hand-in", files=upload(b"tab %d" % number))
        assert answer.status_code == 200
    kept = server.context.desk.hand_ins("s03")[before:]
    assert [one.number for one in kept] == [before + 1, before + 2, before + 3]
    assert (
        latest(server.context, {"s03": kept})["s03"].digest == hashlib.sha256(b"tab 2").hexdigest()
    )
    page = tabs[0].get(home).text
    assert all(f"receipt/{one.number}" in page for one in kept)


def test_who_closes_in_the_middle_of_an_upload_has_handed_in_nothing(server: "Server") -> None:
    client, home = server.client(), server.home("s02")
    before = server.context.desk.hand_ins(), server.context.desk.checks()
    head = b'--x\r\ncontent-disposition: form-data; name="file"; filename="a.xlsx"\r\n\r\nPK'
    begun = {"type": "http.request", "body": head, "more_body": True}
    parts = [begun, {"type": "http.disconnect"}]
    statuses: list[int] = []

    async def receive() -> "Message":
        return parts.pop(0) if len(parts) > 1 else parts[0]

    async def send(message: "Message") -> None:
        if message["type"] == "http.response.start":
            statuses.append(message["status"])

    for action in ("hand-in", "check"):
        headers = [
            (b"content-type", b"multipart/form-data; boundary=x"),
            (b"content-length", b"999"),
        ]
        scope = {"type": "http", "method": "POST", "path": f"{home}{action}", "headers": headers}
        scope |= {"query_string": b"", "root_path": "", "http_version": "1.1", "server": ("t", 80)}
        asyncio.run(client.app({**scope, "client": ("t", 1), "scheme": "http"}, receive, send))
        parts.insert(0, begun)
    assert statuses == [499, 499]
    assert (server.context.desk.hand_ins(), server.context.desk.checks()) == before


@pytest.mark.parametrize(
    ("head", "body", "status"),
    [
        ({"content-type": "multipart/form-data"}, b"x", 400),
        (
            {"content-type": "multipart/form-data; boundary=x", "content-length": "30000000"},
            b"",
            413,
        ),
    ],
)
def test_whatever_is_wrong_with_a_form_is_said_in_the_students_language_with_a_way_back(
    server: "Server", head: dict[str, str], body: bytes, status: int
) -> None:
    home = server.home("s02")
    answer = server.client().post(
        f"{home}hand-in", content=body, headers={**head, "accept-language": "en"}
    )
    assert answer.status_code == status
    assert 'lang="uk"' in answer.text
    assert f'href="{home}"' in answer.text


@pytest.mark.parametrize("name", [".", "a/..", "/", "   "])
def test_a_file_is_called_something(server: "Server", name: str) -> None:
    answer = server.client().post(
        f"{server.home('s03')}hand-in", files={"file": (name, name.encode() * 9)}
    )
    assert answer.status_code == 200
    assert server.context.desk.hand_ins("s03")[-1].name == "file"


def test_a_form_without_a_file_is_answered_with_a_sentence(server: "Server") -> None:
    # On a day of its own: what others checked and handed in a minute ago would count.
    server.clock.now += timedelta(days=11)
    client, home = server.client(), server.home("s03")
    for action in ("check", "hand-in"):
        answer = client.post(f"{home}{action}", data={"file": ""})
        assert (answer.status_code, "Choose your workbook" in answer.text) == (400, True)
    assert client.post(f"{home}hand-in", files=upload(b"", "empty.xlsx")).status_code == 400


def test_pages_that_are_filled_at_once_do_not_take_each_others_functions(
    server: "Server",
) -> None:
    client, home = server.client(), server.home("s01")
    environment = template_environment(server.context.course.root / "templates", "ru")
    client.get(home)
    offered = environment.globals["when"]
    client.get(home)
    assert environment.globals["when"] is offered
