"""What somebody learns who uses up all checks of a student, and halves as he goes."""

import json
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gripcourse.policy.model import CheckRule
from gripcourse.simulation.write import fill
from gripcourse.solver.solve import solve_variant

if TYPE_CHECKING:
    from starlette.testclient import TestClient

    from web.conftest import Server

SECURITY = Path(__file__).parents[2] / "docs" / "security.md"


def asked(server: "Server", client: "TestClient", factor: float, folder: Path) -> dict[str, Any]:
    """Check a complete workbook in which one number of each kind is moved; return what is said."""
    plan = server.classroom.plan("s03")
    values = solve_variant(plan, server.classroom.register["s03"].variant.given)
    typed: dict[str, Any] = {one.id: values[one.id] for one in plan.answered}
    typed |= {one.id: "yes" for one in plan.answered if one.kind.value == "verdict"}
    typed["drive_force"] *= factor
    fill(server.classroom.workbook("s03"), typed, folder / "attack.xlsx")
    headers = {"Authorization": f"Bearer {server.home('s03').split('/')[2]}"}
    files = {"file": ("attack.xlsx", (folder / "attack.xlsx").read_bytes())}
    answer = client.post("/api/v1/checks", files=files, headers=headers)
    assert answer.status_code == 200
    return dict(answer.json())


def with_check(server: "Server", check: CheckRule) -> "Server":
    """Return the server of the same course with other rules for self-checks."""
    policy = replace(server.context.policy, check=check)
    return replace(server, context=replace(server.context, policy=policy))


def test_all_checks_together_tell_no_more_bits_than_the_threat_model_states(
    server: "Server", tmp_path: Path
) -> None:
    check = server.context.policy.check
    # Other tests may have asked for this student already.
    used, times = sum(one.told for one in server.context.desk.checks("s03")), check.times
    client = with_check(server, replace(check, times=used + times)).client()
    sections = len(server.context.course.sections)
    moved = [1 + 0.5**step for step in range(times + 2)]
    replies = [asked(server, client, one, tmp_path) for one in moved]
    told = [one["sections"] for one in replies]
    assert [len(one) for one in told] == [sections] * times + [0, 0]
    # Each section of a complete workbook has one of two answers; everything else is the same.
    assert {state["state"] for one in told for state in one} <= {"fits", "does_not_fit", "open"}
    for one in replies:
        for said in one["answers"]:
            assert said["state"] in {"read", "blank"}
            for echo in ("typed", "value", "message", "remarks"):
                said.pop(echo)
    same = [json.dumps(one["answers"], sort_keys=True) for one in replies]
    assert len(set(same)) == 1
    assert f"{times * sections} bits" in SECURITY.read_text(encoding="utf-8")


def test_who_may_only_see_the_reading_learns_nothing(server: "Server", tmp_path: Path) -> None:
    client = with_check(server, replace(server.context.policy.check, times=0)).client()
    replies = [asked(server, client, one, tmp_path) for one in (1.0, 1.4)]
    for one in replies:
        assert one["sections"] == []
        for said in one["answers"]:
            for echo in ("typed", "value", "message", "remarks"):
                said.pop(echo)
    assert replies[0] == replies[1]
