"""The desk sees everybody: figures, flags with their evidence, a batch that is being graded."""

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from html import unescape
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.machine.content import NamedBytes
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from gripcourse.usecases.grading.progress import batch_progress, progress_noted
from gripcourse.usecases.serving.begin_grading import begin_grading
from gripcourse.usecases.serving.figures import group_figures
from gripcourse.usecases.serving.hand_in import hand_in
from web.conftest import form_key

if TYPE_CHECKING:
    from starlette.testclient import TestClient

    from web.conftest import Server


def handed_in(server: "Server", student: str, name: str, data: bytes) -> int:
    issued = server.classroom.register[student]
    made = hand_in(server.context, issued, NamedBytes(name, data), server.clock.now)
    return made.hand_in.number


@contextmanager
def results(server: "Server", *reports: dict[str, object]) -> Iterator[None]:
    """Let the last batch have found this."""
    path = server.graded / "grades.json"
    before = path.read_bytes() if path.is_file() else None
    path.parent.mkdir(exist_ok=True)
    path.write_text(json.dumps({"reports": reports}), encoding="utf-8")
    yield
    path.unlink() if before is None else path.write_bytes(before)


def answer(quantity: str, typed: str, reference: float) -> dict[str, object]:
    return {"quantity": quantity, "typed": typed, "reference": reference}


def test_figures_show_how_scores_are_spread_and_say_it_in_words(
    server: "Server", signed_in: "TestClient", filled: bytes, tmp_path: Path
) -> None:
    handed_in(server, "s01", "work.xlsx", filled)
    server.grade(tmp_path)
    found = group_figures(server.context)
    assert (found.works, sum(found.scores)) == (1, 1)
    assert found.mean is not None
    assert found.scores[min(int(found.mean * 10), 9)] == 1
    assert all(0 <= one.share <= 1 and one.works == 1 for one in (*found.sections, *found.items))
    assert [one.id for one in found.sections] == [one.id for one in server.context.course.sections]
    page = unescape(signed_in.get("/desk/figures").text)
    assert 'role="img"' in page
    low = 10 * min(int(found.mean * 10), 9)
    assert f"{low}–{low + 10} %: 1." in page
    assert page.count('<th scope="row">') == len(found.sections) + min(12, len(found.items))


def test_a_flag_stands_with_its_evidence_beside_the_other_work(
    server: "Server", signed_in: "TestClient"
) -> None:
    said = {"en": "<b>alike</b>", "ru": "<b>похожи</b>"}
    flag = {"code": "same_answers", "message": said["ru"], "in_languages": said}
    flag |= {"others": ["s02", "gone"]}
    flagged = {
        "file": "work/s01.xlsx",
        "student": "s01",
        "flags": [{**flag, "rests_on": ["grip_force"]}],
        "findings": [answer("grip_force", "123,4", 99.5)],
    }
    other = {"file": "s02.xlsx", "student": "s02", "flags": [{"code": "old", "message": "no ids"}]}
    stranger = {"file": "x.xlsx", "student": "", "flags": [], "findings": []}
    findings = [answer("grip_force", "123.4", 123.4)]
    with results(server, flagged, {**other, "findings": findings}, stranger):
        listed = signed_in.get("/desk/flags").text
        english = signed_in.get("/desk/flags", headers={"Accept-Language": "en"}).text
        page = signed_in.get("/desk/student/s01").text
        group = signed_in.get("/desk/").text
    assert listed.count('<p lang="ru">&lt;b&gt;похожи&lt;/b&gt;') == 1
    assert english.count('<p lang="en">&lt;b&gt;alike&lt;/b&gt;') == 1
    assert '<p lang="ru">no ids' in english
    assert "x.xlsx" not in listed
    assert 'href="/desk/student/s01#flags"' in listed
    assert "&lt;b&gt;похожи&lt;/b&gt;" in page
    assert 'href="/desk/student/s02"' in page
    row = page.split('<th scope="row">')[1].split("</tr>")[0]
    right = [
        solve_variant(server.classroom.plan(one), server.classroom.register[one].variant.given)
        for one in ("s01", "s02")
    ]
    numbers = {Words("ru").number(one["grip_force"], 7) for one in right}
    assert len(numbers) == 2
    assert all(said in row for said in ("123,4", "123.4", "усилие зажима", *numbers))
    assert group.count('class="tag"') >= 2


def test_how_far_a_batch_is_can_be_watched_and_no_other_is_begun_beside_it(
    server: "Server", signed_in: "TestClient"
) -> None:
    server.graded.mkdir(exist_ok=True)
    key = form_key(signed_in)
    with progress_noted(server.graded, lambda *_: lambda: None) as step:
        step("files", 3)()
        for path, live in (("/desk/grading", False), ("/desk/grading?live=yes", True)):
            shown = signed_in.get(path)
            assert "0 / 3" in shown.text
            assert ("refresh" in shown.headers) == live
            assert "http-equiv" not in shown.text
        refused = signed_in.post("/desk/grading", data={"form_key": key})
        assert refused.status_code == 409
    assert batch_progress(server.graded) is None
    assert "refresh" not in signed_in.get("/desk/grading?live=yes").headers


def test_a_batch_of_a_program_that_was_killed_keeps_nobody_from_beginning_again(
    server: "Server", signed_in: "TestClient", monkeypatch: pytest.MonkeyPatch
) -> None:
    server.graded.mkdir(exist_ok=True)
    stale = {"phase": "grading", "done": 1, "total": 9, "at": "2020-01-01T00:00:00+00:00"}
    path = server.graded / "progress.json"
    path.write_text(json.dumps({**stale, "began": stale["at"]}), encoding="utf-8")
    ended = subprocess.Popen([sys.executable, "-c", "raise SystemExit(3)"])
    ended.wait()
    monkeypatch.setattr("gripcourse.web.desk_acts.begin_grading", lambda *_: ended)
    key = form_key(signed_in)
    assert 'name="form_key"' in signed_in.get("/desk/grading").text.split("<main")[1]
    assert signed_in.post("/desk/grading", data={"form_key": key}).status_code == 200
    path.unlink()
    assert 'role="alert"' in signed_in.get("/desk/grading").text


def test_a_batch_is_the_command_of_the_command_line_on_the_last_workbooks_as_they_came(
    server: "Server", monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[list[str]] = []
    monkeypatch.setattr(subprocess, "Popen", lambda command, **_: asked.append(command))
    handed_in(server, "s02", "a.xlsx", b"PK workbook")
    handed_in(server, "s02", "b.PDF", b"drawing")
    begin_grading(server.context, server.graded, 2, "Dr. Ray", "once")
    assert asked[0][1:5] == ["-P", "-m", "gripcourse", "grade"]
    work = Path(asked[0][5])
    assert (work / "s02.xlsx").read_bytes() == b"PK workbook"
    assert (work / "s02.xlsx").stat().st_mtime == server.clock.now.timestamp()
    assert "--out" in asked[0]
    assert {"--by=Dr. Ray", "--why=once"} <= set(asked[0])
    assert f"--whose={work / 's02.xlsx'}=s02" in asked[0]
    assert not list(work.glob("*.pdf"))
