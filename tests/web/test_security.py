"""A link opens one student's things alone; nothing of the server's own gets out."""

import asyncio
import logging
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from starlette.routing import Route
from starlette.testclient import TestClient
from starlette.types import Message, Receive, Scope, Send

from gripcourse.access.desk.links import SignedLink, link_text
from gripcourse.usecases.serving.living import LivingCourse
from gripcourse.web.checking import make_checkers
from gripcourse.web.guard import LARGEST_BODY, Guard
from gripcourse.web.rates import HAND_INS
from gripcourse.web.site import Site
from gripcourse.web.student import student_routes

if TYPE_CHECKING:
    from web.conftest import Server

SECRET = b"the work of s03"
END = datetime(2026, 12, 31, tzinfo=UTC)
# Every route of a student, below the link. A new one is found by the first test.
ROUTES = (
    ("GET", ""),
    ("GET", "assignment.pdf"),
    ("GET", "workbook.xlsx"),
    ("POST", "check"),
    ("POST", "hand-in"),
    ("GET", "receipt/1"),
    ("GET", "file/1"),
    ("GET", "report.pdf"),
    ("POST", "request"),
)


def ask(server: "Server", method: str, path: str) -> tuple[int, bytes]:
    files = {"file": ("work.xlsx", b"PK")} if method == "POST" else None
    answer = server.client().request(method, path, files=files)
    return answer.status_code, answer.content


@pytest.fixture
def neighbour(server: "Server") -> "Server":
    """The third student has handed in something."""
    home = server.home("s03")
    server.client().post(f"{home}hand-in", files={"file": ("secret.xlsx", SECRET)})
    return server


def test_every_route_of_a_student_is_tried(server: "Server") -> None:
    site = Site(LivingCourse(server.context), make_checkers(server.context, 1, None), server.clock)
    assert {
        (next(iter(route.methods - {"HEAD"})), route.path.removeprefix("/s/{token}/"))
        for route in student_routes(site)
        if isinstance(route, Route) and route.methods
    } == {(method, path.replace("/1", "/{number:int}")) for method, path in ROUTES}


@pytest.mark.parametrize(("method", "path"), ROUTES)
def test_a_neighbours_link_opens_nothing_of_a_student(
    neighbour: "Server", method: str, path: str
) -> None:
    third = neighbour.classroom.register["s03"]
    _, content = ask(neighbour, method, f"{neighbour.home('s02')}{path}")
    for own in (SECRET, b"secret.xlsx", third.student.name.encode(), third.signature.encode()):
        assert own not in content


@pytest.mark.parametrize(("method", "path"), ROUTES)
def test_a_forged_an_expired_and_a_revoked_link_open_nothing(
    neighbour: "Server", method: str, path: str
) -> None:
    good, course = neighbour.home("s03"), neighbour.context.course.id
    links = {
        "forged": (f"/s/{link_text(SignedLink('s03', END, 0), bytes(32), course)}/", 404),
        "other course": (
            f"/s/{link_text(SignedLink('s03', END, 0), neighbour.context.key, 'other')}/",
            404,
        ),
        "neighbour's code": (good.replace("s03", "s01"), 404),
        "later": (good.replace("~0~", "~00~"), 404),
        "expired": (neighbour.home("s03", days=-1), 410),
        "revoked": (
            f"/s/{link_text(SignedLink('s03', END, 7), neighbour.context.key, course)}/",
            410,
        ),
    }
    before = neighbour.context.desk.hand_ins(), neighbour.context.desk.checks()
    name = neighbour.classroom.register["s03"].student.name.encode()
    for link, status in links.values():
        found, content = ask(neighbour, method, f"{link}{path}")
        assert found == status
        assert name not in content
        assert SECRET not in content
    assert (neighbour.context.desk.hand_ins(), neighbour.context.desk.checks()) == before


