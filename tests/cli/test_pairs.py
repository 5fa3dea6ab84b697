"""What is typed as `name=value`."""

import pytest

from gripcourse.cli.pairs import read_lines, read_pairs
from gripcourse.errors import UsageError
from gripcourse.text.words import message


def test_names_and_values_stand_around_the_first_equals_sign() -> None:
    assert read_pairs("--set", ["mass = 5", "a=b=c"], message("")) == [("mass", "5"), ("a", "b=c")]


def test_every_text_without_an_equals_sign_is_told() -> None:
    with pytest.raises(UsageError) as caught:
        read_pairs("--set", ["mass", "a=1", "17"], message("Write name=value."))
    said = [str(problem.what) for problem in caught.value.problems]
    assert said == ["'mass' has no equals sign.", "'17' has no equals sign."]
    assert {problem.key for problem in caught.value.problems} == {"--set"}


@pytest.mark.parametrize("text", ["sizes", "sizes=", "=1", "sizes=half", "sizes=1/2"])
def test_a_line_that_is_none_is_quoted(text: str) -> None:
    with pytest.raises(UsageError) as caught:
        read_lines(["assembly=1", text, "standards=x"])
    assert [problem.key for problem in caught.value.problems] == ["--line", "--line"]
    assert f"'{text}'" in str(caught.value.problems[0].what)


def test_a_line_twice_is_refused() -> None:
    with pytest.raises(UsageError, match="each line once"):
        read_lines(["sizes=1", "sizes=0.5"])


def test_lines_are_read_with_point_or_comma() -> None:
    assert read_lines(["sizes=0,5", "assembly = 0.25"]) == {"sizes": 0.5, "assembly": 0.25}
