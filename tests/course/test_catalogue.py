"""Catalogues: what a table of standard sizes must say, and what is read from it."""

from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.catalogue import columns_of
from gripcourse.course.model import Course

if TYPE_CHECKING:
    from support.drafts import Draft

PIN = "variants/catalogues/pin.csv"


@pytest.mark.parametrize(
    ("old", "new", "key", "what", "remedy"),
    [
        ("# source:", "# sauce:", "source", "where its numbers come from", "'# source: …'"),
        ("# mark:", "# work:", "mark", "where its numbers come from", "'# mark: …'"),
        ("\n3\n4\n", "\n4\n3\n", "column diameter", "do not grow", "Sort the rows"),
        ("\n3\n4\n", "\n3\n3\n", "column diameter", "do not grow", "remove doubled sizes"),
        (
            "\n3\n4\n",
            "\n3\nfour\n",
            "row 7",
            "a number in each column",
            "a number with a point",
        ),
        (
            "\n3\n4\n",
            "\n3\n4,5\n",
            "row 7",
            "a number in each column",
            "in every column",
        ),
        (
            "\n3\n4\n",
            "\n3\n4e-999\n",
            "row 7",
            "a number in each column",
            "in every column",
        ),
        (
            "\n3\n4\n",
            "\n3\nnan\n",
            "row 7",
            "a number in each column",
            "in every column",
        ),
        (
            "diameter [mm]",
            "diameter [mmm]",
            "column diameter [mmm]",
            "cannot be used",
            "known unit",
        ),
        ("diameter [mm]", "dia meter [mm]", "column dia meter [mm]", "cannot be used", "new name"),
    ],
)
def test_a_fault_of_a_catalogue_is_one_problem(
    draft: "Draft", old: str, new: str, key: str, what: str, remedy: str
) -> None:
    problem = draft.edit(PIN, old, new).problem()
    assert (problem.file, str(problem.key)) == (PIN, key)
    assert what in str(problem.what)
    assert remedy in str(problem.remedy)


def test_a_catalogue_in_another_encoding_is_named(draft: "Draft") -> None:
    text = "# source: ГОСТ 9650-80\n# mark: handbook\ndiameter [mm]\n3\n4\n"
    problem = draft.put(PIN, text.encode("cp1251")).problem()
    assert (problem.file, str(problem.what)) == (PIN, "The file is not UTF-8.")
    assert "with commas between columns and points in numbers" in str(problem.remedy)


def test_a_catalogue_with_a_quotation_mark_that_has_no_end_is_named(draft: "Draft") -> None:
    text = '# source: nowhere\n# mark: none\n"diameter [mm]\n' + "3\n" * 140_000
    problem = draft.put(PIN, text.encode()).problem()
    assert (problem.file, "cannot be told apart" in str(problem.what)) == (PIN, True)
    assert "never closed" in str(problem.remedy)


@pytest.mark.parametrize("rows", ["", "diameter [mm]\n"])
def test_a_catalogue_without_sizes_is_empty(draft: "Draft", rows: str) -> None:
    text = f"# source: nowhere\n# mark: none\n{rows}"
    problem = draft.put(PIN, text.encode()).problem()
    assert (problem.file, str(problem.what)) == (PIN, "The catalogue is empty.")


def test_texts_may_all_be_written_with_their_language(draft: "Draft") -> None:
    for name in ("title", "source", "mark"):
        draft.edit(PIN, f"# {name}:", f"# {name}.en:")
    catalogue = draft.load().catalogues["pin"]
    assert catalogue.title is not None
    assert catalogue.title.of("en") != catalogue.title.of("ru") != catalogue.title.of("uk")
    assert catalogue.source.of("en")


def test_a_text_with_languages_only_lacks_each_that_is_not_written(draft: "Draft") -> None:
    problem = (
        draft.edit(PIN, "# title:", "# title.en:").edit(PIN, "# title.ru:", "# name:").problem()
    )
    assert (problem.file, str(problem.key)) == (PIN, "title.ru")
    assert "'# title.ru: …'" in str(problem.remedy)