def test_a_link_of_ours_is_refused_in_its_owners_language_and_no_other(server: "Server") -> None:
    english, client = {"accept-language": "en"}, server.client()
    expired, forged = server.home("s02", days=-1), server.home("s02", days=-1)[:-2] + "!/"
    key, course = server.context.key, server.context.course.id
    revoked = f"/s/{link_text(SignedLink('s02', END, 7), key, course)}/"
    gone = f"/s/{link_text(SignedLink('s99', END, 0), key, course)}/"
    own = [client.get(one, headers=english) for one in (expired, revoked)]
    others = [client.get(one, headers=english) for one in (forged, gone)]
    assert ["минув" in own[0].text, "замінено" in own[1].text] == [True, True]
    assert all("This link is not valid" in one.text for one in others)
    token = {"authorization": f"Bearer {expired.split('/')[2]}"}
    assert "минув" in client.get("/api/v1/status", headers=token).json()["detail"]


@pytest.mark.parametrize(
    "path",
    [
        "file/../../../../private/key",
        "file/%2e%2e%2f%2e%2e%2fprivate%2fkey",
        "..%2f..%2fprivate/key",
        "report.pdf/../../key",
        "file/0",
        "file/-1",
        "file/99999999999999999999",
    ],
)
def test_no_path_leads_to_another_file(server: "Server", path: str) -> None:
    status, content = ask(server, "GET", f"{server.home('s01')}{path}")
    assert status == 404
    assert server.context.key.hex().encode() not in content


@pytest.mark.parametrize("path", ["/s/x/receipt/", "/desk/student/x/file/", "/api/v1/hand-ins/"])
def test_a_number_that_is_too_long_to_be_read_is_no_incident(server: "Server", path: str) -> None:
    answer = server.client().get(f"{path}{'9' * 5000}")
    assert answer.status_code == 414
    assert answer.headers["cache-control"] == "no-store"


@pytest.mark.parametrize("charset", ["undefined", "punycode", "unicode_escape", "utf-7", "utf-16"])
def test_a_form_in_an_encoding_that_no_browser_sends_is_refused(
    server: "Server", signed_in: TestClient, charset: str
) -> None:
    body = (
        b'--edge\r\nContent-Disposition: form-data; name="file"; filename="\\ud800.xlsx"\r\n\r\n'
        b'PK\r\n--edge\r\nContent-Disposition: form-data; name="form_key"\r\n\r\n\\ud800+2AA-\r\n'
        b"--edge--\r\n"
    )
    kind = f"multipart/form-data; boundary=edge; charset={charset}"
    told = {"Content-Type": kind}
    before = server.context.desk.hand_ins("s01")
    sent = server.client().post(f"{server.home('s01')}hand-in", content=body, headers=told)
    assert (
        sent.status_code,
        signed_in.post("/desk/sign-out", content=body, headers=told).status_code,
    ) == (400, 400)
    assert server.context.desk.hand_ins("s01") == before


def test_a_form_that_names_its_usual_encoding_is_read(server: "Server") -> None:
    body = (
        b'--e\r\nContent-Disposition: form-data; name="file"; filename="a.xlsx"'
        b"\r\n\r\nPK\r\n--e--\r\n"
    )
    told = {"Content-Type": 'multipart/form-data; boundary=e; charset="UTF-8"'}
    client = server.client()
    assert (
        client.post(f"{server.home('s01')}hand-in", content=body, headers=told).status_code == 200
    )


@pytest.mark.parametrize("below", ["", "/course"])
def test_a_link_without_its_last_stroke_leads_to_our_own_path_whatever_host_is_named(
    server: "Server", below: str
) -> None:
    client = server.client(below)
    for path in (server.home("s01").rstrip("/"), "/desk"):
        head = {"host": "other.example"}
        answer = client.get(f"{below}{path}", headers=head, follow_redirects=False)
        assert answer.is_redirect
        assert answer.headers["location"] == f"{below}{path}/"
    for path in ("/desk/marking/", "/api/v1/status/", "/s"):
        assert client.get(path, follow_redirects=False).status_code == 404


@pytest.mark.parametrize("path", ["/", "/style.css", "/nowhere", "/desk/", "/s/x/"])
def test_a_browser_is_told_to_run_and_to_fetch_nothing(server: "Server", path: str) -> None:
    headers = server.client().get(path).headers
    policy = headers["content-security-policy"]
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy
    assert headers["referrer-policy"] == "no-referrer"
    assert headers["x-content-type-options"] == "nosniff"


