"""A table of variants goes out and comes back; every wrong cell is named."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import openpyxl
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from gripcourse.course.model import Course
from gripcourse.errors import Problem, TableError
from gripcourse.machine.enclosed import is_file_name
from gripcourse.text.units import unit_text
from gripcourse.text.words import LANGUAGES, Texts
from gripcourse.variants.draw import draw
from gripcourse.variants.headings import find_columns, table_vocabulary
from gripcourse.variants.model import Variant
from gripcourse.variants.named_choices import allowed_names
from gripcourse.variants.sheet import Sheet
from gripcourse.variants.space import load_spaces
from gripcourse.variants.table import read_own_table, read_table, write_table

HEADER = (
    "variant,scheme,fluid,mass [kg],acceleration [m/s**2],friction,pressure [MPa],teeth,"
    "form_factor,arm [mm],travel [mm],noise"
)
SOUND = "1,press,oil,60,5,0.15,10,17,4.26,100,50,"
GIVEN = {
    "mass": 60.0,
    "acceleration": 5.0,
    "friction": 0.15,
    "pressure": 10.0,
    "teeth": 17.0,
    "form_factor": 4.26,
    "arm": 100.0,
    "travel": 50.0,
}


def write(folder: Path, *lines: str, name: str = "table.csv") -> Path:
    path = folder / name
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def row(**changes: str) -> str:
    """The sound row with cells changed, by column id."""
    columns = [heading.partition(" [")[0] for heading in HEADER.split(",")]
    cells = dict(zip(columns, SOUND.split(","), strict=True)) | changes
    return ",".join(cells.values())


def problems_of(path: Path, course: Course) -> list[tuple[str, str]]:
    with pytest.raises(TableError) as caught:
        read_table(path, course)
    assert {problem.file for problem in caught.value.problems} == {str(path)}
    return [
        (str(problem.key), f"{problem.what} {problem.remedy}") for problem in caught.value.problems
    ]


def test_a_sound_row_is_a_variant(tmp_path: Path, small_course: Course) -> None:
    (variant,) = read_table(write(tmp_path, HEADER, SOUND), small_course)
    assert variant == Variant("1", "press", {"fluid": "oil"}, GIVEN)


def test_a_written_table_is_read_back_equal(tmp_path: Path, small_course: Course) -> None:
    variants = draw(small_course, load_spaces(small_course), 60, 7).variants
    write_table(tmp_path / "table.csv", variants, small_course)
    assert read_table(tmp_path / "table.csv", small_course) == variants


def test_a_written_table_opens_in_excel_with_every_letter(
    tmp_path: Path, small_course: Course
) -> None:
    write_table(
        tmp_path / "table.csv", [Variant("1", "press", {"fluid": "oil"}, GIVEN)], small_course
    )
    content = (tmp_path / "table.csv").read_bytes()
    assert content.startswith(b"\xef\xbb\xbf")
    assert content.decode("utf-8-sig").splitlines() == [
        HEADER.removesuffix(",noise"),
        SOUND.removesuffix(","),
    ]


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=30)
@given(
    mass=st.floats(1, 100),
    friction=st.floats(0.05, 1),
    travel=st.floats(1, 90),
    name=st.text(st.characters(categories=["L", "N"]), min_size=1, max_size=8).filter(is_file_name),
)
def test_any_feasible_number_comes_back_equal(
    tmp_path: Path, small_course: Course, mass: float, friction: float, travel: float, name: str
) -> None:
    given_values = GIVEN | {"mass": mass, "friction": friction, "travel": travel}
    variant = Variant(name, "press", {"fluid": "oil"}, given_values)
    write_table(tmp_path / "table.csv", [variant], small_course)
    assert read_table(tmp_path / "table.csv", small_course) == (variant,)


@pytest.mark.parametrize(
    "header",
    [
        (
            "Вариант;Схема;Среда;Масса объекта, кг;Ускорение, м/с2;Коэффициент трения;"
            "Давление питания, МПа;Число зубьев;Коэффициент формы;Плечо, мм;Ход, мм"
        ),
        (
            "варіант;схема;середовище;маса обʼєкта [кг];прискорення [м/с²];коефіцієнт тертя;"
            "тиск живлення (МПа);кількість зубців;коефіцієнт форми;плече;хід"
        ),
        "variant;scheme;fluid;m;a;f;p_s;z;Y;l;L0",
    ],
)
def test_headings_can_be_titles_or_symbols_in_any_language(
    tmp_path: Path, small_course: Course, header: str
) -> None:
    cells = "1;пресс;Масло;60;5;0,15;10;17;4,26;100;50"
    (variant,) = read_table(write(tmp_path, header, cells), small_course)
    assert variant == Variant("1", "press", {"fluid": "oil"}, GIVEN)


def test_a_title_with_a_comma_of_its_own_is_found(tmp_path: Path, small_course: Course) -> None:
    header = HEADER.replace("friction", '"friction, sliding"')
    assert read_table(write(tmp_path, header, SOUND), small_course)[0].given == GIVEN


def test_numbers_in_another_unit_of_the_heading_are_converted(
    tmp_path: Path, small_course: Course
) -> None:
    header = HEADER.replace("arm [mm]", "arm [m]").replace("[MPa]", "[бар]")
    cells = row(arm="0.1", pressure="100")
    assert read_table(write(tmp_path, header, cells), small_course)[0].given == GIVEN


def test_a_share_may_be_written_with_the_sign_of_percent(
    tmp_path: Path, small_course: Course
) -> None:
    table = write(tmp_path, HEADER, row(friction="15 %"), name="table.csv")
    assert read_table(table, small_course)[0].given["friction"] == pytest.approx(0.15)


def test_a_formula_without_a_stored_result_says_so(tmp_path: Path, small_course: Course) -> None:
    ((_, said),) = problems_of(write(tmp_path, HEADER, row(mass="=B2*2")), small_course)
    assert "result is not stored" in said


def test_a_blank_cell_is_fine_where_the_options_do_not_need_it(
    tmp_path: Path, small_course: Course
) -> None:
    air = row(variant="2", fluid="air", noise="3", pressure="0.5")
    oil, other = read_table(write(tmp_path, HEADER, SOUND, air), small_course)
    assert "noise" not in oil.given
    assert other.given["noise"] == 3.0


@pytest.mark.parametrize(
    ("changes", "key", "said"),
    [
        ({"mass": ""}, "row 2, column mass [kg]", "missing"),
        ({"mass": "sixty"}, "row 2, column mass [kg]", "'sixty' is not a number"),
        ({"mass": "2026-05-01"}, "row 2, column mass [kg]", "date"),
        ({"mass": "nan"}, "row 2, column mass [kg]", "not a number"),
        ({"mass": "-60"}, "row 2, column mass [kg]", "from 0.1 to 5000 kg"),
        ({"mass": "60000"}, "row 2, column mass [kg]", "from 0.1 to"),
        ({"mass": '"1,234"'}, "row 2, column mass [kg]", "'1,234' is not a number"),
        ({"teeth": "17.5"}, "row 2, column teeth", "whole number"),
        ({"scheme": "pres"}, "row 2, column scheme", "Did you mean 'press'"),
        ({"scheme": ""}, "row 2, column scheme", "missing"),
        ({"fluid": "water"}, "row 2, column fluid", "no choice 'water'"),
        ({"fluid": ""}, "row 2, column fluid", "missing"),
        ({"variant": ""}, "row 2, column variant", "no name"),
        ({"noise": "3"}, "row 2, column noise", "does not use this"),
        ({"fluid": "air", "pressure": "0.5"}, "row 2, column noise", "missing"),
        ({"friction": "0"}, "row 2, variant 1", "force (force) has no value"),
        ({"travel": "150"}, "row 2, variant 1", "angle (angle) has no value"),
        ({"pressure": "16"}, "row 2, variant 1", "pressure <= pressure_limit does not hold"),
        (
            {"mass": "5000", "pressure": "0.1"},
            "row 2, variant 1",
            "the catalogue bore.bore has no entry",
        ),
    ],
)
def test_a_wrong_cell_is_named_by_row_and_column(
    tmp_path: Path, small_course: Course, changes: Mapping[str, str], key: str, said: str
) -> None:
    problems = problems_of(write(tmp_path, HEADER, row(**changes)), small_course)
    assert [found for found, _ in problems] == [key]
    assert said in problems[0][1]


def test_a_doubled_variant_names_both_rows(tmp_path: Path, small_course: Course) -> None:
    problems = problems_of(write(tmp_path, HEADER, SOUND, "", SOUND), small_course)
    assert problems[0][0] == "row 4, column variant"
    assert "in row 2 already" in problems[0][1]


@pytest.mark.parametrize(("first", "second"), [("1", "001"), ("01", "1"), ("0", "000")])
def test_names_that_differ_in_leading_zeros_alone_are_refused(
    tmp_path: Path, small_course: Course, first: str, second: str
) -> None:
    table = write(tmp_path, HEADER, row(variant=first), row(variant=second))
    problems = problems_of(table, small_course)
    assert problems[0][0] == "row 3, column variant"
    assert f"The variant '{first}' is in row 2 already. Give each variant a name" in problems[0][1]
    apart = write(tmp_path, HEADER, row(variant="a1"), row(variant="a01"))
    assert [one.id for one in read_table(apart, small_course)] == ["a1", "a01"]


def test_all_problems_are_told_at_once(tmp_path: Path, small_course: Course) -> None:
    path = write(
        tmp_path,
        HEADER,
        row(mass="", teeth="17.5"),
        row(variant="2", scheme="x"),
        row(variant="3", travel="150"),
        row(variant="4"),
        row(variant="5", mass="-1"),
    )
    assert [key for key, _ in problems_of(path, small_course)] == [
        "row 2, column mass [kg]",
        "row 2, column teeth",
        "row 3, column scheme",
        "row 6, column mass [kg]",
        "row 4, variant 3",
    ]


@pytest.mark.parametrize(
    ("old", "new", "key", "said"),
    [
        ("mass [kg]", "mas [kg]", "column mas [kg]", "Did you mean 'mass'"),
        ("mass [kg]", "mass [N]", "column mass [N]", "does not measure"),
        ("mass [kg]", "mass [stone]", "column mass [stone]", "not known"),
        ("mass [kg]", "", "column D", "no heading"),
        ("noise", "mass", "column mass", "mean the same"),
        ("travel [mm]", "ход зубья", "column ход зубья", "no quantity or option"),
    ],
)
def test_a_wrong_heading_is_named(
    tmp_path: Path, small_course: Course, old: str, new: str, key: str, said: str
) -> None:
    problems = dict(problems_of(write(tmp_path, HEADER.replace(old, new), SOUND), small_course))
    assert said in problems[key]


def test_a_column_that_all_need_is_missed_once(tmp_path: Path, small_course: Course) -> None:
    cells = SOUND.replace(",60,", ",")
    path = write(
        tmp_path, HEADER.replace("mass [kg],", ""), cells, cells.replace("1,press", "2,press")
    )
    assert problems_of(path, small_course) == [
        ("", "There is no column 'mass'. Add it: every variant needs it.")
    ]


def test_the_same_fault_in_many_rows_of_a_column_is_told_once(
    tmp_path: Path, small_course: Course
) -> None:
    """As when a scheme gains a given that the stored table has only for other rows."""
    rows = [row(variant=str(number), mass="") for number in (1, 2, 3)]
    path = write(tmp_path, HEADER, *rows, row(variant="4"), row(variant="5", mass=""))
    assert problems_of(path, small_course) == [
        (
            "rows 2–4, 6 (4 in all), column mass [kg]",
            "The value is missing: the scheme of the row needs it. Write a number.",
        )
    ]


def test_a_table_without_variants_is_a_problem(tmp_path: Path, small_course: Course) -> None:
    (problem,) = problems_of(write(tmp_path, HEADER), small_course)
    assert "no variants" in problem[1]


def test_a_spreadsheet_is_imported(tmp_path: Path, small_course: Course) -> None:
    book = openpyxl.Workbook()
    book.active.append(["Вариант", "Среда", *GIVEN])
    book.active.append([1, "масло", *GIVEN.values()])
    book.save(tmp_path / "table.xlsx")
    (variant,) = read_table(tmp_path / "table.xlsx", small_course)
    assert variant == Variant("1", "press", {"fluid": "oil"}, GIVEN)


def test_the_issued_table_of_the_reference_course_is_sound(reference_course: Course) -> None:
    table = reference_course.root / "variants" / "tables" / "main.csv"
    variants = read_table(table, reference_course)
    assert len(variants) == 64
    assert {one.scheme for one in variants} == reference_course.schemes.keys()
    assert {variant.scheme for variant in variants} == set(reference_course.schemes)


def test_every_schemes_title_of_a_given_finds_its_column(small_course: Course) -> None:
    press = small_course.schemes["press"]
    load = replace(press.quantities["mass"], title=Texts(dict.fromkeys(LANGUAGES, "load")))
    other = replace(press, id="other", quantities={**press.quantities, "mass": load})
    course = replace(small_course, schemes={"press": press, "other": other})
    vocabulary = table_vocabulary(course)
    assert vocabulary.find("load") == vocabulary.find("mass of the object") == {"mass"}


def test_letters_that_an_old_code_page_lost_hide_no_column(reference_course: Course) -> None:
    """Saved by Excel as plain CSV a template has `?` in the place of Greek letters."""
    vocabulary = table_vocabulary(reference_course)
    lost = 0
    for given_quantity in vocabulary.quantities.values():
        title, symbol = given_quantity.title.of("ru"), given_quantity.symbol.of("ru")
        heading = f"{title}, {symbol} [{unit_text(given_quantity.unit, 'ru')}]"
        damaged = heading.encode("cp1251", "replace").decode("cp1251")
        lost += damaged != heading
        problems: list[Problem] = []
        found = find_columns(
            Sheet("t.csv", (damaged,), (), decimal_comma=True), vocabulary, problems
        )
        assert problems == []
        assert [(id_, one.unit) for id_, one in found.items()] == [
            (given_quantity.id, given_quantity.unit)
        ]
    assert lost > 20


def test_a_sign_that_was_never_lost_is_no_symbol(reference_course: Course) -> None:
    problems: list[Problem] = []
    heading = "допускаемое напряжение изгиба рычага (пальца), ??? [МПа]"
    find_columns(
        Sheet("t.csv", (heading,), (), decimal_comma=True),
        table_vocabulary(reference_course),
        problems,
    )
    assert len(problems) == 1


def test_a_workbook_of_variants_comes_back_as_it_was(tmp_path: Path, small_course: Course) -> None:
    drawn = draw(small_course, load_spaces(small_course), 6, seed=2).variants
    write_table(tmp_path / "table.xlsx", drawn, small_course)
    assert read_table(tmp_path / "table.xlsx", small_course) == drawn
    [first, *_] = openpyxl.load_workbook(tmp_path / "table.xlsx").worksheets
    headings = [cell.value for cell in first[1]]
    assert any("[" in heading and "," in heading for heading in headings), headings
    offered = {one.formula1 for one in first.data_validations.dataValidation}
    assert "lists!$C$1:$C$2" in offered


def test_columns_left_out_are_filled_from_example_or_range_and_said(
    tmp_path: Path, small_course: Course
) -> None:
    path = write(tmp_path, "Таблица вариантов", "scheme,mass,noise", "press,60,")
    own = read_own_table(path, small_course)
    [variant] = own.variants
    assert variant.id == "001"
    assert variant.given["mass"] == 60
    assert variant.given.keys() == GIVEN.keys()
    [note] = own.notes
    assert "has no columns for these" in str(note)
    with pytest.raises(TableError):
        read_table(path, small_course)


def test_a_table_is_csv_or_a_workbook(tmp_path: Path, small_course: Course) -> None:
    with pytest.raises(TableError, match=r"ends in \.csv or \.xlsx"):
        write_table(tmp_path / "table.ods", (), small_course)


@pytest.mark.parametrize("language", [*LANGUAGES, "id"])
def test_what_may_be_chosen_is_said_in_the_words_of_the_table(
    course: Course, tmp_path: Path, language: str
) -> None:
    """Russian and Ukrainian call the shape of the jaws alike: the other column tells them apart."""
    scheme = course.schemes["cross_cylinder"]
    options = [one for one in scheme.options if one.id in {"jaw_shape", "drive"}]
    headings = [one.id if language == "id" else one.title.of(language) for one in options]
    path = write(tmp_path, f"scheme;{';'.join(headings)}", "cross_cylinder;?;?")
    with pytest.raises(TableError) as caught:
        read_own_table(path, course)
    said = [str(one.remedy) for one in caught.value.problems]
    assert said == [
        f"Allowed here: {'; '.join(named)}."
        for named in (
            [choice.id if language == "id" else choice.title.of(language) for choice in one.choices]
            for one in options
        )
    ]


def test_the_nearest_name_is_suggested_beside_all_that_are_allowed() -> None:
    known = (
        ("oil", Texts({"en": "oil", "ru": "масло", "uk": "олива"})),
        ("air", Texts({"en": "air", "ru": "воздух", "uk": "повітря"})),
    )
    assert str(allowed_names("Маслоо", known, "ru")) == (
        "Did you mean 'масло'? Allowed here: масло; воздух."
    )
    assert str(allowed_names("вода", known, "")) == "Allowed here: oil; air."
