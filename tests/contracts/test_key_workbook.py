"""The key workbook computes what the solver computes: a spreadsheet program is the judge."""

import math
import re
import subprocess
import zipfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import iterparse

import openpyxl
import pytest

from gripcourse.course.model import Course, Kind
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate, solve_variant, to_si
from gripcourse.text.words import Words
from gripcourse.variants.model import Variant
from gripcourse.workbook.key import write_key_workbook

DRAWN = 20  # variants of each scheme, beside its worked example
CALLS = 2  # of LibreOffice, side by side
CHANGED = "changed"
FACTOR = 1.25  # by which the mass is changed in the file, under the stored results
# Quantities that no spreadsheet formula computes, and why.
WITHOUT_FORMULA: Mapping[str, str] = {
    "contact_factor": "the exact coefficient of crossed cylinders holds elliptic integrals",
}
# Recalculate on load, whatever the file says; else stored results are shown as they are.
RECALCULATE = """<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry">
<item oor:path="/org.openoffice.Office.Calc/Formula/Load">
<prop oor:name="OOXMLRecalcMode" oor:op="fuse"><value>0</value></prop></item>
</oor:items>"""


@dataclass(frozen=True, slots=True)
class Key:
    """A variant, its plan, and the numbers that stand in its file in the end."""

    plan: Plan
    variant: Variant
    given: Mapping[str, float]


@pytest.fixture(scope="module")
def keys(course: Course, drawn_of: Callable[[str, int], tuple[Variant, ...]]) -> dict[str, Key]:
    """Choose variants of each scheme: its example and drawn ones, their options mixed."""
    found: dict[str, Key] = {}
    for scheme in course.schemes.values():
        assert scheme.example is not None
        example = Variant("example", scheme.id, scheme.example.options, scheme.example.given)
        for one in (example, *drawn_of(scheme.id, DRAWN)):
            plan = make_plan(course, one.scheme, one.options)
            found[f"{scheme.id}-{one.id}"] = Key(plan, one, one.given)
    last = next(key for key in reversed(found.values()) if "mass" in key.given)
    other = {**last.given, "mass": last.given["mass"] * FACTOR}
    found[CHANGED] = Key(last.plan, last.variant, other)
    return found


