import pytest

from gripcourse.formula.fault import FormulaFault, caret
from gripcourse.text.words import message


@pytest.mark.parametrize(
    ("text", "span", "shown"),
    [
        ("a + b", (4, 5), "  a + b\n      ^"),
        ("a + bore", (4, 8), "  a + bore\n      ^^^^"),
        ("a", (1, 1), "  a\n   ^"),
        ("one +\n  two +\n three", (8, 11), "    two +\n    ^^^"),
        ("one +\n  two", (0, 11), "  one +\n  ^^^^^"),  # what goes on below is not underlined
        ("\ta + b", (5, 6), "   a + b\n       ^"),
        ("", (0, 0), "  \n  ^"),
    ],
)
def test_a_caret_stands_under_the_place_on_its_own_line(
    text: str, span: tuple[int, int], shown: str
) -> None:
    assert caret(text, span) == shown


def test_a_fault_says_what_is_wrong_and_where() -> None:
    fault = FormulaFault(message("No {name} here.", name="bore"), (3, 7))
    assert str(fault) == "No bore here. (characters 3 to 7)"
