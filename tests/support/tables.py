"""What programs for tables would run."""

import csv
import io
import re

FORMULA_STARTS = ("=", "+", "-", "@", "\t", "\r", "\n", "\uff1d")


def formulas_in(table: str) -> list[str]:
    """Return the cells that are run, wherever a program thinks that cells end."""
    cells = [
        cell.strip(' "')
        for separator in ",;\t"
        for row in csv.reader(io.StringIO(table, newline=""), delimiter=separator)
        for cell in row
    ]
    # Who does not know our quotes begins a row at each line end.
    cells += [part for line in table.splitlines() for part in re.split("[;\t]", line)]
    return [cell for cell in cells if cell.strip() and cell.startswith(FORMULA_STARTS)]
