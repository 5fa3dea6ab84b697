"""Variant tables from the course's spaces, or an instructor's own."""

from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.errors import TableError, UsageError
from gripcourse.usecases.solving.variants import draw_table, import_table, write_template
from gripcourse.variants.table import read_table

SCHEME = "rack_parallelogram"


def few_of(course: Course) -> str:
    """The first variants of the course's table, as text: to read and solve all takes a second."""
    main = course.root / "variants" / "tables" / "main.csv"
    return "".join(main.read_text(encoding="utf-8-sig").splitlines(keepends=True)[:9])


def test_a_drawn_table_can_be_read_back(course: Course, tmp_path: Path) -> None:
    out = tmp_path / "new" / "drawn.csv"
    drawn = draw_table(course, 5, 1, None, out)
    assert read_table(out, course) == drawn.variants
    assert len(drawn.variants) == 5


def test_the_same_seed_gives_the_same_bytes_and_another_seed_others(
    course: Course, tmp_path: Path
) -> None:
    contents = []
    for number, seed in enumerate((7, 7, 8)):
        draw_table(course, 4, seed, SCHEME, tmp_path / f"{number}.csv")
        contents.append((tmp_path / f"{number}.csv").read_bytes())
    assert contents[0] == contents[1]
    assert contents[0] != contents[2]


def test_a_scheme_without_a_space_is_named_with_the_nearest(course: Course, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="rack_paralelogram") as caught:
        draw_table(course, 4, 1, "rack_paralelogram", tmp_path / "drawn.csv")
    assert SCHEME in str(caught.value)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("name", "count", "said"),
    [
        ("drawn.txt", 4, "A table of this kind cannot be written"),
        ("drawn.xlsx", 90_000, "more than is read again: 200000 cells"),
        ("drawn.csv", 100_000, "more than is read again: 1250000 cells"),
    ],
)
def test_a_table_that_cannot_be_written_is_refused_before_anything_is_drawn(
    course: Course, tmp_path: Path, name: str, count: int, said: str
) -> None:
    module = "gripcourse.usecases.solving.variants"
    with pytest.MonkeyPatch.context() as patch:
        for way in ("draw", "draw_freely"):
            patch.setattr(f"{module}.{way}", lambda *_: pytest.fail("variants were drawn"))
        for freely in (False, True):
            with pytest.raises(TableError, match=said):
                draw_table(course, count, 1, None, tmp_path / name, freely=freely)
    assert list(tmp_path.iterdir()) == []


def test_an_instructors_table_is_checked_and_written_in_our_form(
    course: Course, tmp_path: Path
) -> None:
    text, few = few_of(course), tmp_path / "few.csv"
    few.write_text(text, encoding="utf-8-sig")
    own = tmp_path / "own.csv"
    # As a Russian spreadsheet program saves it: semicolons and decimal commas.
    own.write_text(text.replace(",", ";").replace(".", ","), encoding="utf-8-sig")
    out, expected = tmp_path / "out.csv", read_table(few, course)
    assert len(expected) == 8
    assert import_table(course, own, out).variants == expected
    assert read_table(out, course) == expected


@pytest.mark.parametrize(
    ("column", "value"), [("mass [kg]", "-5"), ("friction", "0"), ("mass [kg]", "тяжёлый")]
)
def test_a_bad_cell_is_named_by_row_and_column_and_nothing_is_written(
    course: Course, tmp_path: Path, column: str, value: str
) -> None:
    cells = [row.split(",") for row in few_of(course).splitlines()]
    cells[3][cells[0].index(column)] = value
    own = tmp_path / "own.csv"
    own.write_text("\n".join(",".join(row) for row in cells) + "\n", encoding="utf-8")
    with pytest.raises(TableError) as caught:
        import_table(course, own, tmp_path / "out.csv")
    said = str(caught.value)
    assert "own.csv" in said
    assert "row 4" in said
    assert column.split(maxsplit=1)[0] in said
    assert not (tmp_path / "out.csv").exists()


def test_a_template_is_a_table_that_can_be_imported_as_it_is(
    course: Course, tmp_path: Path
) -> None:
    write_template(course, "plain_lever", 3, tmp_path / "template.xlsx")
    own = import_table(course, tmp_path / "template.xlsx", tmp_path / "own.csv")
    assert [one.id for one in own.variants] == ["001", "002", "003"]
    assert own.notes == ()
    example = course.schemes["plain_lever"].example
    assert example is not None
    assert own.variants[0].given.items() <= example.given.items()


def test_a_third_term_keeps_apart_from_both_before(course: Course, tmp_path: Path) -> None:
    tables = [tmp_path / f"{number}.csv" for number in range(3)]
    drawn = [
        {
            tuple(sorted(one.given.items()))
            for one in draw_table(course, 4, 1, SCHEME, table, apart_from=tables[:number]).variants
        }
        for number, table in enumerate(tables)
    ]
    # The same seed: without the other tables the same variants.
    assert len(set.union(*drawn)) == 12
