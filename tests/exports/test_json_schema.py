"""What editors are told of a file agrees with the files of the reference course."""

import re
import tomllib
from pathlib import Path

import jsonschema
import pytest

from gripcourse.course.shape import Key, KeySort, Shape, number, table, text
from gripcourse.course.toml_table import Table
from gripcourse.exports.json_schema import json_schema
from gripcourse.exports.key_page import FileKind, key_page
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.usecases.authoring.schema import FILE_KINDS, write_schemas

ROOT = Path(__file__).parents[2]
KINDS = {kind.name: kind for kind in FILE_KINDS}


@pytest.mark.parametrize("kind", FILE_KINDS, ids=KINDS)
def test_every_file_of_the_reference_course_fits_its_schema(kind: FileKind) -> None:
    schema = json_schema(kind.title, kind.shape)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    paths = [path for place in kind.places for path in ROOT.glob(place)]
    assert paths
    for path in paths:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
        found = [(path.name, one.json_path, one.message) for one in validator.iter_errors(content)]
        assert found == []


def test_every_toml_file_of_the_reference_course_is_of_some_kind() -> None:
    known = {path for kind in FILE_KINDS for place in kind.places for path in ROOT.glob(place)}
    written = {
        path for folder in ("variants", "grader") for path in (ROOT / folder).rglob("*.toml")
    }
    assert written == known


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("part", {"quantity": {"mass": {"kind": "given", "formula": "1"}}}),
        ("part", {"quantities": {}}),
        ("space", {"weight": 1}),
        ("course", {"language": "de"}),
        ("policy", {"tolerance": {"relative": 2}}),
        ("diagram", {"element": [{"kind": "gera"}]}),
    ],
)
def test_a_misspelt_file_does_not_fit(kind: str, content: dict[str, object]) -> None:
    schema = json_schema(kind, KINDS[kind].shape)
    assert not jsonschema.Draft202012Validator(schema).is_valid(content)


def test_the_page_names_every_key_with_its_meaning() -> None:
    page = key_page(FILE_KINDS)
    assert "| `default` | number |  | What it is where an example" in page
    assert '### `quantity.* with kind = "given"`' in page
    assert "| `relative` | number from 0 to 0.5 |" in page


def test_the_page_of_keys_says_how_a_form_of_its_own_is_written_and_what_names_stand_for() -> None:
    page = key_page(FILE_KINDS)
    assert '| `mark` | `["…" or 0, "…" or 0]` |' in page
    assert "| `values` | `[0.5, …]` |" in page
    assert "### `work`\n\nWorks that declarations cite, by id.\n\n| key |" in page
    assert str(KeySort.OTHER) not in page


def test_the_page_of_keys_says_what_an_element_is_drawn_with_where_nothing_is_written() -> None:
    [gear] = re.findall(r'with kind = "gear"`\n(.*?)\n#', key_page(FILE_KINDS), re.DOTALL)
    assert "at which another gear or a rack meshes" in gear
    assert "`gap` where not written" in gear


def test_the_page_of_keys_tells_the_lines_that_a_catalogue_begins_with() -> None:
    page = key_page(()).split("## A catalogue")[1]
    assert all(f"`# {line}: …`" in page for line in ("source", "mark", "title", "column.NAME"))


def test_the_page_names_every_function_of_formulas_and_every_unit() -> None:
    page = key_page(()).split("## Formulas")[1]
    assert [name for name in FUNCTIONS if f"| `{name}(" not in page] == []
    assert "`mm`, `cm`" in page


def test_a_folder_gets_a_schema_of_each_kind_and_the_page(tmp_path: Path) -> None:
    names = {path.name for path in write_schemas(tmp_path / "schema")}
    assert names == {*(f"{name}.schema.json" for name in KINDS), "keys.md"}


class TestShapes:
    """A reader cannot read what no shape declares."""

    SHAPE = Shape({"name": text("A name.", required=True), "size": number("A size.", 0, 10)})

    def of(self, **values: object) -> Table:
        return Table(values, "file.toml", "", [], self.SHAPE)

    def test_a_key_that_is_not_declared_cannot_be_read(self) -> None:
        with pytest.raises(TypeError, match=r"file\.toml: colour"):
            self.of(name="x").text("colour", "")

    def test_a_key_is_read_as_what_it_is_declared(self) -> None:
        with pytest.raises(TypeError, match="is read as number"):
            self.of(name="x").number("name")

    def test_a_required_key_has_no_default(self) -> None:
        with pytest.raises(TypeError, match="required"):
            self.of().text("name", "nobody")

    def test_a_number_outside_its_bounds_is_told(self) -> None:
        read = self.of(name="x", size=11)
        assert read.number("size", 1) == 11
        assert [str(one.remedy) for one in read.problems] == ["Write a number from 0 to 10."]

    def test_what_stands_in_a_table_follows_from_the_outer_shape(self) -> None:
        outer = Shape({"inner": table("A table.", self.SHAPE)})
        inner = Table({"inner": {"nmae": "x"}}, "file.toml", "", [], outer).table("inner")
        assert inner is not None
        inner.known_keys()
        assert "Did you mean 'name'?" in str(inner.problems[0].remedy)

    def test_the_sorts_are_all_in_the_schema(self) -> None:
        for sort in KeySort:
            key = Key(sort, "Something.", inside=Shape({}), form={"type": "string"})
            schema = json_schema("all", Shape({"one": key}))
            assert "description" in schema["properties"]["one"]  # type: ignore[index]
