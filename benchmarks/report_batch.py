"""What reports of a class cost beside WeasyPrint alone, each made once, and what a worker holds.

`python benchmarks/report_batch.py [reports]`: every drawn variant of the course, answered in all
sorts of ways. A process each for WeasyPrint, for us with nothing shared between documents, and for
us, all forked from the same one; they take turns report by report, and each tells its processor's
time.
"""

import multiprocessing
import random
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from time import process_time
from typing import Final

import psutil
from weasyprint import CSS, HTML

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.documents.pdf import Document, pdf_from_html, render_html
from gripcourse.documents.report.student import STYLES, TEMPLATE, student_report, student_values
from gripcourse.documents.sharing import switch
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Report
from gripcourse.machine.process_wide import collect_rarely
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer, Identity, Reading, Submission
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.samples import DAY
from gripcourse.variants.model import Issued, Student, Variant
from gripcourse.variants.table import read_table

LANGUAGE: Final = "ru"
CAREFUL: Final = (1.0, 0.95, 0.9, 0.8, 0.6)  # shares of right answers, of students
PARTS: Final = ((0, 1), (1, 8), (8, 32), (32, 64))
WEASYPRINT: Final = "WeasyPrint with the same HTML"


@dataclass(frozen=True, slots=True)
class Work:
    """A judged work, and its report as HTML."""

    report: Report
    plan: Plan
    html: str


@dataclass(frozen=True, slots=True)
class Class:
    """All works of a class and what their reports are made with."""

    course: Course
    policy: Policy
    words: Words
    works: tuple[Work, ...]

    @property
    def templates(self) -> Path:
        """Return the folder of templates."""
        return self.course.root / "templates"


def main() -> None:
    """Print the time of each kind of process, as shares of WeasyPrint's, and its memory."""
    most = int(sys.argv[1]) if len(sys.argv) > 1 else PARTS[-1][1]
    taught = the_class(most)
    kinds = {
        WEASYPRINT: alone,
        "HTML laid out, nothing shared": nothing_shared,
        "HTML laid out": laid_out,
        "all in all": all_in_all,
    }
    context = multiprocessing.get_context("fork")
    pipes: dict[str, Connection] = {}
    for name, make in kinds.items():
        pipes[name], end = context.Pipe()
        context.Process(target=answer, args=(end, make, taught), daemon=True).start()
    rounds = [dict(each_in_turn(pipes, number)) for number in range(len(taught.works))]
    for first, last in PARTS:
        if first < len(rounds):
            print(f"reports {first + 1} to {min(last, len(rounds))}")
            tell(rounds[first:last])
    if len(rounds) > 1:
        print("all")
        tell(rounds)


def each_in_turn(
    pipes: Mapping[str, Connection], number: int
) -> Iterator[tuple[str, tuple[float, int]]]:
    """Let each process make one report."""
    for name, pipe in pipes.items():
        pipe.send(number)
        yield name, pipe.recv()


def tell(rounds: list[dict[str, tuple[float, int]]]) -> None:
    """Print the mean time of each kind, its share of WeasyPrint's, and the memory at the end."""
    means = {name: sum(one[name][0] for one in rounds) / len(rounds) for name in rounds[0]}
    for name, seconds in means.items():
        ratio, held = seconds / means[WEASYPRINT], rounds[-1][name][1]
        print(f"  {name:<32} {seconds * 1e3:5.0f} ms, ratio {ratio:.2f}, {held / 1e6:4.0f} MB")


def answer(pipe: Connection, make: Callable[[Class], Callable[[Work], bytes]], all_: Class) -> None:
    """Make the reports that are asked for by number; tell time and memory."""
    one, process = make(all_), psutil.Process()
    while True:
        work = all_.works[pipe.recv()]
        start = process_time()
        one(work)
        pipe.send((process_time() - start, process.memory_info().rss))


def alone(taught: Class) -> Callable[[Work], bytes]:
    """Lay out HTML as who uses WeasyPrint does, collecting garbage as Python does."""

    def made(work: Work) -> bytes:
        styles = [CSS(filename=taught.templates / "style" / name) for name in STYLES]
        html = HTML(string=work.html)
        return bytes(html.write_pdf(stylesheets=styles, pdf_variant="pdf/ua-1"))

    return made


def nothing_shared(taught: Class) -> Callable[[Work], bytes]:
    """Lay out HTML as we do with a WeasyPrint that we do not know."""
    switch.is_known = lambda: False  # type: ignore[assignment]
    return laid_out(taught)


def laid_out(taught: Class) -> Callable[[Work], bytes]:
    """Lay out HTML as a worker of a batch does."""
    collect_rarely()
    return lambda work: pdf_from_html(work.html, STYLES, taught.templates)


def all_in_all(taught: Class) -> Callable[[Work], bytes]:
    """Make a report from its values to its bytes."""
    collect_rarely()
    return lambda work: student_report(
        work.report, work.plan, taught.policy, taught.course, taught.words, DAY
    )


def the_class(most: int) -> Class:
    """Judge a work for each drawn variant, in an order in which schemes are mixed."""
    course = load_course(course_root())
    policy, words = load_policy(course), Words(LANGUAGE)
    drawn = list(read_table(course_root() / "variants" / "tables" / "main.csv", course))
    chance = random.Random(5)  # noqa: S311 (no secret)
    chance.shuffle(drawn)
    works = []
    for variant in drawn[:most]:
        plan = plan_of(course, variant.composition)
        report = judged(variant, plan, policy, chance)
        values = student_values(report, plan, policy, course, words) | {"graded_on": DAY}
        document = Document(TEMPLATE, STYLES, values)
        works.append(Work(report, plan, render_html(document, course.root / "templates", words)))
    return Class(course, policy, words, tuple(works))


def judged(variant: Variant, plan: Plan, policy: Policy, chance: random.Random) -> Report:
    """Judge answers that are right as often as their student is careful."""
    student = Student(f"s{variant.id}", f"Ада Лавлейс {variant.id}", "", "", LANGUAGE, "")
    issued = Issued(student, variant, DAY, DAY, "0" * 64)
    right, careful = solve_variant(plan, variant.given), chance.choice(CAREFUL)
    answers = {}
    for one in plan.answered:
        value, reading = float(f"{right[one.id]:.4g}"), Reading.READ
        if one.kind is not Kind.VERDICT and chance.random() > careful:
            value *= chance.uniform(0.3, 3.0)
            reading = chance.choice((Reading.READ, Reading.READ, Reading.BLANK))
        answers[one.id] = answer_of(one.id, value, reading)
    identity = Identity(student.id, variant.id, plan.scheme.id, plan.options, issued.signature)
    file = f"{student.id}.xlsx"
    submission = Submission(file, "", identity, "", variant.given, answers, ())
    return judge(submission, issued, plan, policy)


def answer_of(quantity: str, value: float, reading: Reading) -> Answer:
    """Return an answer as it is read from a workbook."""
    return Answer(
        quantity=quantity,
        reading=reading,
        value=value if reading is Reading.READ else None,
        typed=f"{value:.4g}" if reading is Reading.READ else "",
        cell="A1",
        half_unit=0.0,
        unit="",
        unit_fits=True,
        remarks=(),
    )


if __name__ == "__main__":
    main()
