"""What the commands print that grade, mark and show what came of it."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.cli import times_text
from gripcourse.cli.file_names import told_apart
from gripcourse.cli.missing_text import missing_text
from gripcourse.cli.pattern_text import LOOKED_AT, for_names, without_fit
from gripcourse.cli.table_layout import table_text
from gripcourse.grading.flag_code import FlagCode
from gripcourse.machine.shelf import Shelved
from gripcourse.text.shown import one_line
from gripcourse.text.words import Words, counted, message

# `gripcourse --help` needs nothing of what is graded.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from gripcourse.batch.context import GradingContext
    from gripcourse.cli.demo.run import Demo
    from gripcourse.gradebook.counted import CountedWork
    from gripcourse.gradebook.waiting import Waiting
    from gripcourse.grading.model import Report
    from gripcourse.usecases.grading.grade import GradingOutcome
    from gripcourse.usecases.marks.mark import Marking

FLAGS = {
    FlagCode.ANSWERS_MISSING: message("cells missing"),
    FlagCode.COPIED_FROM: message("copied by others"),
    FlagCode.CELLS_MOVED: message("rows moved"),
    FlagCode.GIVENS_CHANGED: message("given values changed"),
    FlagCode.GIVENS_MISSING: message("given values missing"),
    FlagCode.IDENTITY_CHANGED: message("variant changed"),
    FlagCode.IDENTITY_MISSING: message("issued to nobody"),
    FlagCode.INCIDENT: message("failure on our side"),
    FlagCode.ISSUED_TO_OTHER: message("issued to another"),
    FlagCode.MARK_OUTDATED: message("mark outdated"),
    FlagCode.NOT_JUDGED: message("not judged"),
    FlagCode.NOT_RECALCULATED: message("not recalculated"),
    FlagCode.OTHER_VARIANT: message("another's variant"),
    FlagCode.REGRADE_WAITS: message("regrade waits"),
    FlagCode.REJECTED: message("file rejected"),
    FlagCode.REPORT_INCIDENT: message("no report"),
    FlagCode.RESULTS_DIFFER: message("other results"),
    FlagCode.SAME_ANSWERS: message("another's answers"),
    FlagCode.SAME_BYTES: message("another's file"),
    FlagCode.SAME_CREATOR: message("same author"),
    FlagCode.SEVERAL_FILES: message("several files"),
    FlagCode.SIGNATURE: message("wrong signature"),
    FlagCode.TIME_DOUBTFUL: message("when handed in?"),
    FlagCode.UNKNOWN_STUDENT: message("unknown student"),
    FlagCode.UNREADABLE: message("unreadable"),
    FlagCode.WHO_HANDED_IN: message("who handed this in?"),
}
"""Each flag in two words, for a table; below it every flag has its sentence."""

_NAMED = 10  # files of one kind, or students, that a line names


def grading_text(outcome: "GradingOutcome", out: Path, words: Words) -> str:
    """Return the scores as a table, what a person must look at, and where everything is."""
    return with_taken_over(batch_text(outcome, out, words), outcome, words)


def with_taken_over(text: str, outcome: "GradingOutcome", words: Words) -> str:
    """Add to the text of a batch how much of it an earlier run had found out."""
    if not (outcome.taken_over.results or outcome.taken_over.reports):
        return text
    said = message(
        "Nothing changed for {results} of {files} files and {reports} of {written} reports: "
        "taken over as they were. --afresh makes all of them anew.",
        results=outcome.taken_over.results,
        files=len(outcome.reports),
        reports=outcome.taken_over.reports,
        written=len(outcome.written),
    )
    return f"{text}\n{words.say(said)}"


def batch_text(outcome: "GradingOutcome", out: Path, words: Words) -> str:
    """Return what `grading_text` does but for what was taken over: the same at each run."""
    from gripcourse.usecases.grading.batch_tables import FILES_CSV, GRADES_CSV
    from gripcourse.usecases.grading.grade import INCIDENTS, REPORTS

    called = told_apart([one.file for one in outcome.reports])
    lines = list[str]()
    asks = False
    names = set[str]()  # of those who handed something in
    nobodys = list[str]()  # files, the first of them

    def row(one: "Report") -> tuple[str, ...]:
        nonlocal asks
        lines.extend(f"{called(one.file)}: {words.say(flag.message)}" for flag in one.flags)
        asks |= any(flag.code is FlagCode.WHO_HANDED_IN for flag in one.flags)
        names.add(one.name)
        if len(nobodys) < LOOKED_AT and _is_nobodys(one):
            nobodys.append(one.file)
        return (
            called(one.file),
            one_line(one.name) or one.student or "—",
            one.variant or "—",
            _score(one, words),
            _flags(one, words),
        )

    # Looked at once; and of a batch of any size no row is held.
    rows = Shelved(map(row, outcome.reports))
    heads = (
        message("file"),
        message("student"),
        message("variant"),
        message("points"),
        message("flags"),
    )
    lines.insert(0, table_text([words.say(head) for head in heads], rows, right={3}))
    if asks:
        said = message("Ask, then grade again and say so, for example --whose s002.xlsx=s003.")
        lines.append(words.say(said))
    lines += without_fit(outcome.unfitting, outcome.reports, words)
    lines += for_names(nobodys, outcome.missing, words)
    lines += _passed_over(outcome, words)
    lines += times_text.without_times(outcome.reports, words)
    lines += times_text.without_deadlines(outcome.undated, words)
    others = [one.file for one in outcome.passed_over if one.needs_person]
    lines += missing_text(outcome.missing, names, others, words)
    if outcome.left_over:
        said = message(
            "Reports of an earlier run that this one did not renew: {names}.",
            names=", ".join(path.name for path in outcome.left_over),
        )
        lines.append(words.say(said))
    lines += _cohort_fault(outcome, words)
    if outcome.grades_only:
        lines.append(words.say(message("No reports were printed, as you said.")))
    incidents = out / INCIDENTS
    for said, place in (
        (message("Student reports"), None if outcome.grades_only else out / REPORTS),
        (message("Cohort summary"), outcome.cohort),
        (message("Grades"), out / GRADES_CSV),
        (message("What became of every file"), out / FILES_CSV),
        (message("Incidents, each with its trace"), incidents if incidents.exists() else None),
    ):
        if place is not None:
            lines.append(f"{words.say(said)}: {place}")
    return "\n".join(lines)


def problems_text(outcome: "GradingOutcome", out: Path, words: Words) -> str:
    """Return what must be said even where nothing else is: our faults, and how much waits."""
    from gripcourse.usecases.grading.batch_tables import FILES_CSV
    from gripcourse.usecases.grading.grade import INCIDENTS

    ours = FlagCode.INCIDENT, FlagCode.REPORT_INCIDENT
    flagged = [(one.file, one.flags) for one in outcome.reports if one.flags]
    said_of = [(file, flag) for file, flags in flagged for flag in flags if flag.code in ours]
    lines = list[str]()
    if said_of:
        called = told_apart([one.file for one in outcome.reports])
        lines += [f"{called(file)}: {words.say(flag.message)}" for file, flag in said_of]
    lines += _cohort_fault(outcome, words)
    waiting = len(flagged)
    waiting += sum(one.needs_person for one in outcome.passed_over)
    if waiting:
        said = message("Files that wait for a person: {count}.", count=waiting)
        lines.append(
            f"{words.say(said)} {words.say(message('What became of every file'))}: "
            f"{out / FILES_CSV}"
        )
    if (out / INCIDENTS).exists():
        said = message("Incidents, each with its trace")
        lines.append(f"{words.say(said)}: {out / INCIDENTS}")
    return "\n".join(lines)


def _is_nobodys(report: "Report") -> bool:
    return any(flag.code is FlagCode.UNKNOWN_STUDENT for flag in report.flags)


def _cohort_fault(outcome: "GradingOutcome", words: Words) -> Iterator[str]:
    """Say that and why the report on the batch could not be laid out."""
    if outcome.cohort is None and not outcome.grades_only:
        said = words.say(message("The report on the batch could not be laid out."))
        yield f"{said} {one_line(outcome.cohort_fault)}".rstrip()


def _passed_over(outcome: "GradingOutcome", words: Words) -> Iterator[str]:
    """Yield a line for each reason why files were not looked at; `files.csv` names them all."""
    from gripcourse.usecases.grading.collect import REASONS

    called = told_apart([one.file for one in outcome.passed_over])
    for why, reason in REASONS.items():
        names = [called(one.file) for one in outcome.passed_over if one.why is why]
        if names:
            more = f", … ({len(names)})" if len(names) > _NAMED else ""
            said = message(
                "Not looked at: {names}. {reason}",
                names=", ".join(names[:_NAMED]) + more,
                reason=reason,
            )
            yield words.say(said)


def waiting_text(
    waits: Sequence["Waiting"],
    instead: Mapping[str, "CountedWork"],
    context: "GradingContext",
    words: Words,
) -> str:
    """Return what waits for a person as a table.

    Args:
        waits: items, each with the file of the student's last work.
        instead: by student, the work that counts where it is another one.
        context: of the course.
        words: the reader's language.
    """
    from gripcourse.usecases.marks.called import item_with_id, student_with_id

    if not waits:
        return words.say(message("Nothing waits for the instructor."))

    def told(one: "Waiting") -> str:
        said = [words.say(message("marked; look again"))] if one.again else []
        counted = instead.get(one.student)
        if counted is not None and counted.timing is not None:
            file, number = one_line(Path(counted.attempt.file).name), counted.timing.number
            counts = message("attempt {number} counts: {file}", number=number, file=file)
            said.append(words.say(counts))
        return "; ".join(said)

    rows = [
        (
            student_with_id(one.student, context),
            item_with_id(one.student, one.quantity, context, words.language),
            one_line(Path(one.file).name),
            told(one),
        )
        for one in waits
    ]
    heads = (message("student"), message("item"), message("file"))
    return table_text([*(words.say(head) for head in heads), ""], rows, right=set())


def marking_text(marking: "Marking", context: "GradingContext", words: Words) -> str:
    """Return what the marks came to."""
    from gripcourse.usecases.marks.called import item_with_id, student_with_id

    lines = []
    for item in marking.items:
        mark = item.mark
        student = student_with_id(mark.student, context)
        called = item_with_id(mark.student, mark.quantity, context, words.language)
        said = message("{student}, {item}: withdrawn.", student=student, item=called)
        if item.points is not None:
            said = message(
                "{student}, {item}: {points} of {most} points.",
                student=student,
                item=called,
                points=round(item.points, 2),
                most=round(item.max_points, 2),
            )
        lines.append(words.say(said))
    if marking.unchanged:
        lines.append(
            words.say(
                counted(
                    "{count} mark was already the same.",
                    "{count} marks were already the same.",
                    marking.unchanged,
                )
            )
        )
    if marking.empty:
        lines.append(
            words.say(
                message("Rows without a mark that were left out: {count}.", count=marking.empty)
            )
        )
    if marking.items:
        lines.append(words.say(message("Grade again to renew the reports.")))
    return "\n".join(lines) or words.say(message("There was nothing to enter."))


def demo_text(demo: "Demo", words: Words) -> str:
    """Return what each scripted student did and got, and where everything is."""
    from gripcourse.cli.demo.students import TOLD

    by_student = {one.student: one for one in demo.outcome.reports}
    # The copied workbook is nobody's until a person has asked.
    nobodys = by_student.get("", demo.outcome.reports[0])
    rows = []
    for student, story in demo.students.items():
        report = by_student.get(student, nobodys)
        told = words.say(TOLD[story])
        rows.append((student, told, _score(report, words), _flags(report, words)))
    heads = (message("student"), message("what was scripted"), message("points"), message("flags"))
    lines = [table_text([words.say(head) for head in heads], rows, right={2}), ""]
    for item in demo.marking.items if demo.marking is not None else ():
        said = message(
            "The instructor marked {item} of {student} from its rubric.",
            item=item.mark.quantity,
            student=item.mark.student,
        )
        lines += [words.say(said), ""]
    for said, place in (
        (message("Course with its key and register"), demo.course),
        (message("Assignments, a folder per student"), demo.assignments),
        (message("Workbooks that were handed in"), demo.submissions),
        (message("Student reports"), demo.graded / "reports"),
        (message("Cohort summary"), demo.graded / "cohort.pdf"),
        (message("Grades"), demo.graded / "grades.csv"),
    ):
        lines.append(f"{words.say(said)}: {place}")
    return "\n".join(lines)


def _score(report: "Report", words: Words) -> str:
    if not report.judged:
        return "—"
    counts = f"{words.number(report.earned, 4)} / {words.number(report.max_score, 4)}"
    if not report.is_cut:
        return counts
    before = message("before lateness: {points}", points=words.number(report.score, 4))
    return f"{counts} ({words.say(before)})"


def _flags(report: "Report", words: Words) -> str:
    return ", ".join(words.say(FLAGS[code]) for code in dict.fromkeys(f.code for f in report.flags))
