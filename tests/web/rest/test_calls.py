"""What programs can do: the same as the pages, of the same library, kept in the same way."""

import hashlib
import json
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from gripcourse.api.results import CheckResult
from gripcourse.web.rates import HAND_INS
from gripcourse.web.refusals import STATUS, Code
from gripcourse.web.rest.app import OPERATIONS, REST
from gripcourse.web.rest.declare import PLACES, TokenRole
from gripcourse.web.rest.openapi import description

if TYPE_CHECKING:
    from httpx2 import Response
    from starlette.testclient import TestClient

    from web.conftest import Server
    from web.rest.conftest import Api

DOCUMENT = description(OPERATIONS, REST)
# Its import takes a second: only the process that runs these tests pays for it.
# ruff: noqa: PLC0415


@cache
def schema() -> Any:  # noqa: ANN401 (a library's own, without a public name)
    """Read the description as a library reads it that is not ours."""
    import schemathesis

    return schemathesis.openapi.from_dict(DOCUMENT)


class Program:
    """A program with a token; each of its answers is held against the description."""

    def __init__(self, client: "TestClient", token: str, language: str = "") -> None:
        self.client = client
        self.headers = {"Authorization": f"Bearer {token}", "Accept-Language": language}

    def ask(self, method: str, path: str, described: str = "", **sent: object) -> "Response":
        answer = self.client.request(method, f"{REST}{path}", headers=self.headers, **sent)  # type: ignore[arg-type]
        schema()[described or path][method].validate_response(answer)
        return answer


def student(api: "Api", id_: str, language: str = "") -> Program:
    return Program(api.client(), api.link(id_), language)


def instructor(api: "Api") -> Program:
    return Program(api.client(), api.token(TokenRole.INSTRUCTOR))


def test_the_description_is_that_of_the_routes(api: "Api") -> None:
    assert api.client().get(f"{REST}/openapi.json").json() == DOCUMENT
    names = [one["operationId"] for path in DOCUMENT["paths"].values() for one in path.values()]
    assert len(set(names)) == len(OPERATIONS)


def test_every_call_stands_in_the_guide() -> None:
    guide = Path(__file__).parents[3] / "docs" / "howto" / "programs.md"
    text = guide.read_text(encoding="utf-8")
    for one in OPERATIONS:
        path = PLACES.sub(r"{\1}", one.path)
        assert f"`{one.method} {path}`" in text
    for code in Code:
        assert f"`{code.value}`" in text


def test_every_code_has_a_status() -> None:
    assert set(STATUS) == set(Code)


def test_a_student_sees_the_assignment_in_the_language_that_is_asked_for(api: "Api") -> None:
    own = student(api, "s02").ask("GET", "/status").json()
    asked = student(api, "s02", "en").ask("GET", "/status").json()
    issued = api.server.classroom.register["s02"]
    assert {one["quantity"]: one["value"] for one in own["given"]} == dict(issued.variant.given)
    assert own["student"] == "s02"
    assert own["task"] != asked["task"]
    assert own["deadline"] == "2026-12-01"


def test_a_check_is_counted_and_logged_as_on_the_page(
    api: "Api", server: "Server", tmp_path: Path
) -> None:
    # Each student has three checks that compare numbers, for all tests together.
    program, filled = student(api, "s02", "en"), server.filled("s02", tmp_path)
    before = program.ask("GET", "/status").json()["checks_left"]
    answer = program.ask("POST", "/checks", files={"file": ("мой.xlsx", filled)})
    result = CheckResult.from_dict(answer.json())
    assert result.refusal == ""
    assert len(result.answers) > 20
    assert result.left == before - 1 == program.ask("GET", "/status").json()["checks_left"]
    logged = server.context.desk.checks("s02")[-1]
    assert (logged.digest, logged.told) == (hashlib.sha256(filled).hexdigest(), True)
    refused = program.ask("POST", "/checks", files={"file": ("a.xlsx", b"PK nothing")})
    assert CheckResult.from_dict(refused.json()).refusal


