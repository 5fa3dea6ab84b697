"""What a kind of document is, and what a document of every kind can be filled with."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import date
from typing import TypeAlias

from gripcourse.course.model import Course
from gripcourse.documents.pdf import Document
from gripcourse.grading.model import Report
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Message, Words
from gripcourse.variants.model import Issued
from gripcourse.variants.space import Space


@dataclass(frozen=True, slots=True)
class SampleDocument:
    """What the documents of a worked example are made from.

    Attributes:
        course, policy: of the course that is tried.
        spaces: those of all schemes, to draw variants from; none for no certificate.
        plan: of the scheme of the worked example.
        issued: its numbers, as issued to a student.
        words: the language of the documents.
        day: that is printed.
        judged: a workbook with answers of every sort.
        refused: a file that is no workbook.
    """

    course: Course
    policy: Policy
    spaces: tuple[Space, ...]
    plan: Plan
    issued: Issued
    words: Words
    day: date
    judged: Report
    refused: Report


Maker: TypeAlias = Callable[[], Document]


@dataclass(frozen=True, slots=True)
class DocumentKind:
    """One kind of document.

    Attributes:
        id: unique; the names of its samples begin with it.
        title: for people.
        template: in the folder of the templates; that of the first page where it has several.
        styles: style sheets in their `style` folder, in order of precedence.
        printed: whether it is laid out here, with the fonts of this machine; else by a browser.
        samples: how its documents are made of a worked example, by name: one for each case in
            which the page looks different, none where the course has nothing to fill it with.
    """

    id: str
    title: Message
    template: str
    styles: tuple[str, ...]
    printed: bool
    samples: Callable[[SampleDocument], Mapping[str, Maker]]
