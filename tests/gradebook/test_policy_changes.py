"""Of two policies the keys are named that say something else, as they are written."""

import pytest

from gripcourse.gradebook.policy_changes import PolicyLine, changed_lines

FILE = "grader/policy.toml"
BEFORE = """\
[tolerance]
relative = 0.02
[tolerance.floor]
"N*m" = 0.001
[credit]
printed = false  # an erratum
habits = { pi = [3.14], gravity = [9.8, 10] }
[[scale]]
id = "mark"
step = [{ from = 85, text = "5" }, { from = 0, text = "2" }]
"""


def changed(old: str, new: str) -> list[tuple[str, str | None, str | None]]:
    assert BEFORE.count(old) == 1
    after = BEFORE.replace(old, new)
    found = changed_lines({FILE: BEFORE.encode()}, {FILE: after.encode()})
    assert {one.file for one in found} <= {FILE}
    return [(one.key, one.before, one.after) for one in found]


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("0.02", "0.01", ("tolerance.relative", "0.02", "0.01")),
        ("0.001", "0.01", ('tolerance.floor."N*m"', "0.001", "0.01")),
        ("[9.8, 10]", "[9.81]", ("credit.habits.gravity", "[9.8, 10]", "[9.81]")),
        ("85", "88", ("scale[mark].step[1].from", "85", "88")),
        ('"5" }', '"A" }', ("scale[mark].step[1].text", '"5"', '"A"')),
        # True and false are no numbers: what is printed is refused by the one alone.
        ("false", "0", ("credit.printed", "false", "0")),
        ("relative = 0.02\n", "", ("tolerance.relative", "0.02", None)),
        ("[credit]", "[credit]\nrough = 0.5", ("credit.rough", None, "0.5")),
        ("[[scale]]", "[late]\nper_day = 0.1\n[[scale]]", ("late.per_day", None, "0.1")),
        ("[[scale]]", "[late]\n[[scale]]", ("late", None, "{}")),
        (
            "[[scale]]",
            '[[scale]]\nid = "ects"\ntitle = "ECTS"\n[[scale]]',
            ("scale[ects]", None, '{ id = "ects", title = "ECTS" }'),
        ),
    ],
)
def test_a_key_that_says_something_else_is_named_with_both_values(
    old: str, new: str, line: tuple[str, str | None, str | None]
) -> None:
    assert changed(old, new) == [line]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("  # an erratum", ""),
        ("0.02", "2.0e-2"),
        ("from = 85", "from = 85.0"),
        ("{ pi = [3.14], gravity = [9.8, 10] }", "{ gravity = [9.8, 10.0], pi = [3.14] }"),
        ("[tolerance]\n", "\ufeff[tolerance]\r\n\r\n"),
    ],
)
def test_comments_layout_order_and_how_a_number_is_written_change_nothing(
    old: str, new: str
) -> None:
    assert changed(old, new) == []


def test_files_that_came_or_went_and_what_is_no_toml_are_named_without_a_key() -> None:
    before = {"grader/a.toml": b"x = 1", "grader/b.toml": b"x = 1", "grader/d.toml": b"x ="}
    after = {"grader/b.toml": b"x = ", "grader/c.toml": b"x = 1", "grader/d.toml": b"x ="}
    assert changed_lines(before, after) == (
        PolicyLine("grader/a.toml", "", "", None),
        PolicyLine("grader/b.toml", "", "", ""),
        PolicyLine("grader/c.toml", "", None, ""),
    )
