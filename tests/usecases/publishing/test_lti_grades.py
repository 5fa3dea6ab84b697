"""Published results reach the platform's gradebook: each once, and again where it changed."""

import csv
import json
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from sqlalchemy import insert

from gripcourse.access.lti import schema
from gripcourse.access.lti.given_access import Access, Patience
from gripcourse.access.lti.model import Bond
from gripcourse.access.lti.platforms import platforms_path
from gripcourse.access.lti.tool_key import make_tool_key, read_tool_keys
from gripcourse.access.lti.web_client import make_client
from gripcourse.cli import main as cli
from gripcourse.exports.report_result import GradesResult, ReportResult
from gripcourse.issuing.withdrawal import Withdrawal
from gripcourse.machine.database.home import home_of
from gripcourse.machine.database.moments import stored
from gripcourse.machine.database.opening import writing
from gripcourse.policy.model import Policy
from gripcourse.usecases.grading.batch_tables import GRADES_CSV, GRADES_JSON
from gripcourse.usecases.marks.withdraw import withdraw as join_ids
from gripcourse.usecases.publishing.lti_grades import ScoreFate, ScoreOrder, send_grades
from gripcourse.usecases.publishing.publish import publish, withdraw
from gripcourse.usecases.serving.lti import store_of
from support.clock import BEGAN
from support.lti_course import LtiCourse, on_its_first_day, open_lti_course
from support.platform import CLAIM, LINE_ITEM, SCORE

Run = Callable[..., str]


@pytest.fixture(scope="module")
def opened(tmp_path_factory: pytest.TempPathFactory, policy: Policy) -> Iterator[LtiCourse]:
    with open_lti_course(tmp_path_factory.mktemp("lti_grades"), policy) as made:
        for hint in ("anna", "oksana"):
            assert made.come(made.client(), hint).status_code == 303
        yield made


@pytest.fixture
def school(opened: LtiCourse) -> Iterator[LtiCourse]:
    with on_its_first_day(opened) as made:
        yield made


