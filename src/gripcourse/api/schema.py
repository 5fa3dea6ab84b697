"""The versioned forms in which results leave and enter the program, as JSON Schema documents."""

from collections.abc import Mapping
from typing import Any, Final

from gripcourse.api.results import (
    CheckResult,
    IssueResult,
    ProblemsResult,
    SolutionResult,
    VariantsResult,
)
from gripcourse.errors import Problem, UsageError
from gripcourse.exports.plain import KEY, from_plain, json_schema
from gripcourse.exports.report_result import GradesResult, ReportResult
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

KINDS: Final[tuple[type[Any], ...]] = (
    CheckResult,
    GradesResult,
    IssueResult,
    ProblemsResult,
    ReportResult,
    SolutionResult,
    VariantsResult,
)
_BY_SCHEMA: Final[Mapping[str, type[Any]]] = {one.SCHEMA: one for one in KINDS}


def schemas() -> dict[str, dict[str, Any]]:
    """Return the JSON Schema (2020-12) of every form, by its name, `gripcourse/report/1`."""
    return {name: json_schema(kind) for name, kind in _BY_SCHEMA.items()}


def read_result(plain: object) -> Any:  # noqa: ANN401 (of the kind that it names)
    """Read a result of any kind from its plain form.

    Raises:
        UsageError: its form or its version is not known, or with every value that cannot be used.
    """
    name = str(plain.get(KEY, "")) if isinstance(plain, Mapping) else ""
    family = name.rpartition("/")[0]
    known = next((one for one in _BY_SCHEMA if one.rpartition("/")[0] == family), "")
    if not known:
        what = message("The form '{name}' is not known.", name=name)
        raise UsageError([Problem("", KEY, what, did_you_mean(name, _BY_SCHEMA))])
    return from_plain(_BY_SCHEMA[known], plain)
