"""A course in the hands of a program: each call is one use case."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.api.choices import a_day, a_name, a_text, nothing, today_here, whole_number
from gripcourse.api.choices import chosen_convention as convention_of
from gripcourse.api.choices import chosen_language as language_of
from gripcourse.api.grading import GradingWanted, grade_wanted
from gripcourse.api.make_results import (
    check_result,
    issue_result,
    refused_check,
    solution_result,
    variants_result,
)
from gripcourse.api.refusals import refusals_said
from gripcourse.api.results import (
    CheckResult,
    IssueResult,
    ProblemsResult,
    SolutionResult,
    VariantsResult,
)
from gripcourse.api.sources import FileLike, path_of, read, readable
from gripcourse.api.validate import validate
from gripcourse.course.load import load_course
from gripcourse.course.model import Course as Definition
from gripcourse.errors import UsageError
from gripcourse.exports.report_result import GradesResult
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.marks.batch_wish import BatchWish
from gripcourse.variants.table import read_table, write_table

if TYPE_CHECKING:
    import pandas as pd

    from gripcourse.usecases.solving.solve import SolvedVariant

# Every call imports what it needs itself: documents and databases cost up to half a second.
# ruff: noqa: PLC0415


@dataclass(frozen=True, slots=True)
class Course:
    """A course that can be used, with its policy; `Course.load` makes it.

    Attributes:
        definition: everything that the instructor wrote.
        policy: points, tolerances, credits and rubrics.
        language: of the sentences and titles in results: `en`, `ru` or `uk`.
    """

    definition: Definition = field(repr=False)
    policy: Policy = field(repr=False)
    language: str

    @classmethod
    @refusals_said
    def load(cls, folder: str | Path | None = None, language: str | None = None) -> "Course":
        """Load a course with its policy.

        Args:
            folder: with `variants`, `templates` and `grader`; None for the reference course.
            language: of results; None for the course's own.

        Raises:
            UsageError: the folder is no course.
            CourseError: with every problem of the course.
        """
        definition = load_course(course_root(None if folder is None else path_of(folder)))
        return cls(
            definition, load_policy(definition), language_of(language or definition.language)
        )

    @property
    def root(self) -> Path:
        """The folder of the course."""
        return self.definition.root

    @property
    def main_table(self) -> Path:
        """The table of variants that the course issues from."""
        return self.root / "variants" / "tables" / "main.csv"

    @property
    def words(self) -> Words:
        """The language of results."""
        return Words(self.language)

    def speaking(self, language: str) -> "Course":
        """Return the same course with results in another language."""
        return replace(self, language=language_of(language))

    def validate(self) -> ProblemsResult:
        """Check the folder of the course as it is now; see `gripcourse.validate`."""
        return validate(self.root, self.language)

    @refusals_said
    def variants(self, table: FileLike | None = None) -> VariantsResult:
        """Read a table of variants.

        Raises:
            TableError: with every bad row.
        """
        return variants_result(read_table(self.table_source(table), self.definition))

    @refusals_said
    def draw_variants(
        self,
        count: int,
        seed: int,
        *,
        scheme: str | None = None,
        freely: bool = False,
        out: str | Path | None = None,
    ) -> VariantsResult:
        """Draw variants; write them as a table where `out` names one.

        Args:
            count: how many.
            seed: the same seed gives the same variants.
            scheme: only this one; None for all.
            freely: whether to leave aside the rules that keep variants apart.
            out: CSV file to write; None for none.

        Raises:
            GripcourseError: there is no such scheme, or too few variants can be found.
        """
        from gripcourse.usecases.solving.variants import draw_variants

        count, seed = whole_number("count", count, 1), whole_number("seed", seed, 0)
        drawn = draw_variants(self.definition, count, seed, scheme, freely=freely)
        if out is not None:
            write_table(path_of(out), drawn.variants, self.definition)
        return variants_result(drawn.variants, drawn.tallies)

    def solve(self, variant: str, *, table: FileLike | None = None) -> "pd.DataFrame":
        """Return the values of a variant: id, symbol, title, unit, value, kind, section, source.

        Raises:
            GripcourseError: the table cannot be used, or has no such variant.
        """
        return self.solution(variant, table=table).table()

    def solve_scheme(
        self,
        scheme: str,
        given: Mapping[str, float | str] | None = None,
        options: Mapping[str, str] | None = None,
        convention: str | None = None,
    ) -> "pd.DataFrame":
        """Return the values of a scheme with values of one's own; see `scheme_solution`."""
        return self.scheme_solution(scheme, given, options, convention).table()

    @refusals_said
    def solution(
        self, variant: str, *, table: FileLike | None = None, convention: str | None = None
    ) -> SolutionResult:
        """Solve a variant of a table; the course's main one where none is named.

        Raises:
            GripcourseError: the table cannot be used, or has no such variant.
        """
        return solution_result(self.solved(variant, table, convention), self.words)

    def scheme_solution(
        self,
        scheme: str,
        given: Mapping[str, float | str] | None = None,
        options: Mapping[str, str] | None = None,
        convention: str | None = None,
    ) -> SolutionResult:
        """Solve a scheme with values of one's own.

        Args:
            scheme: id.
            given: in declared units, as numbers or as people type them; of given quantities and
                constants, or of computed ones to assume instead. What is not named is the worked
                example's.
            options: what is chosen.
            convention: `corrected` or `as_printed`; None for the course's.

        Raises:
            UsageError: an unknown name, or a value that cannot be used.
        """
        from gripcourse.usecases.solving.solve import solve_scheme

        wanted = convention_of(convention)
        named = {name: a_text("options", choice) for name, choice in (options or {}).items()}
        solved = solve_scheme(self.definition, scheme, given or {}, named, wanted)
        return solution_result(solved, self.words)

    def solved(
        self, variant: str, table: FileLike | None = None, convention: str | None = None
    ) -> "SolvedVariant":
        """Solve a variant for the writers of documents in `gripcourse.api.documents`."""
        from gripcourse.usecases.solving.solve import solve_from_table

        variants = read_table(self.table_source(table), self.definition)
        wanted = convention_of(convention)
        return solve_from_table(self.definition, variants, a_text("variant", variant), wanted)

    @refusals_said
    def issue(  # noqa: PLR0913 (all but two are for those who need them)
        self,
        roster: FileLike,
        out: str | Path,
        *,
        table: FileLike | None = None,
        deadline: date | None = None,
        today: date | None = None,
        link_days: int = 0,
        workers: int = 0,
        on_done: Callable[[str], None] = nothing,
    ) -> IssueResult:
        """Issue a variant to everybody on a roster and write their documents.

        Args:
            roster: table of the students.
            out: folder to write a folder per student to.
            table: of variants; None for the course's main one.
            deadline: last day for handing in.
            today: day of the issue; None for today.
            link_days: how long the personal link on each sheet is good for; 0 for none.
            workers: how many processes lay out documents; 0 for none but this one.
            on_done: called with each student's id.

        Raises:
            GripcourseError: something cannot be used; nothing was issued.
        """
        from gripcourse.usecases.issuing.issue import Order, issue_order

        order = Order(
            roster=readable(roster, "roster"),
            table=self.table_source(table),
            out=path_of(out),
            today=a_day("today", today) or today_here(),
            deadline=a_day("deadline", deadline),
            link_days=link_days,
        )
        workers = whole_number("workers", workers, 0)
        issuing = issue_order(self.definition, self.policy, order, workers, on_done)
        return issue_result(issuing, self.words)

    @refusals_said
    def check(
        self, workbook: FileLike, *, ledger: str | Path | None = None, who: str = ""
    ) -> CheckResult:
        """Say how a workbook is read, and by policy whether its numbers fit; never the answers.

        A file that is no answer workbook is no exception: the result says why in `refusal`.

        Args:
            workbook: path of a file, or bytes with their name.
            ledger: file in which a server counts who was told how often whether numbers fit each
                other; without it only the reading is told.
            who: id of who is signed in, as the server knows it; the workbook could name anybody.

        Raises:
            GripcourseError: a file that is named cannot be read, or the ledger cannot be written,
                or there is a ledger and nobody is named.
        """
        from gripcourse.gradebook.checks import CheckLedger
        from gripcourse.usecases.grading.check import check_file

        counted = None if ledger is None else CheckLedger(path_of(ledger), a_name("who", who))
        source = read(workbook, "workbook")
        try:
            checked = check_file(source, self.definition, self.policy, ledger=counted)
        except UsageError as refused:
            return refused_check(refused.problems, self.words)
        return check_result(checked, self.words)

    @refusals_said
    def grade(  # noqa: PLR0913 (all but the first are for those who need them)
        self,
        files: FileLike | Iterable[FileLike],
        *,
        out: str | Path | None = None,
        gradebook: str | Path | None = None,
        graded_on: date | None = None,
        whose: Mapping[str, str] | None = None,
        handed_in: Iterable[str] = (),
        pattern: str | None = None,
        either_version: bool | None = None,
        recalculate: bool = False,
        workers: int = 0,
        on_done: Callable[[object], None] = nothing,
    ) -> GradesResult:
        """Grade workbooks against what was issued from this course.

        Args:
            files: paths of files and folders, or bytes with their names; or one of them.
            out: folder to write reports, the cohort summary and grades to; None to write nothing.
            gradebook: path or database URL, to keep the attempts in and to take the marks of
                persons from; None for none.
            graded_on: day that documents bear; None for today.
            whose: ids of students by file, where a person says who handed it in.
            handed_in: when files were handed in, as `file=2026-12-01 18:00`, or one moment for all;
                files of which nothing is said have their own time, bytes none.
            pattern: where your own paths say whose a file is, as `{name}/{id}*.xlsx`; None where
                only platforms' own ways count.
            either_version: of what was issued anew, whether the version counts that gives more;
                None as the gradebook says, else the workbook's own version.
            recalculate: whether LibreOffice computes all formulas, and results that differ are
                flagged; it needs a worker and takes half a second for each work.
            workers: how many processes, each bounded in time and memory; 0 for none but this one,
                where a hostile file can take the whole program along.
            on_done: called with each file when it is graded.

        Raises:
            GripcourseError: a path does not exist, or the register or gradebook cannot be used. The
                faults of a submission are in its report.
        """
        wish = BatchWish(
            whose=tuple(f"{file}={student}" for file, student in (whose or {}).items()),
            handed_in=tuple(handed_in),
            pattern=None if pattern is None else a_text("pattern", pattern),
            either_version=either_version,
            recalculate=recalculate,
        )
        day = a_day("graded_on", graded_on)
        wanted = GradingWanted(files, out, gradebook, day, wish, workers, on_done)
        return grade_wanted(self.definition, self.policy, self.words, wanted)

    def table_source(self, table: FileLike | None) -> Path | NamedBytes:
        """Return the table that is meant: the named one, else the course's main one."""
        return self.main_table if table is None else readable(table, "variants")
