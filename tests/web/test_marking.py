"""Marking and regrading at the desk: the library's calls, with who and why."""

import re
from dataclasses import replace
from datetime import timedelta
from html import unescape
from typing import TYPE_CHECKING

import pytest

from gripcourse.gradebook.journal import Regrade, Signed, regrades
from gripcourse.gradebook.store import Gradebook
from gripcourse.gradebook.works import works_of
from gripcourse.usecases.marks.regrade import Regrading
from gripcourse.web.group import row_of
from web.conftest import form_key, sign_in

if TYPE_CHECKING:
    from pathlib import Path

    from starlette.testclient import TestClient

    from web.conftest import Server

DRAWING = "general_view_drawing"
PAGE = f"/desk/marking/s01/{DRAWING}"
LINES = {"line:sizes": "1", "line:assembly": "0,5", "line:standards": "0"}


@pytest.fixture
def graded(server: "Server", filled: bytes, tmp_path: "Path") -> "Server":
    """The first student's file is graded."""
    files = {"file": ("work.xlsx", filled)}
    assert server.client().post(f"{server.home('s01')}hand-in", files=files).status_code == 200
    server.grade(tmp_path)
    return server


def book(server: "Server") -> Gradebook:
    return Gradebook(server.context.desk.engine)


def places(page: str) -> list[str]:
    return re.findall(r'href="(/desk/marking/[^"]+)"', page)


def test_an_item_is_marked_by_its_rubric_and_the_next_one_is_a_key_away(
    graded: "Server", signed_in: "TestClient"
) -> None:
    key = form_key(signed_in)
    waits = list(dict.fromkeys(places(signed_in.get("/desk/marking").text)))
    assert PAGE in waits
    page = signed_in.get(PAGE).text
    assert page.count('name="line:') == 3
    assert 'accesskey="p"' in page or 'accesskey="n"' in page
    assert "<script" not in page
    seen = re.search(r'name="seen" value="(\d+)"', page)
    assert seen is not None
    draft = {"form_key": key, "comment": "<b>well</b> drawn", "seen": seen[1], **LINES}
    for wrong, value in (("line:sizes", "1.5"), ("line:sizes", "much")):
        refused = signed_in.post(PAGE, data={**draft, wrong: value}).text
        assert 'role="alert"' in refused
        assert "&lt;b&gt;well&lt;/b&gt; drawn" in refused
        assert f'value="{value}"' in refused
    assert signed_in.post(PAGE, data=draft).status_code == 200
    # The same page in another tab: it would silently take the place of this mark.
    assert signed_in.post(PAGE, data=draft | {"line:sizes": "0"}).status_code == 409
    marks = [one.mark for one in book(graded).entries({"s01"}) if one.mark.quantity == DRAWING]
    mark = marks[-1]
    assert (mark.quantity, mark.marker, mark.comment) == (DRAWING, "Dr. Ноль", "<b>well</b> drawn")
    assert mark.credit == pytest.approx(0.55)
    assert PAGE not in places(signed_in.get("/desk/marking").text)


def marked(browser: "TestClient", page: str, **values: str) -> str:
    """Send what an instructor enters on a page of marking, and return what is shown then."""
    seen = re.search(r'name="seen" value="(\d+)"', browser.get(page).text)
    assert seen is not None
    draft = {"form_key": form_key(browser), "seen": seen[1], **values}
    return unescape(browser.post(page, data=draft).text)


def test_a_mark_is_corrected_where_it_was_entered(
    graded: "Server", signed_in: "TestClient"
) -> None:
    lines = LINES | {"line:sizes": "0"}
    marked(signed_in, PAGE, **LINES, comment="too much")
    page = unescape(signed_in.get(PAGE).text)
    assert "<q>too much</q>" in page
    assert PAGE in places(signed_in.get("/desk/student/s01").text)
    marked(signed_in, PAGE, **lines, comment="rather so")
    marks = [one.mark for one in book(graded).entries({"s01"}) if one.mark.quantity == DRAWING]
    assert [one.comment for one in marks[-2:]] == ["too much", "rather so"]
    assert marks[-1].credit == pytest.approx(0.15)