@pytest.fixture
def run(
    school: LtiCourse, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Run:
    """Call a command as an instructor would; the platform's clock is the machine's then."""
    monkeypatch.setattr(
        "gripcourse.usecases.serving.desk.load_course", lambda _: school.context.course
    )
    monkeypatch.setattr("gripcourse.course.load.load_course", lambda _: school.context.course)
    monkeypatch.setattr(school.platform, "now", time.time)

    def said(*arguments: str) -> str:
        course = ("--course", str(school.context.course.root), "--language", "en")
        monkeypatch.setattr(sys, "argv", ["gripcourse", "lti", *arguments, *course])
        with pytest.raises(SystemExit) as ended:
            cli.main()
        return f"{ended.value.code} {''.join(capsys.readouterr())}"

    return said


def report(student: str, score: float, open_points: float = 0.0) -> ReportResult:
    return ReportResult(
        file=f"{student}.xlsx",
        student=student,
        name="Somebody",
        variant="001",
        scheme="rack_parallelogram",
        options={},
        judged=True,
        score=score,
        max_score=20.0 - open_points,
        open_points=open_points,
        flags=(),
        remarks=(),
        causes=(),
        findings=(),
    )


def release(school: LtiCourse, folder: Path, *reports: ReportResult) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    plain = GradesResult(reports, needs_person=False).to_dict()
    (folder / GRADES_JSON).write_text(json.dumps(plain), encoding="utf-8")
    (folder / GRADES_CSV).write_bytes(b"student,score\n")
    publish(school.context, folder, "Dr. Ray", "", BEGAN)


def test_results_are_sent_once_and_again_where_they_changed(
    school: LtiCourse, run: Run, tmp_path: Path
) -> None:
    unjudged = replace(report("s03", 0), judged=False, score=None, max_score=None)
    release(school, tmp_path, report("s01", 12.5), report("s02", 7, 5), unjudged, report("s04", 3))
    first = run("send-grades", "--by", "Dr. Ray")
    assert first.startswith("0 Sent: 2; unchanged: 0; without a result: 1; not seen on the")
    scores = {one["userId"]: (column, one) for column, one in school.platform.scores}
    assert set(scores) == {"user-anna", "user-oksana"}
    column, anna = scores["user-anna"]
    assert column == "/lines/1/scores?type_id=2"
    assert (anna["scoreGiven"], anna["scoreMaximum"]) == (12.5, 20.0)
    assert (anna["activityProgress"], anna["gradingProgress"]) == ("Completed", "FullyGraded")
    # In the student's language, and nothing that only the report may show.
    assert anna["comment"] == "Баллы: 12,5 из 20. Отчёт стоит на вашей странице."
    oksana = scores["user-oksana"][1]
    assert (oksana["scoreMaximum"], oksana["gradingProgress"]) == (20.0, "PendingManual")

    again = run("send-grades")
    assert again.startswith("0 Sent: 0; unchanged: 2;")
    assert len(school.platform.scores) == 2

    release(school, tmp_path, report("s01", 12.5), report("s02", 10))
    assert run("send-grades").startswith("0 Sent: 1; unchanged: 1;")
    assert school.platform.scores[-1][1]["userId"] == "user-oksana"
    kept = store_of(school.context).sent()
    assert [(one.student, one.points, one.by) for one in kept][:2] == [
        ("s01", 12.5, "Dr. Ray"),
        ("s02", 7.0, "Dr. Ray"),
    ]
    assert kept[-1].points == 10


def test_the_platform_is_sent_what_lateness_leaves(
    school: LtiCourse, run: Run, tmp_path: Path
) -> None:
    late = replace(report("s01", 16), earned=12.0, days_late=1)
    release(school, tmp_path, late, replace(report("s02", 10, 5), earned=7.5, days_late=1))
    assert run("send-grades").startswith("0 Sent: 2;")
    sent = {one["userId"]: one for _, one in school.platform.scores}
    anna, oksana = sent["user-anna"], sent["user-oksana"]
    assert (anna["scoreGiven"], anna["scoreMaximum"]) == (12, 20)
    assert anna["comment"].startswith("Баллы: 12 из 20.")
    assert anna["comment"].endswith("снято баллов: 4.")
    assert (oksana["scoreGiven"], oksana["scoreMaximum"]) == (7.5, 20)
    # A waiver after the term gives them back, and the platform hears of it.
    release(school, tmp_path, replace(late, earned=16.0, days_late=0))
    assert run("send-grades").startswith("0 Sent: 1;")
    assert school.platform.scores[-1][1]["scoreGiven"] == 16
    # Of several works the one that counts is published, wherever it stands in the batch.
    other = replace(report("s01", 5), counts=False)
    release(school, tmp_path, other, replace(late, score=14.0, earned=14.0), other)
    assert run("send-grades").startswith("0 Sent: 1;")
    assert school.platform.scores[-1][1]["scoreGiven"] == 14
    release(school, tmp_path, other)
    assert run("send-grades").startswith("0 Sent: 0;")


def test_one_that_fails_is_named_and_the_others_are_sent(
    school: LtiCourse, run: Run, tmp_path: Path
) -> None:
    release(school, tmp_path, report("s01", 1), report("s02", 2))
    school.platform.refuses.add("user-anna")
    said = run("send-grades")
    assert said.startswith("1 ")
    assert "s01: not sent. The platform takes no score of this student" in said
    assert [one["userId"] for _, one in school.platform.scores] == ["user-oksana"]
    school.platform.refuses.clear()
    assert run("send-grades").startswith("0 Sent: 1; unchanged: 1;")


def sent_by(school: LtiCourse) -> dict[str, ScoreFate]:
    """Send results without the command line, which would wait for a platform that is away."""
    context = school.context
    with make_client() as client:
        keys, patience = read_tool_keys(context.course.root), Patience(sleep=lambda _: None)
        access = Access(client, school.declared, keys, school.clock, patience)
        done = list(send_grades(context, access, ScoreOrder("", "Dr. Ray")))
    return {one.student: one.fate for one in done}


def test_what_an_outage_left_is_sent_by_the_next_time(school: LtiCourse, tmp_path: Path) -> None:
    store, declared, students = store_of(school.context), school.declared, ("s03", "s04")
    for student in students:
        user = f"user-{student}"
        store.bind(Bond(declared.issuer, declared.client_id, user, student, "", BEGAN))
    everybody = ("s01", "s02", *students)
    release(school, tmp_path, *(report(one, 3) for one in everybody))
    platform = school.platform
    platform.faults += [503] * 9
    failed, not_tried = ScoreFate.FAILED, ScoreFate.NOT_TRIED
    assert list(sent_by(school).values()) == [failed, failed, failed, not_tried]
    assert platform.scores == []

    platform.faults += [503, 500, 401]
    platform.refuses.add("user-s03")
    assert sent_by(school) == {**dict.fromkeys(everybody, ScoreFate.SENT), "s03": failed}
    platform.refuses.clear()
    assert sent_by(school) == {
        **dict.fromkeys(everybody, ScoreFate.UNCHANGED),
        "s03": ScoreFate.SENT,
    }
    users = [one["userId"] for _, one in platform.scores]
    assert users == ["user-anna", "user-oksana", "user-s04", "user-s03"]


def join(school: LtiCourse, student: str, same_as: str) -> None:
    root = school.context.course.root
    joined = Withdrawal(student, same_as, False, "One person", "Dr. Ray", BEGAN)
    join_ids(joined, root, home_of(root))


def test_the_result_of_a_person_of_two_ids_goes_to_whom_the_platform_knows_by_either(
    school: LtiCourse, tmp_path: Path
) -> None:
    join(school, "s02", same_as="s03")
    release(school, tmp_path, report("s01", 1), report("s03", 9))
    assert sent_by(school)["s03"] is ScoreFate.SENT
    assert [one["userId"] for _, one in school.platform.scores] == ["user-anna", "user-oksana"]
    assert sent_by(school)["s03"] is ScoreFate.UNCHANGED


def test_what_was_released_under_the_second_id_is_the_result_of_the_person(
    school: LtiCourse, tmp_path: Path
) -> None:
    release(school, tmp_path, report("s02", 9))
    join(school, "s02", same_as="s03")
    assert sent_by(school)["s03"] is ScoreFate.SENT
    assert [one["scoreGiven"] for _, one in school.platform.scores] == [9]


def test_of_a_batch_from_before_the_joining_the_result_is_released_to_the_person(
    school: LtiCourse, tmp_path: Path
) -> None:
    join(school, "s02", same_as="s03")
    release(school, tmp_path, report("s02", 9))
    assert sent_by(school)["s03"] is ScoreFate.SENT


def test_two_users_of_the_platform_who_were_joined_get_no_grade_that_is_guessed(
    school: LtiCourse, tmp_path: Path
) -> None:
    join(school, "s02", same_as="s01")
    release(school, tmp_path, report("s01", 1))
    assert sent_by(school)["s01"] is ScoreFate.FAILED
    assert school.platform.scores == []


def test_a_student_whom_two_claim_gets_no_grade(
    school: LtiCourse, run: Run, tmp_path: Path
) -> None:
    release(school, tmp_path, report("s02", 4))
    store, declared = store_of(school.context), school.declared
    key = (declared.issuer, declared.client_id, "user-other")
    row = dict(zip(("issuer", "client", "user"), key, strict=True))
    row |= {"course": store.course, "student": "s02", "by": "an earlier program"}
    with writing(store.engine) as connection:
        connection.execute(insert(schema.bonds), row | {"at": stored(BEGAN)})
    try:
        said = run("send-grades")
        assert "s02: not sent. Several users of the platform are this student." in said
        assert school.platform.scores == []
    finally:
        store.bind(Bond(*key, "", "race", BEGAN))


def test_a_platform_that_does_not_know_our_key_gets_nothing(
    school: LtiCourse, run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    release(school, tmp_path, report("s01", 5))
    known = school.platform.tool_keys()
    make_tool_key(school.context.course.root)
    ours = school.platform.tool_keys()["keys"]
    # The former key is still published, and the new one signs.
    assert known["keys"][0] in ours[1:]
    with monkeypatch.context() as patch:
        other = {**known["keys"][0], "kid": ours[0]["kid"]}
        patch.setattr(school.platform, "tool_keys", lambda: {"keys": [other]})
        said = run("send-grades")
    assert said.startswith("2 ")
    assert "The platform answered 401." in said
    assert school.platform.scores == []
    assert run("send-grades").startswith("0 Sent: 1;")


def test_what_is_withdrawn_is_not_sent(school: LtiCourse, run: Run, tmp_path: Path) -> None:
    release(school, tmp_path, report("s01", 6))
    withdraw(school.context, "Dr. Ray", "", BEGAN)
    said = run("send-grades")
    assert said.startswith("2 ")
    assert "Nothing is published." in said


def test_a_course_that_is_declared_no_more_gets_nothing(
    school: LtiCourse, run: Run, tmp_path: Path
) -> None:
    release(school, tmp_path, report("s01", 7))
    path = platforms_path(school.context.course.root)
    before = path.read_text(encoding="utf-8")
    path.write_text(before.replace('"course-2"', '"course-3"'), encoding="utf-8")
    try:
        assert "No place in the platform is known that takes grades." in run("send-grades")
    finally:
        path.write_text(before, encoding="utf-8")
    assert school.platform.scores == []


def test_a_column_is_made_where_there_is_none_and_found_again(
    school: LtiCourse, run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    release(school, tmp_path, report("s01", 8))
    endpoint = "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint"
    said = {
        **school.platform.users["anna"],
        endpoint: {"scope": [SCORE, LINE_ITEM], "lineitems": f"{school.platform.address}/lines"},
        f"{CLAIM}resource_link": {"id": "activity-5"},
    }
    with monkeypatch.context() as patch:
        patch.setattr(school.platform, "now", lambda: school.clock().timestamp())
        patch.setitem(school.platform.users, "anna", said)
        school.come(school.client(), "anna")
    assert run("send-grades").startswith("0 Sent: 1;")
    assert school.platform.scores[-1][0] == "/lines/9/scores"
    release(school, tmp_path, report("s01", 9))
    assert run("send-grades").startswith("0 Sent: 1;")
    (made,) = school.platform.columns
    assert made["scoreMaximum"] == school.context.policy.total
    with monkeypatch.context() as patch:
        patch.setattr(school.platform, "now", lambda: school.clock().timestamp())
        school.come(school.client(), "anna")


def test_one_of_several_places_has_to_be_named(
    school: LtiCourse, run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    release(school, tmp_path, report("s01", 11))
    with monkeypatch.context() as patch:
        patch.setattr(school.platform, "now", lambda: school.clock().timestamp())
        client = school.client()
        asked = school.begin(client, "anna")
        claims = school.platform.claims("anna", asked["nonce"])
        claims[f"{CLAIM}resource_link"] = {"id": "activity-6"}
        other = f"{school.platform.address}/lines/2"
        claims["https://purl.imsglobal.org/spec/lti-ags/claim/endpoint"]["lineitem"] = other
        sent = {"id_token": school.platform.token(claims), "state": asked["state"]}
        assert client.post("/lti/launch", data=sent).status_code == 303
    said = run("send-grades")
    assert said.startswith("2 ")
    assert other in said
    assert run("send-grades", "--line-item", other).startswith("0 Sent: 1;")
    assert school.platform.scores[-1][0] == "/lines/2/scores"


def test_the_roster_comes_from_the_platform(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "roster.csv"
    assert run("roster", "--out", str(out)).startswith("0 Students in")
    with out.open(encoding="utf-8-sig", newline="") as stream:
        rows = {row["name"]: row for row in csv.DictReader(stream)}
    assert rows["Anna"]["student"] == "s01"
    assert rows["Oksana@Example.org"]["email"] == "Oksana@Example.org"
    # All pages were read, and whoever teaches is no student.
    assert len(rows) == 5
    assert "Dr. Ray" not in rows
    assert out.stat().st_mode & 0o077 == 0


def test_who_is_unknown_is_listed_and_bound(
    school: LtiCourse, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:
        patch.setattr(school.platform, "now", lambda: school.clock().timestamp())
        assert school.come(school.client(), "nobody").status_code == 403
    listed = run("unknown")
    assert listed.startswith("1 moodle: user user-nobody (Nobody Known, who@example.org, –):")
    assert "is this student" in run("bind", "user-nobody", "s01")
    assert "has no student 's99'" in run("bind", "user-nobody", "s99")
    assert run("bind", "user-nobody", "s03").startswith("0 user-nobody is s03 from now on.")
    assert run("unknown").startswith("0 Everybody who came is known.")
    assert run("bind", "user-nobody").startswith("0 user-nobody is nobody")
    assert run("unknown").startswith("1 ")