@pytest.fixture(scope="module")
def written(keys: dict[str, Key], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Write all keys into one folder; the last has another mass under its stored results."""
    folder = tmp_path_factory.mktemp("keys")
    for name, key in keys.items():
        write_key_workbook(folder / f"{name}.xlsx", key.plan, key.variant, Words("ru"))
    change_mass(folder / f"{CHANGED}.xlsx", keys[CHANGED].given["mass"])
    return folder


@pytest.mark.office
@pytest.mark.xdist_group("office")
def test_a_spreadsheet_computes_every_key_as_the_solver_does(
    keys: dict[str, Key], written: Path
) -> None:
    recalculate(written, list(keys))
    faults = [
        f"{name}: {fault}"
        for name, key in keys.items()
        for fault in faults_of(key, read_cells(written / "out" / f"{name}.xlsx"))
    ]
    assert faults == []
    assert len(keys) > DRAWN * len({key.plan.scheme.id for key in keys.values()})


@pytest.mark.xdist_group("office")
def test_only_listed_quantities_have_no_spreadsheet_formula(
    keys: dict[str, Key], written: Path
) -> None:
    fixed = set()
    for name, key in keys.items():
        live = read_formulas(written / f"{name}.xlsx")
        fixed |= {one.id for one in key.plan.answered if f"si.{one.id}" not in live}
    assert fixed == WITHOUT_FORMULA.keys()


def faults_of(key: Key, cells: Mapping[str, float]) -> list[str]:
    """Compare every cell of a key with the solver, in SI and as people read it."""
    expected = evaluate(key.plan, to_si(key.plan, key.given)).values
    declared = solve_variant(key.plan, key.given)
    faults = []
    for name, one in key.plan.quantities.items():
        if one.kind is Kind.MANUAL or (one.kind is Kind.CONSTANT and one not in key.plan.constants):
            continue
        role = "given" if one.kind in {Kind.GIVEN, Kind.CONSTANT} else "answer"
        for cell, right in (
            (f"si.{name}", float(expected[name])),
            (f"{role}.{name}", declared[name]),
        ):
            shown = cells.get(cell, math.nan)
            if not math.isclose(shown, right, rel_tol=1e-9, abs_tol=1e-12):
                faults.append(f"{cell} is {shown}, not {right}")
    return faults


def named_cells(file: zipfile.ZipFile) -> dict[str, str]:
    """Return the address of the cell of each defined name; all stand on the first sheet."""
    book = file.read("xl/workbook.xml").decode()
    pattern = r'<definedName[^>]* name="([^"]+)"[^>]*>[^<]*!\$([A-Z]+)\$(\d+)</definedName>'
    return {name: column + row for name, column, row in re.findall(pattern, book)}


def read_cells(path: Path) -> dict[str, float]:
    """Read the numbers of named cells; hundreds of files are too many for a whole library."""
    with zipfile.ZipFile(path) as file:
        names = named_cells(file)
        numbers = {}
        with file.open("xl/worksheets/sheet1.xml") as sheet:
            for _, cell in iterparse(sheet):  # noqa: S314 - made by this test
                if cell.tag.endswith("}c") and cell.get("t", "n") == "n":
                    value = next((part for part in cell if part.tag.endswith("}v")), None)
                    if value is not None and value.text is not None:
                        numbers[cell.get("r")] = float(value.text)
    return {name: numbers[address] for name, address in names.items() if address in numbers}


def read_formulas(path: Path) -> set[str]:
    """Return the names of the cells that hold a formula."""
    with zipfile.ZipFile(path) as file:
        text = file.read("xl/worksheets/sheet1.xml").decode()
        live = set(re.findall(r'<c r="([A-Z]+\d+)"[^>]*><f>', text))
        return {name for name, address in named_cells(file).items() if address in live}


def change_mass(path: Path, mass: float) -> None:
    """Change the given mass in the file's own text: all stored results stay, and are stale."""
    sheet, _, address = (
        openpyxl.load_workbook(path).defined_names["given.mass"].attr_text.rpartition("!")
    )
    assert sheet
    cell = re.compile(rf'(<c r="{address.replace("$", "")}"[^>]*><v>)[^<]*(</v>)')
    with zipfile.ZipFile(path) as old:
        parts = {name: old.read(name) for name in old.namelist()}
    text = parts["xl/worksheets/sheet1.xml"].decode()
    changed, count = cell.subn(rf"\g<1>{mass}\g<2>", text)
    assert count == 1
    parts["xl/worksheets/sheet1.xml"] = changed.encode()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as new:
        for name, content in parts.items():
            new.writestr(name, content)


def recalculate(folder: Path, stems: list[str]) -> None:
    """Let LibreOffice compute workbooks anew, into `out`; it stops after some 250 in one call."""
    calls = [office(folder, stems[start::CALLS], start) for start in range(CALLS)]
    for call in calls:
        _, said = call.communicate(timeout=580)
        assert call.returncode == 0, said


def office(folder: Path, stems: list[str], number: int) -> "subprocess.Popen[str]":
    """Start LibreOffice with a profile of its own."""
    profile = folder / f"profile-{number}"
    (profile / "user").mkdir(parents=True)
    (profile / "user" / "registrymodifications.xcu").write_text(RECALCULATE, encoding="utf-8")
    return subprocess.Popen(  # noqa: S603 - a fixed command on our own files
        [  # noqa: S607 - found on the path, as everywhere
            "soffice",
            f"-env:UserInstallation={profile.as_uri()}",
            "--headless",
            "--convert-to",
            "xlsx",
            "--outdir",
            str(folder / "out"),
            *(str(folder / f"{stem}.xlsx") for stem in stems),
        ],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
