"""Stories of a term: from command to command, what one leaves is what the next one takes."""

import json
from pathlib import Path

import pytest

from gripcourse.cli import main as cli
from gripcourse.cli.options import NEEDS_PERSON
from support.cli_term import Command, Term, refused


def test_a_course_from_issue_to_grades(gripcourse: Command, term: Term, tmp_path: Path) -> None:
    """Issue, check, grade: the codes say whether somebody must look."""
    assert term.issued.code == cli.DONE
    assert str(term.folder / "assignments") in term.issued.out

    assert term.graded.code == cli.DONE
    (report,) = json.loads(term.graded.out)["reports"]
    assert report["student"] == "s01"
    assert report["score"] == 0
    assert {one["outcome"] for one in report["findings"]} == {"blank", "manual"}

    story = term.again(tmp_path)
    checked = gripcourse(
        "check", story.own, "--course", story.folder / "course", "--language", "uk"
    )
    assert checked.code == cli.DONE
    assert "зусилля затискання" in checked.out

    other = tmp_path / "s02.xlsx"
    other.write_bytes(story.own.read_bytes())
    looked_at = gripcourse("grade", *story.place, other, "--out", tmp_path / "graded")
    assert looked_at.code == NEEDS_PERSON
    assert "who handed this in?" in looked_at.out
    assert "Traceback" not in looked_at.out + looked_at.err


def test_a_drawing_from_waiting_to_marked(gripcourse: Command, term: Term, tmp_path: Path) -> None:
    """Grade, look what waits, mark, grade again: the codes say whether somebody must look."""
    story = term.again(tmp_path)
    course, own, place = story.folder / "course", story.own, story.place
    graded = tmp_path / "graded"

    listed = gripcourse("mark", "--list", "--course", course)
    assert listed.code == NEEDS_PERSON
    assert all(part in listed.out for part in ("s01", "general_view_drawing", "s01.xlsx"))

    order = ("mark", "s01", "general_view_drawing", "--course", course, "--by", "Петров")
    refused(gripcourse(*order, "--points", "99,5"), "--points", "99.5", "from 0 to")
    lines = ("--line", "sizes=1", "--line", "assembly=0,5", "--line", "standards=1")
    marked = gripcourse(*order, *lines, "--comment", "Нет масштаба")
    assert marked.code == cli.DONE
    assert "(s01), general view drawing (general_view_drawing): " in marked.out
    assert "already the same" in gripcourse(*order, *lines, "--comment", "Нет масштаба").out

    again = gripcourse("grade", *place, own, "--out", graded, "--json")
    assert again.code == cli.DONE
    (report,) = json.loads(again.out)["reports"]
    drawing = next(o for o in report["findings"] if o["quantity"] == "general_view_drawing")
    assert drawing["decision"]["marker"] == "Петров"
    assert report["score"] == pytest.approx(0.85 * drawing["max_points"])

    table = tmp_path / "marks.csv"
    table.write_text("filled in", encoding="utf-8")
    assert gripcourse("mark", "--list", "--course", course, "--out", table).code == NEEDS_PERSON
    assert (tmp_path / "marks.before-1.csv").read_text(encoding="utf-8") == "filled in"
    other = next(o["quantity"] for o in report["findings"] if o["outcome"] == "manual")
    table.write_text(f"student,quantity,credit\ns01,{other},1.5\n", encoding="utf-8")
    refused(gripcourse("mark", "--table", table, "--course", course), "row 2, column credit", "1.5")
    table.write_text(f'student,quantity,credit\ns01,{other},"0,5"\n', encoding="utf-8")
    assert gripcourse("mark", "--table", table, "--course", course).code == cli.DONE
    nothing = gripcourse("mark", "--list", "--course", course)
    assert (nothing.code, nothing.out.strip()) == (cli.DONE, "Nothing waits for the instructor.")


def test_a_regrade_from_showing_to_undoing(gripcourse: Command, term: Term, tmp_path: Path) -> None:
    """Change the policy, look, apply, publish, take back: the codes say what is left to do."""
    story = term.again(tmp_path)
    at = ("--course", story.folder / "course")
    files = (story.own, "--workers", 0, *at)
    assert gripcourse("regrade", *files).code == cli.DONE

    policy = story.folder / "course" / "grader" / "policy.toml"
    text = policy.read_text(encoding="utf-8")
    policy.write_text(text.replace("kinematic_diagram = 4", "kinematic_diagram = 5"), "utf-8")
    shown = gripcourse("regrade", *files)
    assert shown.code == NEEDS_PERSON
    assert all(
        one in shown.out for one in ("s01", "the policy", "(kinematic_diagram): ", "1 unchanged")
    )
    assert "quantity.kinematic_diagram 4 → 5" in shown.out
    assert "(kinematic_diagram): " not in gripcourse("regrade", *files, "--only", "raised").out

    refused(gripcourse("regrade", *files, "--only", "raise"), "'raise'", "'raised'")
    refused(gripcourse("regrade", *files, "--apply"), "needs a reason")
    refused(gripcourse("undo", "--why", "no", *at), "No regrade stands")
    refused(gripcourse("history", "s09", *at), "<student>", "'s09'")
    refused(gripcourse("publish", "s09", *at), "<student>", "s09")

    assert gripcourse("publish", *at).code == cli.DONE
    signed = ("--by", "Петров", "--why", "диаграмма важнее")
    assert gripcourse("regrade", *files, "--apply", *signed).code == cli.DONE
    assert gripcourse("regrade", *files).code == cli.DONE
    assert gripcourse("undo", "--why", "поспешили", *at).code == cli.DONE
    told = gripcourse("history", "s01", *at).out
    assert all(one in told for one in ("Attempt 1", "Петров", "диаграмма важнее", "поспешили"))

    refused(gripcourse("waive", "s01", "--why", "болезнь", "--until", "soon", *at), "'soon'")
    refused(gripcourse("waive", "s01", *at), "needs a reason")
    assert gripcourse("waive", "s01", "--why", "болезнь", *at).code == cli.DONE
    assert "болезнь" in gripcourse("history", "s01", *at).out
    out = ("--out", tmp_path / "graded")
    refused(gripcourse("grade", *files, *out, "--handed-in", "soon"), "--handed-in", "'soon'")


def test_what_was_kept_is_told_amid_a_change_that_the_course_does_not_bear(
    gripcourse: Command, term: Term, tmp_path: Path
) -> None:
    """A history needs the course's id; what it calls quantities is all that the rest gives it."""
    story = term.again(tmp_path)
    at = ("--course", story.folder / "course")
    before = gripcourse("history", "s01", *at)
    scheme = next((story.folder / "course" / "variants" / "schemes").glob("*/scheme.toml"))
    scheme.write_text("", encoding="utf-8")
    assert gripcourse("mark", "--list", *at).code == cli.WRONG_USE

    told = gripcourse("history", "s01", *at)
    assert (told.code, told.out) == (cli.DONE, before.out)
    assert "called by their ids" in told.err
    refused(gripcourse("history", "s09", *at), "<student>", "'s09'")
    assert gripcourse("waive", "s01", "--why", "болезнь", *at).code == cli.DONE
    assert "болезнь" in gripcourse("history", "s01", *at).out