def test_a_receipt_is_the_one_of_the_page(api: "Api", server: "Server") -> None:
    program, data = student(api, "s02"), b"what a program hands in"
    files = {"file": ("../../work.xlsx", data)}
    made = program.ask("POST", "/hand-ins", files=files).json()
    assert made["digest"] == hashlib.sha256(data).hexdigest()
    assert made["name"] == "work.xlsx"
    path = f"/hand-ins/{made['number']}"
    assert program.ask("GET", path, "/hand-ins/{number}").json() == made
    assert program.ask("GET", f"{path}/file", "/hand-ins/{number}/file").content == data
    assert program.ask("GET", "/status").json()["hand_ins"][-1] == made
    page = server.client().get(f"{server.home('s02')}receipt/{made['number']}").text
    assert made["code"] in page
    assert program.ask("POST", "/hand-ins", files=files).json() == made
    for number in (0, 10**30):
        missing = program.ask("GET", f"/hand-ins/{number}", "/hand-ins/{number}")
        assert missing.json()["code"] == "not_found"


def test_who_hands_in_all_the_time_has_to_wait_on_both_ways(api: "Api", server: "Server") -> None:
    program = student(api, "s02")
    home, files = server.home("s02"), {"file": ("a.xlsx", b"always the same")}
    for _ in range(HAND_INS.times // 2):
        assert program.client.post(f"{home}hand-in", files=files).status_code == 200
        assert program.ask("POST", "/hand-ins", files=files).status_code == 201
    late = program.ask("POST", "/hand-ins", files=files)
    assert (late.status_code, late.json()["code"]) == (429, "too_often")
    assert late.headers["retry-after"] == "600"
    assert program.client.post(f"{home}hand-in", files=files).status_code == 429


@pytest.mark.parametrize(
    ("language", "word"), [("en", "workbook"), ("ru", "книгу"), ("uk", "книгу"), ("", "книгу")]
)
def test_what_is_refused_is_said_in_the_language_that_is_asked_for(
    api: "Api", language: str, word: str
) -> None:
    answer = student(api, "s01", language).ask("POST", "/hand-ins", data={"other": "x"})
    assert (answer.status_code, answer.json()["code"]) == (400, "no_file")
    assert word in answer.json()["detail"]
    assert answer.headers["content-language"] == (language or "ru")


@pytest.mark.parametrize(
    ("body", "status", "places"),
    [
        (b"no json", 400, []),
        (b"[" * 10_000, 400, []),
        (b"[]", 400, []),
        (b" " * 30_000, 413, []),
        (b'{"item": 1}', 422, ["item", "sentence"]),
        (b'{"item": "a", "sentence": "b", "who": "s03"}', 422, ["who"]),
        (b'{"item": "a", "sentence": "\\ud800\\u0000"}', 404, []),
    ],
)
def test_a_body_that_cannot_be_used_is_refused_with_its_places(
    api: "Api", body: bytes, status: int, places: list[str]
) -> None:
    answer = student(api, "s01", "en").ask("POST", "/requests", content=body)
    assert answer.status_code == status
    assert [one["place"] for one in answer.json()["places"]] == places


def test_a_method_that_is_none_and_an_address_that_is_none_are_refused_in_the_same_form(
    api: "Api",
) -> None:
    for method, path, status in (("PUT", "/status", 405), ("GET", "/nowhere", 404)):
        answer = api.client().request(method, f"{REST}{path}")
        assert answer.status_code == status == answer.json()["status"]
        assert answer.headers["content-type"] == "application/problem+json"
        assert answer.headers["content-security-policy"]


def test_results_are_told_from_publication_to_withdrawal_without_any_reference(
    api: "Api", server: "Server", filled: bytes, tmp_path: Path
) -> None:
    one, desk = student(api, "s01"), instructor(api)
    one.ask("POST", "/hand-ins", files={"file": ("work.xlsx", filled)})
    assert one.ask("GET", "/results").json()["code"] == "not_published"
    server.grade(tmp_path)
    wish = {"item": "grip_force", "sentence": " Please look\nat \ud800this again. "}
    body = json.dumps(wish)
    assert one.ask("POST", "/requests", content=body).json()["code"] == "not_found"
    made = desk.ask("POST", "/desk/publish", json={"why": "term over"}).json()
    assert (made["published"], made["by"], made["why"]) == (True, "Dr. Ноль", "term over")
    assert server.context.desk.publications()[-1].by == "Dr. Ноль"
    told = one.ask("GET", "/results").json()
    assert told["earned"] == told["score"]  # nothing is taken off in this course
    assert {"quantity", "title", "points", "max_points"} == set(told["items"][0])
    path = "/desk/students/{student}"
    assert desk.ask("GET", "/desk/students/s01/results", f"{path}/results").json() == told
    sentence = one.ask("POST", "/requests", content=body).json()["sentence"]
    assert sentence == "Please look at \N{REPLACEMENT CHARACTER}this again."
    assert sentence in [r["sentence"] for r in desk.ask("GET", "/desk/requests").json()["requests"]]
    assert one.ask("GET", "/results/report.pdf").content == b"%PDF report"
    report = desk.ask("GET", "/desk/students/s01/report.pdf", f"{path}/report.pdf")
    assert report.content == b"%PDF report"
    assert b"s01" in desk.ask("GET", "/desk/grades.csv").content
    record = desk.ask("GET", "/desk/students/s01", path).json()
    assert record["report"]
    assert record["hand_ins"][-1]["digest"] == hashlib.sha256(filled).hexdigest()
    desk.ask("POST", "/desk/withdraw", json={})
    assert one.ask("GET", "/results").status_code == 404
    again = desk.ask("POST", "/desk/withdraw", json={})
    assert (again.status_code, again.json()["code"]) == (409, "conflict")


def test_items_are_marked_once_by_their_rubric_and_as_they_were_seen(
    api: "Api", server: "Server", filled: bytes, tmp_path: Path
) -> None:
    student(api, "s01").ask("POST", "/hand-ins", files={"file": ("work.xlsx", filled)})
    server.grade(tmp_path)
    desk = instructor(api)
    first = next(
        one
        for one in desk.ask("GET", "/desk/marking").json()["items"]
        if one["student"] == "s01" and one["item"] != "general_view_drawing"
    )
    described, path = "/desk/marking/{student}/{item}", f"/desk/marking/s01/{first['item']}"
    shown = desk.ask("GET", path, described).json()
    assert shown["waiting"] == first
    lines = {
        one["id"]: one["levels"][-1]["credit"] if one["levels"] else 1 for one in shown["rubric"]
    }
    wish = {"seen": shown["seen"], "lines": lines, "comment": "good"}
    wrong = desk.ask("POST", path, described, json={**wish, "lines": {"nothing": 10**400}})
    assert (wrong.status_code, wrong.json()["code"]) == (422, "not_usable")
    unknown = desk.ask("POST", path, described, json={**wish, "lines": {"nothing": 1}})
    assert unknown.json()["places"]
    made = desk.ask("POST", path, described, json=wish)
    assert (made.status_code, made.json()["marker"]) == (201, "Dr. Ноль")
    again = desk.ask("POST", path, described, json=wish)
    assert (again.status_code, again.json()["code"]) == (409, "conflict")
    after = desk.ask("GET", path, described).json()["seen"]
    assert after != shown["seen"], "what is marked can be looked at, and marked otherwise"
    withdrawn = {"seen": after, "withdraw": True, "comment": "by mistake"}
    assert desk.ask("POST", path, described, json=withdrawn).json()["credit"] is None


def test_a_regrade_is_seen_before_it_counts_and_needs_a_reason(
    api: "Api", server: "Server", filled: bytes, tmp_path: Path, added_to_policy: Path
) -> None:
    student(api, "s01").ask("POST", "/hand-ins", files={"file": ("work.xlsx", filled)})
    server.grade(tmp_path)
    added_to_policy.write_text("share = 0.5\n", encoding="utf-8")
    desk = instructor(api)
    shown = desk.ask("POST", "/desk/regrading").json()
    (policy,), seen = shown["policies"], shown["seen"]
    line = {"file": "grader/early&late.toml", "key": "", "before": None, "after": ""}
    assert (len(policy["fingerprint"]), policy["lines"]) == (64, [line])
    path = "/desk/regrading/apply"
    stale = desk.ask("POST", path, json={"seen": "other", "why": "x"})
    assert (stale.status_code, stale.json()["code"]) == (409, "conflict")
    assert desk.ask("POST", path, json={"seen": seen, "why": " "}).status_code == 409
    assert desk.ask("POST", path, json={"seen": seen, "why": "new policy"}).status_code == 201
    assert desk.ask("GET", "/desk/regrading").json()["regrades"] == []
    assert desk.ask("POST", "/desk/regrading/undo", json={"why": "x"}).status_code == 409


def test_a_batch_is_begun_once_and_figures_and_flags_are_those_of_the_pages(
    api: "Api", server: "Server", monkeypatch: pytest.MonkeyPatch, filled: bytes, tmp_path: Path
) -> None:
    student(api, "s01").ask("POST", "/hand-ins", files={"file": ("work.xlsx", filled)})
    server.grade(tmp_path)
    api.batches_end_at_once(monkeypatch)
    desk = instructor(api)
    server.context.desk.add_batch(3, "Dr. Ray", "first look", server.clock.now)
    assert desk.ask("POST", "/desk/grading", json={"why": "term"}).status_code == 202
    batch = desk.ask("GET", "/desk/grading").json()["batches"][-1]
    assert (batch["files"], batch["by"], batch["why"]) == (3, "Dr. Ray", "first look")
    found = desk.ask("GET", "/desk/figures").json()
    assert found["works"] == sum(found["scores"]) == 1
    assert desk.ask("GET", "/desk/flags").json()["at"]
    path = server.graded / "grades.json"
    grades = json.loads(path.read_text(encoding="utf-8"))
    flag = {"code": "same_answers", "message": "Alike.", "others": ["s02"]}
    grades["reports"][0]["flags"] = [{**flag, "rests_on": ["grip_force"]}]
    path.write_text(json.dumps(grades), encoding="utf-8")
    (work,) = desk.ask("GET", "/desk/flags").json()["works"]
    assert (work["student"], work["codes"]) == ("s01", ["same_answers"])
    flags = "/desk/students/{student}/flags"
    (shown,) = desk.ask("GET", "/desk/students/s01/flags", flags).json()["flags"]
    (beside,) = shown["beside"]
    (number,) = beside["numbers"]
    assert (beside["student"], number["quantity"]) == ("s02", "grip_force")
    assert number["right_here"] != number["right_there"]
    assert desk.ask("GET", "/desk/students/nobody/flags", flags).status_code == 404


def test_the_group_is_searched_as_on_the_page(api: "Api") -> None:
    desk = instructor(api)

    def found(**wish: str) -> list[str]:
        members = desk.ask("GET", "/desk/group", params=wish).json()["members"]
        return [one["student"] for one in members]

    assert len(found()) == 3
    assert found(find="шевч") == ["s02"]
    assert found(group="РТК-42") == ["s03"]
    wrong = desk.ask("GET", "/desk/group", params={"state": "asleep"})
    assert (wrong.status_code, wrong.json()["places"][0]["place"]) == (422, "state")


def test_an_instructor_signs_in_once_and_out(api: "Api") -> None:
    token, client = api.token(TokenRole.SIGN_IN), api.client()
    made = Program(client, token).ask("POST", "/desk/session").json()
    assert made["name"] == "Dr. Ноль"
    assert Program(client, token).ask("POST", "/desk/session").status_code == 401
    desk = Program(client, made["session"])
    assert desk.ask("GET", "/desk/group").status_code == 200
    assert desk.ask("DELETE", "/desk/session").status_code == 204
    assert desk.ask("GET", "/desk/group").status_code == 401


def test_our_own_mistake_has_a_number(api: "Api", monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise ValueError("unforeseen")

    monkeypatch.setattr("gripcourse.web.rest.student.plan_of", fail)
    program = Program(api.client(raises=False), api.link("s01"), "en")
    answer = program.client.get(f"{REST}/status", headers=program.headers)
    assert (answer.status_code, answer.json()["code"]) == (500, "our_mistake")
    assert "unforeseen" not in answer.text
