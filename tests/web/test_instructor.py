"""The instructor's desk: signing in once, the group, publishing; nothing without a session."""

import os
import re
from datetime import timedelta
from typing import TYPE_CHECKING

import pytest
from starlette.testclient import TestClient

from gripcourse.machine.files import write_bytes
from gripcourse.usecases.publishing.publish import current, publish, published_to, withdraw
from gripcourse.usecases.serving.living import LivingCourse
from gripcourse.usecases.serving.sign_in import SIGN_IN_MINUTES, offer_sign_in
from gripcourse.web.checking import make_checkers
from gripcourse.web.downloads import download_routes
from gripcourse.web.drawings import drawing_routes
from gripcourse.web.instructor import instructor_routes
from gripcourse.web.marking import marking_routes
from gripcourse.web.overview import overview_routes
from gripcourse.web.regrading import regrading_routes
from gripcourse.web.site import Site
from web.conftest import form_key

if TYPE_CHECKING:
    from pathlib import Path

    from web.conftest import Server

PAGES = (
    *("", "student/s01", "student/s01/file/1", "student/s01/report.pdf", "grades.csv"),
    *("marking", "marking/s01/general_view_drawing", "regrading"),
    *("figures", "flags", "grading", "student/s01/drawing/1/1.png"),
    *("hand-ins.zip", "graded/reports.zip", "graded/grades.csv"),
)
FORMS = (
    *("publish", "withdraw", "sign-out", "marking/s01/general_view_drawing"),
    *("regrading", "regrading/apply", "regrading/undo", "grading"),
)


def test_every_route_of_the_desk_is_tried(server: "Server") -> None:
    site = Site(LivingCourse(server.context), make_checkers(server.context, 1, None), server.clock)
    routes = (
        *(*instructor_routes(site), *marking_routes(site), *regrading_routes(site)),
        *(*drawing_routes(site), *overview_routes(site), *download_routes(site)),
    )
    paths = {
        (method, route.path.removeprefix("/desk/"))
        for route in routes
        for method in (route.methods or set()) - {"HEAD"}
        if "sign-in" not in route.path
    }
    tried = {("GET", one) for one in PAGES} | {("POST", one) for one in FORMS}
    places = {
        "s01": "{student}",
        "general_view_drawing": "{item}",
        "file/1": "file/{number:int}",
        "graded/grades.csv": "graded/{name}",
        "drawing/1/1.png": "drawing/{number:int}/{page:int}.png",
    }
    for value, place in places.items():
        tried = {(method, path.replace(value, place)) for method, path in tried}
    assert paths == tried


@pytest.mark.parametrize("page", PAGES)
def test_nobody_sees_the_desk_without_signing_in(server: "Server", page: str) -> None:
    answer = server.client().get(f"/desk/{page}", headers={"cookie": "gripcourse-desk=guess"})
    assert answer.status_code == 403
    assert "Иванова" not in answer.text


@pytest.mark.parametrize("form", FORMS)
def test_a_form_of_another_site_does_nothing(
    server: "Server", signed_in: TestClient, form: str
) -> None:
    before = server.context.desk.publications()
    for key in ("", "0" * 64):
        assert signed_in.post(f"/desk/{form}", data={"form_key": key}).status_code == 403
    assert server.context.desk.publications() == before
    assert signed_in.get("/desk/").status_code == 200


def test_a_link_to_sign_in_is_good_once_and_not_for_long(server: "Server") -> None:
    token = offer_sign_in(server.context, "first", server.clock.now)
    late = offer_sign_in(server.context, "late", server.clock.now)
    first, second = server.client(), server.client()
    # Somebody's preview of the link does not use it up.
    assert first.get(f"/desk/sign-in/{token}").status_code == 200
    assert first.post(f"/desk/sign-in/{token}").status_code == 200
    assert second.post(f"/desk/sign-in/{token}").status_code == 403
    server.clock.now += timedelta(minutes=SIGN_IN_MINUTES)
    assert second.post(f"/desk/sign-in/{late}").status_code == 403
    assert second.get("/desk/").status_code == 403


def test_the_cookie_is_out_of_reach_of_scripts_and_of_other_sites(server: "Server") -> None:
    token = offer_sign_in(server.context, "who", server.clock.now)
    client = server.client()
    client.cookies.set("gripcourse-desk", "chosen by somebody else")
    answer = client.post(f"/desk/sign-in/{token}", follow_redirects=False)
    cookie = answer.headers["set-cookie"]
    assert {"HttpOnly", "SameSite=strict", "Path=/desk"} <= set(cookie.split("; "))
    assert "chosen" not in cookie