def test_pages_have_no_script_and_nothing_of_another_server(server: "Server") -> None:
    page = server.client().get(server.home("s01")).text
    assert "<script" not in page
    assert " on" not in {part[:3] for part in page.split("<")}
    assert "http" not in page.replace("http://www.w3.org", "")


def test_what_a_student_calls_a_file_is_shown_and_never_run(server: "Server") -> None:
    name = "<img src=x onerror=alert(1)>.xlsx"
    answer = server.client().post(
        f"{server.home('s02')}hand-in", files={"file": (name, b"PK other")}
    )
    assert "<img" not in answer.text
    assert "&lt;img" in answer.text


def test_more_than_a_workbook_is_refused_before_and_while_it_is_read(server: "Server") -> None:
    path, head = f"{server.home('s01')}hand-in", {"content-type": "multipart/form-data; boundary=x"}
    before = server.context.desk.hand_ins()

    def flood() -> Iterator[bytes]:
        yield b'--x\r\ncontent-disposition: form-data; name="file"; filename="a"\r\n\r\n'
        for _ in range(LARGEST_BODY // 1_000_000 + 1):
            yield bytes(1_000_000)

    client = server.client()
    declared = {**head, "content-length": str(LARGEST_BODY + 1)}
    assert client.post(path, content=b"", headers=declared).status_code == 413
    assert client.post(path, content=flood(), headers=head).status_code == 413
    assert server.context.desk.hand_ins() == before


@pytest.mark.parametrize("declared", ["content-length", "transfer-encoding"])
def test_who_still_sends_is_heard_out_before_a_refusal_is_said(declared: str) -> None:
    sent = [{"type": "http.request", "body": b"x", "more_body": left > 0} for left in (2, 1, 0)]
    said: list[str] = []

    async def receive() -> Message:
        said.append("heard")
        return sent.pop(0)

    async def send(message: Message) -> None:
        said.append(str(message["type"]))

    async def refuse(_: Scope, _receive: Receive, send: Send) -> None:
        await send({"type": "http.response.start", "status": 404, "headers": []})

    scope = {"type": "http", "path": "/", "headers": [(declared.encode(), b"3")]}
    asyncio.run(Guard(refuse, secure=False)(scope, receive, send))
    assert said == ["heard"] * 3 + ["http.response.start"]


def test_who_hands_in_all_the_time_has_to_wait(server: "Server") -> None:
    client, path = server.client(), f"{server.home('s02')}hand-in"
    answers = [
        client.post(path, files={"file": ("a.xlsx", b"always the same")}).status_code
        for _ in range(HAND_INS.times + 1)
    ]
    assert answers == [200] * HAND_INS.times + [429]


def test_a_full_disk_is_said_and_nothing_is_recorded(
    server: "Server", monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("gripcourse.usecases.serving.hand_in.write_bytes", full)
    before = server.context.desk.hand_ins()
    client = server.client()
    answer = client.post(f"{server.home('s03')}hand-in", files={"file": ("a.xlsx", b"new bytes")})
    assert answer.status_code == 503
    assert "No space left" not in answer.text
    assert server.context.desk.hand_ins() == before


def test_an_incident_has_a_number_and_the_log_neither_link_nor_key(
    server: "Server", monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def fail(*_: object) -> None:
        raise ValueError("unforeseen")

    monkeypatch.setattr("gripcourse.web.student.plan_of", fail)
    client = server.client(raises=False)
    home = server.home("s01")
    with caplog.at_level(logging.DEBUG):
        answer = client.get(home)
    assert answer.status_code == 500
    ours = "".join(one.getMessage() for one in caplog.records if one.name.startswith("gripcourse"))
    assert ours.startswith("incident ")
    assert home.split("~")[-1].strip("/") not in ours
    assert server.context.key.hex() not in caplog.text


def test_what_is_handed_in_is_only_its_owners(neighbour: "Server") -> None:
    folder = neighbour.context.private / "handed_in"
    assert all(one.stat().st_mode & 0o077 == 0 for one in (folder, *folder.iterdir()))
    assert Path(folder).is_relative_to(neighbour.context.private)