def test_blank_lines_are_no_rows(draft: "Draft") -> None:
    draft.edit(PIN, "\n3\n4\n", "\n\n3\n\n4\n").append(PIN, "")
    assert draft.problems() == ()


def test_sizes_are_kept_in_si_with_their_source(course: Course) -> None:
    catalogue = course.catalogues["bore_pneumatic"]
    assert set(catalogue.units) == {"bore", "rod", "ring_diameter", "least_stroke"}
    assert set(catalogue.units.values()) == {"mm"}
    assert catalogue.columns["bore"][0] == pytest.approx(0.008)
    assert catalogue.source.of("en").startswith("ISO 6432")
    assert catalogue.source.of("en").endswith("(handbook value, not read in the standard itself)")
    assert catalogue.source.of("ru").endswith(
        "(значение из справочника, в самом стандарте не прочитано)"
    )


def test_every_column_is_found_by_catalogue_and_name(course: Course) -> None:
    column = columns_of(course.catalogues)["bore_pneumatic.rod"]
    assert np.array_equal(column.sizes, course.catalogues["bore_pneumatic"].columns["bore"])
    assert np.array_equal(column.values, course.catalogues["bore_pneumatic"].columns["rod"])


def test_allowed_stresses_of_steels_follow_from_their_yield(course: Course) -> None:
    steel = course.catalogues["steel"].columns
    # the guide's ranges: 0.4 to 0.5 in bending, 0.2 to 0.3 in shear, 0.4 to 0.6 in bearing
    for name, share in (("bending", 0.4), ("shear", 0.2), ("bearing", 0.4)):
        assert steel[f"{name}_allowed"] == pytest.approx(share * steel["yield"], rel=1e-12)


@pytest.mark.parametrize(
    ("file", "old", "key"),
    [
        (PIN, "title", "title"),
        ("variants/catalogues/bore_pneumatic.csv", "column.rod", "column.rod"),
    ],
)
def test_a_series_that_students_could_not_be_shown_is_named(
    draft: "Draft", file: str, old: str, key: str
) -> None:
    for language in ("", ".ru", ".uk"):
        draft.edit(file, f"# {old}{language}: ", f"# nothing{language}: ")
    problem = draft.problem()
    assert (problem.file, str(problem.key)) == (file, key)
    assert f"'# {key}: …'" in str(problem.remedy)


@pytest.mark.parametrize(
    ("file", "line"),
    [
        (PIN, "title.uk"),
        (PIN, "title.en"),
        ("variants/catalogues/bore_pneumatic.csv", "column.rod.ru"),
        ("variants/catalogues/bore_pneumatic.csv", "column.rod.en"),
    ],
)
def test_a_language_that_a_printed_name_lacks_is_told(draft: "Draft", file: str, line: str) -> None:
    # The line without a language is the English one.
    problem = draft.edit(file, f"# {line.removesuffix('.en')}: ", "# nothing: ").problem()
    assert (problem.file, str(problem.key)) == (file, line)
    assert "in this language is missing" in str(problem.what)
    assert f"'# {line}: …'" in str(problem.remedy)


BORE = "variants/catalogues/bore_pneumatic.csv"
ROD = "# column.rod: rod d\n# column.rod.ru: шток d\n# column.rod.uk: шток d\n"


@pytest.mark.parametrize(
    ("heading", "missing"),
    [
        ("rod d", ["ru", "uk"]),
        ("шток d", ["en", "uk"]),
        ("d", []),
        ("d_max", []),
        ("√(D² − d²), sin(α)", []),
        ("HRC", []),
    ],
)
def test_a_heading_in_words_serves_one_language_and_a_symbol_all(
    draft: "Draft", heading: str, missing: list[str]
) -> None:
    found = draft.edit(BORE, ROD, f"# column.rod: {heading}\n").problems()
    keys = {str(one.key) for one in found if one.file == BORE}
    assert keys == {f"column.rod.{one}" for one in missing}
