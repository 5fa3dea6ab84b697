"""Where names of students stand in paths, the pattern that tells whose files are is named."""

import pytest

from gripcourse.cli.pattern_text import for_names
from gripcourse.text.words import Words
from gripcourse.variants.model import Student

MISSING = [
    Student("s1", "Дем’яненко Олена Ігорівна", "", "", "", ""),
    Student("s2", "Яшин Лев", "", "", "", ""),
]


@pytest.mark.parametrize(
    ("files", "said"),
    [
        (["in/Лев Яшин.xlsx", "in/x.xlsx"], "of 1 of these files bears the name"),
        (["Дем'яненко Олена РГР 1.xlsx", "Яшин Лев.xlsx"], "'{name}.xlsx'"),
        (["in/Яшин Лев/work.xlsx"], "'{name}/*'"),
        (["in/work.xlsx", "in/17.xlsx"], ""),
        ([], ""),
    ],
)
def test_a_pattern_is_offered_where_it_tells_whose_files_are(files: list[str], said: str) -> None:
    told = list(for_names(files, MISSING, Words("en")))
    assert said in "".join(told)
    assert bool(told) == bool(said)
