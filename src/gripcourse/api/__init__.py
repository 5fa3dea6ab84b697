"""The library for other programs: `import gripcourse as gc` offers what stands here.

What is not offered here is the engine: it may change with every version.
"""

from gripcourse.api.course import Course
from gripcourse.api.documents import (
    audit_variants,
    doctor,
    draw_atlas,
    import_variants,
    init_course,
    write_general_view,
    write_key,
    write_reference,
    write_solution,
)
from gripcourse.api.marks import enter_mark, enter_marks, trace, what_waits
from gripcourse.api.measuring import audit_tolerances, evaluate, evaluate_in_memory, simulate
from gripcourse.api.regrading import apply_regrade, history, publish, regrade, undo_regrade, waive
from gripcourse.api.reissuing import reissue
from gripcourse.api.results import (
    CheckResult,
    IssueResult,
    ProblemsResult,
    SolutionResult,
    VariantsResult,
)
from gripcourse.api.schema import read_result, schemas
from gripcourse.api.validate import validate
from gripcourse.api.withdrawing import WithdrawResult, withdraw
from gripcourse.errors import GripcourseError, NextStep, Problem
from gripcourse.exports.report_result import GradesResult, ReportResult
from gripcourse.gradebook.enter import Draft
from gripcourse.machine.content import NamedBytes

__all__ = [
    "CheckResult",
    "Course",
    "Draft",
    "GradesResult",
    "GripcourseError",
    "IssueResult",
    "NamedBytes",
    "NextStep",
    "Problem",
    "ProblemsResult",
    "ReportResult",
    "SolutionResult",
    "VariantsResult",
    "WithdrawResult",
    "apply_regrade",
    "audit_tolerances",
    "audit_variants",
    "doctor",
    "draw_atlas",
    "enter_mark",
    "enter_marks",
    "evaluate",
    "evaluate_in_memory",
    "history",
    "import_variants",
    "init_course",
    "publish",
    "read_result",
    "regrade",
    "reissue",
    "schemas",
    "simulate",
    "trace",
    "undo_regrade",
    "validate",
    "waive",
    "what_waits",
    "withdraw",
    "write_general_view",
    "write_key",
    "write_reference",
    "write_solution",
]