def test_a_session_ends_where_somebody_signs_out_and_by_itself(
    server: "Server", signed_in: TestClient
) -> None:
    session = {"cookie": f"gripcourse-desk={signed_in.cookies['gripcourse-desk']}"}
    signed_in.post("/desk/sign-out", data={"form_key": form_key(signed_in)})
    assert server.client().get("/desk/", headers=session).status_code == 403


def test_the_group_is_searched_by_name_group_and_state(signed_in: TestClient) -> None:
    def found(**wish: str) -> int:
        page = signed_in.get("/desk/", params=wish).text
        return page.count('<th scope="row">')

    assert found() == 3
    assert found(find="шевч") == 1
    assert found(find="ШЕВЧ") == 1
    assert found(group="РТК-41") == 2
    assert found(find="nobody") == 0
    assert found(state="missing") + found(state="handed_in") == 3


def test_results_are_seen_from_publication_to_withdrawal(
    server: "Server", signed_in: TestClient, filled: bytes, tmp_path: "Path"
) -> None:
    home, student = server.home("s01"), server.client()
    if current(server.context) is not None:
        withdraw(server.context, "another test", "", server.clock.now)
    student.post(f"{home}hand-in", files={"file": ("work.xlsx", filled)})
    assert "report.pdf" not in student.get(home).text
    server.grade(tmp_path)
    key = form_key(signed_in)
    signed_in.post("/desk/publish", data={"form_key": key, "why": "<b>term</b> over"})
    assert "&lt;b&gt;term&lt;/b&gt; over" in signed_in.get("/desk/").text
    page = student.get(home).text
    assert 'class="score"' in page
    # What waits for a person has earned nothing yet, which is no zero.
    assert re.search(r"кинематическая схема в масштабе</th><td[^>]*>… / \d", page)
    assert student.get(f"{home}report.pdf").content == b"%PDF report"
    assert b"s01" in signed_in.get("/desk/grades.csv").content
    wish = {"item": "grip_force", "sentence": "Please look at <this> again."}
    assert "&lt;this&gt;" in student.post(f"{home}request", data=wish).text
    assert "&lt;this&gt;" in signed_in.get("/desk/student/s01").text
    assert student.post(f"{home}request", data={**wish, "item": "other"}).status_code == 404
    signed_in.post("/desk/withdraw", data={"form_key": key, "why": "a mistake"})
    assert 'class="score"' not in student.get(home).text
    assert student.get(f"{home}report.pdf").status_code == 404
    kept = server.context.desk.publications()[-2:]
    assert [(one.published, one.by, one.why) for one in kept] == [
        (True, "Dr. Ноль", "<b>term</b> over"),
        (False, "Dr. Ноль", "a mistake"),
    ]


def test_whoever_publishes_is_told_what_was_not_graded_yet(
    server: "Server", signed_in: TestClient, filled: bytes, tmp_path: "Path"
) -> None:
    """Marks that were entered after the last grading are in no report yet."""
    server.client().post(f"{server.home('s01')}hand-in", files={"file": ("a.xlsx", filled)})
    server.grade(tmp_path)
    grades = server.graded / "grades.json"
    said = "Newer than the last grading"

    def page(graded_at: timedelta) -> str:
        os.utime(grades, ((server.clock.now + graded_at).timestamp(),) * 2)
        return signed_in.get("/desk/", headers={"accept-language": "en"}).text

    page_before = page(-timedelta(hours=9))
    newer = re.search(f"{said}.*marks given by hand [0-9]+, workbooks [1-9]", page_before)
    assert newer is not None
    assert said not in page(timedelta(days=400))  # other tests hand in days later


def test_two_clicks_publish_twice_and_students_see_the_results(
    server: "Server", filled: bytes, tmp_path: "Path", monkeypatch: pytest.MonkeyPatch
) -> None:
    server.client().post(f"{server.home('s01')}hand-in", files={"file": ("a.xlsx", filled)})
    server.grade(tmp_path)
    context, now = server.context, server.clock.now
    second: list[int] = []

    def meanwhile(path: "Path", data: bytes, *, private: bool) -> None:
        if not second:
            second.append(0)
            second[:] = [publish(context, server.graded, "Dr. Ray", "second", now).number]
        write_bytes(path, data, private=private)

    monkeypatch.setattr("gripcourse.usecases.publishing.publish.write_bytes", meanwhile)
    first = publish(context, server.graded, "Dr. Ray", "first", now).number
    assert first < second[0]
    shown = current(context)
    assert shown is not None
    assert shown.number == second[0]
    assert published_to(context, "s01") is not None
    withdraw(context, "Dr. Ray", "a test", now)
