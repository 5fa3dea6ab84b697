"""The key workbook computes what the solver computes: a spreadsheet program is the judge."""

import re
import shutil
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import openpyxl
import pytest

from gripcourse.machine.office import office_command
from gripcourse.proofs.samples import Trial
from gripcourse.proofs.workbooks import (
    KeyFile,
    differing_cells,
    key_files,
    named_cells,
    prove_workbooks,
    read_cells,
    recalculate,
    write_keys,
)

FACTOR = 1.25  # by which the mass is changed in the file, under the stored results
# Quantities that no spreadsheet formula computes, and why.
WITHOUT_FORMULA: Mapping[str, str] = {
    "contact_factor": "the exact coefficient of crossed cylinders holds elliptic integrals",
}


@dataclass(frozen=True, slots=True)
class Firsts:
    """The key of the first variant of each of the few trials, written once."""

    folder: Path
    keys: tuple[KeyFile, ...]

    def copy(self, folder: Path, keys: Sequence[KeyFile]) -> None:
        """Write keys into a folder, which are among these."""
        assert {one.name for one in keys} <= {one.name for one in self.keys}
        for one in keys:
            shutil.copy(self.folder / f"{one.name}.xlsx", folder)


@pytest.fixture(scope="module")
def firsts(
    few_trials: dict[str, tuple[Trial, ...]], tmp_path_factory: pytest.TempPathFactory
) -> Firsts:
    folder = tmp_path_factory.mktemp("keys")
    keys = tuple(
        one
        for scheme, own in few_trials.items()
        for one in key_files(scheme, own)
        if one.name.endswith("-0")
    )
    write_keys(folder, keys)
    return Firsts(folder, keys)


@pytest.mark.office
@pytest.mark.xdist_group("office")
def test_a_spreadsheet_computes_every_formula_of_a_key_as_the_solver_does(
    few_trials: dict[str, tuple[Trial, ...]], firsts: Firsts, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In every scheme, and every quantity with each of its formulas in some of them.

    `gripcourse validate --prove` writes the key of every trial, for two variants.
    """
    monkeypatch.setattr("gripcourse.proofs.workbooks._OF_EACH", 1)
    monkeypatch.setattr("gripcourse.proofs.workbooks.write_keys", firsts.copy)
    results = tuple(prove_workbooks(few_trials, office_command()))
    assert [one.problems for one in results if one.problems] == []
    assert len(results) == len(few_trials)


@pytest.mark.office
@pytest.mark.xdist_group("office")
def test_a_changed_mass_changes_the_results(
    trials: dict[str, tuple[Trial, ...]], tmp_path: Path
) -> None:
    """Else the stored results would be compared with themselves."""
    office = office_command()
    assert office is not None
    key = key_files("screw", trials["screw"])[0]
    mass = key.variant.given["mass"] * FACTOR
    write_keys(tmp_path, [key])
    change_mass(tmp_path / f"{key.name}.xlsx", mass)
    recalculate(tmp_path, [key.name], office)
    cells = read_cells(tmp_path / "out" / f"{key.name}.xlsx")
    assert list(differing_cells(key.plan, {**key.variant.given, "mass": mass}, cells)) == []
    assert list(differing_cells(key.plan, key.variant.given, cells))


def test_only_listed_quantities_have_no_spreadsheet_formula(firsts: Firsts) -> None:
    fixed = set()
    for key in firsts.keys:
        live = read_formulas(firsts.folder / f"{key.name}.xlsx")
        fixed |= {one.id for one in key.plan.answered if f"si.{one.id}" not in live}
    assert fixed == WITHOUT_FORMULA.keys()


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
