"""The key workbook computes what the solver computes: a spreadsheet program is the judge."""

import re
import subprocess
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import openpyxl
import pytest
from openpyxl.workbook import Workbook

from gripcourse.course.model import Course, Kind
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate, solve_variant, to_si
from gripcourse.variants.draw import draw
from gripcourse.variants.model import Variant
from gripcourse.variants.space import load_spaces
from gripcourse.variants.table import read_table
from gripcourse.words import Words
from gripcourse.workbook.key import write_key_workbook

ISSUED = 20
CHANGED = "changed"
FACTOR = 1.25  # by which the mass is changed in the file, under the stored results
# Quantities that no spreadsheet formula computes, and why.
WITHOUT_FORMULA: Mapping[str, str] = {}
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


def keys(course: Course) -> dict[str, Key]:
    """Choose variants: each example with all its options, and issued or drawn ones."""
    chosen = [
        Variant(f"example-{scheme.id}", scheme.id, scheme.example.options, scheme.example.given)
        for scheme in course.schemes.values()
        if scheme.example is not None
    ]
    table = course.root / "variants" / "tables" / "main.csv"
    issued = (
        read_table(table, course)
        if table.exists()
        else draw(course, load_spaces(course), ISSUED, seed=1).variants
    )
    step = max(1, len(issued) // ISSUED)
    chosen += issued[::step][:ISSUED]
    found = {
        one.id: Key(make_plan(course, one.scheme, one.options), one, one.given) for one in chosen
    }
    last = chosen[-1]
    other = {**last.given, "mass": last.given["mass"] * FACTOR}
    found[CHANGED] = Key(found[last.id].plan, last, other)
    return found


@pytest.mark.office
@pytest.mark.xdist_group("office")
def test_a_spreadsheet_computes_the_key_as_the_solver_does(course: Course, tmp_path: Path) -> None:
    found = keys(course)
    for name, key in found.items():
        write_key_workbook(tmp_path / f"{name}.xlsx", key.plan, key.variant, Words("ru"))
    change_mass(tmp_path / f"{CHANGED}.xlsx", found[CHANGED].given["mass"])
    computed = recalculate(tmp_path, list(found))
    faults = [
        f"{name}: {fault}"
        for name, key in found.items()
        for fault in faults_of(key, computed[name])
    ]
    assert faults == []
    assert len(found) > ISSUED


def test_only_listed_quantities_have_no_spreadsheet_formula(course: Course, tmp_path: Path) -> None:
    fixed = set()
    for name, key in keys(course).items():
        path = tmp_path / f"{name}.xlsx"
        write_key_workbook(path, key.plan, key.variant, Words("en"))
        book = openpyxl.load_workbook(path)
        fixed |= {
            one.id
            for one in key.plan.answered
            if not str(cell_value(book, f"si.{one.id}")).startswith("=")
        }
    assert fixed == WITHOUT_FORMULA.keys()


def faults_of(key: Key, book: Workbook) -> list[str]:
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
            shown = cell_value(book, cell)
            if not isinstance(shown, int | float) or not np.isclose(
                float(shown), right, rtol=1e-9, atol=1e-12
            ):
                faults.append(f"{cell} is {shown}, not {right}")
    return faults


def cell_value(book: Workbook, name: str) -> object:
    """Read the cell of a defined name."""
    sheet, _, address = book.defined_names[name].attr_text.rpartition("!")
    return book[sheet.strip("'")][address.replace("$", "")].value


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


def recalculate(folder: Path, stems: list[str]) -> dict[str, Workbook]:
    """Let LibreOffice compute workbooks anew, all in one call."""
    profile = folder / "profile"
    (profile / "user").mkdir(parents=True)
    (profile / "user" / "registrymodifications.xcu").write_text(RECALCULATE, encoding="utf-8")
    subprocess.run(  # noqa: S603 - a fixed command on our own files
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
        check=True,
        capture_output=True,
        timeout=300,
    )
    return {
        stem: openpyxl.load_workbook(folder / "out" / f"{stem}.xlsx", data_only=True)
        for stem in stems
    }
