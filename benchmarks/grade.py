"""What grading one submission costs, as a ratio to opening the same file with openpyxl.

Both are measured in turn, so that a machine that changes its speed meanwhile changes no ratio.
"""

import gc
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import replace
from datetime import date
from pathlib import Path
from statistics import median
from time import process_time

from openpyxl import load_workbook

from gripcourse.batch.context import GradingContext
from gripcourse.batch.one_file import grade_file, methods_of
from gripcourse.cli.demo.students import correct
from gripcourse.course.load import load_course
from gripcourse.course.quantity import Kind
from gripcourse.grading.judge import judge
from gripcourse.grading.rounding import figure_half_unit
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.simulation.write import fill
from gripcourse.solver.plan import make_plan
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Rejected, Submission
from gripcourse.submission.read import read_workbook
from gripcourse.text.words import Words
from gripcourse.variants.model import Issued, Student
from gripcourse.variants.table import read_table
from gripcourse.workbook.write import write_answer_workbook

RUNS = 15
SCHEME = "rack_parallelogram"
WRONG = (1.37, 0.71, 1.19, 1.43, 0.83)  # times the right values


def main() -> None:
    """Read and judge one filled workbook; every figure and its ratio come from one run."""
    course = load_course(course_root())
    table = read_table(course.root / "variants" / "tables" / "main.csv", course)
    variant = next(one for one in table if one.scheme == SCHEME)
    student = Student("s1", "Student", "", "", "en", "")
    issued = Issued(student, variant, date(2026, 9, 1), None, "0" * 64)
    plan = make_plan(course, variant.scheme, variant.options)
    context = GradingContext(course, load_policy(course), {student.id: issued})
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "s1.xlsx"
        write_answer_workbook(file, plan, issued, course, Words("en"))
        fill(file, correct(plan, issued), file)
        raw = read_workbook(file)
        if isinstance(raw, Rejected):
            raise TypeError(str(raw.reason))
        submission = interpret(raw, plan.quantities.values())
        computed = [one.id for one in plan.answered if one.kind is Kind.FORMULA]
        slipped = _changed(submission, {"drive_force": 0.5})  # one jaw of two
        wrong = _changed(
            submission, dict(zip(computed[:: len(computed) // 5], WRONG, strict=False))
        )

        def opened() -> None:
            load_workbook(file)

        print(
            f"openpyxl.load_workbook                   {_in_turn(opened, opened)[0] * 1e3:7.1f} ms"
        )
        for name, call in (
            ("read the workbook", lambda: read_workbook(file)),
            ("make the plan", lambda: make_plan(course, variant.scheme, variant.options)),
            ("interpret the cells", lambda: interpret(raw, plan.quantities.values())),
            ("judge, all right", lambda: _judge(context, submission, issued)),
            ("judge and name one slip", lambda: _judge(context, slipped, issued)),
            ("judge alone, explain five wrong answers", lambda: _judge(context, wrong, issued)),
            ("read and grade, all in all", lambda: grade_file(file, context)),
        ):
            seconds, ratio = _in_turn(call, opened)
            print(f"{name:<40} {seconds * 1e3:7.1f} ms, ratio {ratio:.2f}")


def _judge(context: GradingContext, submission: Submission, issued: Issued) -> None:
    plan, methods = methods_of(context, issued.variant)
    judge(submission, issued, plan, context.policy, methods)


def _changed(submission: Submission, factors: Mapping[str, float]) -> Submission:
    """Return a submission with some answers multiplied, typed with six figures."""
    answers = dict(submission.answers)
    for name, by in factors.items():
        value = float(f"{(answers[name].value or 0.0) * by:.5e}")
        half_unit = figure_half_unit(value, 6)
        answers[name] = replace(answers[name], value=value, half_unit=half_unit)
    return replace(submission, answers=answers)


def _in_turn(call: Callable[[], object], base: Callable[[], object]) -> tuple[float, float]:
    """Return the seconds that a call takes, and their ratio to those of another one."""
    pairs = [(_seconds(call), _seconds(base)) for _ in range(RUNS + 1)][1:]
    return median(one for one, _ in pairs), median(one / other for one, other in pairs)


def _seconds(call: Callable[[], object]) -> float:
    # What the other one left for the collector of garbage is not counted here.
    gc.collect()
    start = process_time()
    call()
    return process_time() - start


if __name__ == "__main__":
    main()
