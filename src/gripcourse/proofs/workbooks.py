"""The key workbooks compute what the solver computes: LibreOffice recalculates them."""

import math
import re
import tempfile
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final
from xml.etree.ElementTree import iterparse

from gripcourse.course.quantity import Kind
from gripcourse.errors import Problem
from gripcourse.machine.files import write_bytes
from gripcourse.machine.office import converted
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, concluded
from gripcourse.proofs.samples import Trial
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import evaluate, solve_variant, to_si
from gripcourse.text.words import Words, message
from gripcourse.variants.model import Variant

_OF_EACH: Final = 2  # variants of each composition: a file takes ten times as long as a proof
_LANGUAGE: Final = "en"  # by which texts would be read as numbers; a key has none
_SAME, _NOTHING = 1e-9, 1e-12
_NAMED_CELL: Final = re.compile(
    r'<definedName[^>]* name="([^"]+)"[^>]*>[^<]*!\$([A-Z]+)\$(\d+)</definedName>'
)


@dataclass(frozen=True, slots=True)
class KeyFile:
    """A variant, its plan, and the name of the file of its key."""

    name: str
    plan: Plan
    variant: Variant


def prove_workbooks(
    by_scheme: Mapping[str, Sequence[Trial]], office: str | None
) -> Iterator[ProofResult]:
    """Write the key of every variant, let LibreOffice compute all anew, and compare every cell.

    Args:
        by_scheme: numbers to try, by scheme.
        office: the command that starts it; None where the machine has none.

    Returns:
        A result for each scheme; open where there is no LibreOffice.
    """
    keys = {scheme: key_files(scheme, trials) for scheme, trials in by_scheme.items() if trials}
    if office is None:
        said = message("Not proved here: this machine has no LibreOffice (gripcourse doctor).")
        for scheme, files in keys.items():
            proof = _proof(scheme, files)
            yield ProofResult(proof, Verdict.OPEN, 0, (), said)
        return
    with tempfile.TemporaryDirectory() as written:
        folder = Path(written)
        every = [one for files in keys.values() for one in files]
        write_keys(folder, every)
        recalculate(folder, [one.name for one in every], office)
        for scheme, files in keys.items():
            proof = _proof(scheme, files)
            problems = [
                problem
                for one in files
                for problem in _faults(proof, one, folder / "out" / f"{one.name}.xlsx")
            ]
            cells = sum(len(one.plan.quantities) for one in files)
            yield concluded(proof, cells, tuple(problems))


def key_files(scheme: str, trials: Sequence[Trial]) -> list[KeyFile]:
    """Name the file of the key of each variant of a scheme."""
    return [
        KeyFile(f"{scheme}-{number}-{place}", trial.plan, _issued(trial.plan, variant))
        for number, trial in enumerate(trials)
        for place, variant in enumerate(trial.variants[:_OF_EACH])
    ]


def write_keys(folder: Path, keys: Sequence[KeyFile]) -> None:
    """Write the key workbook of each variant into a folder."""
    from gripcourse.workbook.key import write_key_workbook  # noqa: PLC0415 (xlsxwriter)

    for one in keys:
        words = Words(one.plan.course.language)
        write_key_workbook(folder / f"{one.name}.xlsx", one.plan, one.variant, words)


def recalculate(folder: Path, names: Sequence[str], office: str) -> None:
    """Let LibreOffice compute workbooks anew, into the folder `out` beside them.

    One that it did not write shows as cells without a number.
    """
    files = {f"{name}.xlsx": (folder / f"{name}.xlsx").read_bytes() for name in names}
    for name, data in converted(files, office, _LANGUAGE).made.items():
        write_bytes(folder / "out" / name, data, private=True, lasting=False)


def differing_cells(
    plan: Plan, given: Mapping[str, float], cells: Mapping[str, float]
) -> Iterator[tuple[str, float, float]]:
    """Yield every named cell that does not hold the solver's number, with both.

    Args:
        plan: of the variant.
        given: what stands in the file, in declared units.
        cells: numbers of named cells.
    """
    expected = evaluate(plan, to_si(plan, given)).values
    declared = solve_variant(plan, given)
    for name, one in plan.quantities.items():
        if one.kind is Kind.MANUAL or (one.kind is Kind.CONSTANT and one not in plan.constants):
            continue
        role = "given" if one.kind in {Kind.GIVEN, Kind.CONSTANT} else "answer"
        for cell, right in (
            (f"si.{name}", float(expected[name])),
            (f"{role}.{name}", declared[name]),
        ):
            shown = cells.get(cell, math.nan)
            if not math.isclose(shown, right, rel_tol=_SAME, abs_tol=_NOTHING):
                yield cell, shown, right


def named_cells(file: zipfile.ZipFile) -> dict[str, str]:
    """Return the address of the cell of each defined name; all stand on the first sheet."""
    book = file.read("xl/workbook.xml").decode()
    return {name: column + row for name, column, row in _NAMED_CELL.findall(book)}


def read_cells(path: Path) -> dict[str, float]:
    """Read the numbers of named cells; hundreds of files are too many for a whole library."""
    if not path.exists():
        return {}
    with zipfile.ZipFile(path) as file:
        names = named_cells(file)
        numbers = {}
        with file.open("xl/worksheets/sheet1.xml") as sheet:
            for _, cell in iterparse(sheet):  # noqa: S314 - written by LibreOffice from our file
                if cell.tag.endswith("}c") and cell.get("t", "n") == "n":
                    value = next((part for part in cell if part.tag.endswith("}v")), None)
                    if value is not None and value.text is not None:
                        numbers[cell.get("r")] = float(value.text)
    return {name: numbers[address] for name, address in names.items() if address in numbers}


def _issued(plan: Plan, variant: Variant) -> Variant:
    """Return a variant without the decisions of a worked example: a key computes them."""
    known = {one.id for one in (*plan.givens, *plan.constants)}
    given = {name: value for name, value in variant.given.items() if name in known}
    return replace(variant, given=given)


def _proof(scheme: str, files: Sequence[KeyFile]) -> Proof:
    return Proof(ProofKind.WORKBOOKS, scheme, files[0].plan.scheme.file, "")


def _faults(proof: Proof, one: KeyFile, path: Path) -> Iterator[Problem]:
    cells = read_cells(path)
    if not cells:
        said = message("LibreOffice did not read the key of variant {id}.", id=one.variant.id)
        yield Problem(proof.file, "", said, message("Try again; is there room on the disk?"))
        return
    for cell, shown, right in differing_cells(one.plan, one.variant.given, cells):
        quantity = one.plan.quantities[cell.partition(".")[2]]
        yield Problem(
            quantity.file,
            f"quantity.{quantity.id}",
            message(
                "In the key of variant {id} the cell {cell} becomes {shown}, the solver computes"
                " {right}.",
                id=one.variant.id,
                cell=cell,
                shown=shown,
                right=right,
            ),
            message("Write the formula in another way; this is our mistake, tell us."),
        )