def test_what_the_program_found_is_overruled_with_a_reason(
    graded: "Server", signed_in: "TestClient"
) -> None:
    """A student asks for another look: whoever answers needs no command line."""
    page = "/desk/marking/s01/grip_force"
    asked = graded.clock.now - timedelta(hours=1)
    graded.context.desk.add_request("s01", "grip_force", "Please look again.", asked)
    assert '<a href="/desk/student/s01">' in signed_in.get("/desk/?state=asks").text
    before = row_of(graded.context, "s01")
    assert page in places(signed_in.get("/desk/student/s01").text)
    shown = signed_in.get(page, headers={"accept-language": "en"}).text
    assert "The program found" in shown
    assert 'rel="next"' not in shown
    refused = marked(signed_in, page, credit="0.5", comment="")
    assert 'role="alert"' in refused
    after = marked(signed_in, page, credit="0.5", comment="Read wrongly by us.")
    assert "Read wrongly by us." in after
    answered = row_of(graded.context, "s01")
    assert before is not None
    assert answered is not None
    assert answered.requests < before.requests
    (mark,) = [
        one.mark for one in book(graded).entries({"s01"}) if one.mark.quantity == "grip_force"
    ]
    assert (mark.credit, mark.marker) == (0.5, "Dr. Ноль")


def test_nothing_waits_of_who_is_not_there(signed_in: "TestClient") -> None:
    for path in ("nobody/general_view_drawing", "s01/nothing"):
        assert signed_in.get(f"/desk/marking/{path}").status_code == 404


def test_a_regrade_counts_only_as_it_was_shown_and_with_a_reason(
    graded: "Server", added_to_policy: "Path"
) -> None:
    context = graded.context
    added_to_policy.write_text("share = 0.5\n", encoding="utf-8")
    stricter = replace(context.policy, carried_credit=0.5)
    later = replace(graded, context=replace(context, policy=stricter))
    client, before = sign_in(later), len(regrades(book(graded)))
    key = form_key(client)
    page = client.post("/desk/regrading", data={"form_key": key}).text
    assert "<li>grader/early&amp;late.toml: добавлен</li>" in page
    shown = unescape(page)
    found = re.search(r'name="seen" value="([0-9a-f]{64})"', shown)
    assert found is not None
    assert "Иванова" in shown
    apply, form = "/desk/regrading/apply", {"form_key": key, "seen": found[1]}
    assert client.post(apply, data={**form, "why": " "}).status_code == 409
    assert client.post(apply, data={**form, "seen": "0" * 64, "why": "so"}).status_code == 409
    assert len(regrades(book(graded))) == before
    form |= {"allow_lower": "yes", "why": "<i>the department</i> decided"}
    done = client.post(apply, data=form)
    assert "&lt;i&gt;the department&lt;/i&gt; decided" in done.text
    kept = regrades(book(graded))[-1]
    assert (kept.signed.person, kept.signed.why) == ("Dr. Ноль", "<i>the department</i> decided")
    again = client.post("/desk/regrading", data={"form_key": key}).text
    assert 'name="seen"' not in again
    client.post("/desk/regrading/undo", data={"form_key": key, "why": "a mistake"})
    assert regrades(book(graded))[-1].undoes == kept.number


@pytest.mark.parametrize("word", ["", "yes"])
def test_that_told_results_may_get_worse_is_said_at_the_desk_too(
    graded: "Server", monkeypatch: pytest.MonkeyPatch, word: str
) -> None:
    asked = list[bool]()

    def take_back(_: str, signed: Signed, __: object, *, allow_lower: bool) -> Regrade:
        asked.append(allow_lower)
        return Regrade(2, 1, signed)

    monkeypatch.setattr("gripcourse.web.desk_acts.undo_regrade", take_back)
    client = sign_in(graded)
    form = {"form_key": form_key(client), "why": "a mistake", "allow_lower": word}
    assert client.post("/desk/regrading/undo", data=form).status_code == 200
    assert asked == [word == "yes"]


def test_works_that_were_graded_and_never_handed_in_are_named(
    graded: "Server", monkeypatch: pytest.MonkeyPatch
) -> None:
    (work, *_) = works_of(book(graded).standing({"s01"}))["s01"]
    found = Regrading((), (), (), missing=(work,), incidents=())
    monkeypatch.setattr("gripcourse.web.regrading.regrading_now", lambda _: found)
    client = sign_in(graded)
    page = client.post("/desk/regrading", data={"form_key": form_key(client)}).text
    assert re.search(r'class="notice">[^<]*Иванова Анна', page) is not None


def test_what_fails_on_our_side_in_a_regrade_is_logged(
    graded: "Server", monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def fail(*_: object) -> None:
        raise ValueError("unforeseen")

    monkeypatch.setattr("gripcourse.batch.one_file.interpret", fail)
    client = sign_in(graded)
    assert client.post("/desk/regrading", data={"form_key": form_key(client)}).status_code == 200
    assert "unforeseen" in caplog.text
