"""What a batch is graded with; who gives works to workers need not know how they are judged."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import PurePath
from typing import Final

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.grading.identify import HandedIn, identify, named_by_person
from gripcourse.grading.known_by import KnownBy
from gripcourse.grading.made_for import is_of_other_declarations
from gripcourse.grading.path_pattern import PathPattern
from gripcourse.issuing.withdrawal import Join
from gripcourse.policy.model import Policy
from gripcourse.submission.model import Identity
from gripcourse.variants.model import Issued

_WORD: Final = re.compile(r"[^\W_]+")


@dataclass(frozen=True, slots=True, eq=False)
class GradingContext:
    """What grading needs: the course, its policy and the register by student.

    Two desks are never the same one, so that what was made for one can be remembered by it.

    Attributes:
        course, policy: what is graded by.
        register: entries by student id, of each student the last version.
        whose: by file, the id of the student who handed it in, where a person says so; it may have
            been joined with another's.
        office: the command that starts LibreOffice, for files that need it; None for none.
        recalculate: whether it computes all formulas once more, to be compared with what is stored.
        pattern: how paths say whose a file is; None where only platforms' own ways count.
        earlier: what students were issued before that, by student id, oldest first.
        either_version: whether works are judged by every version and the best one counts; None
            where nobody says so now.
        either_for: digests of the files for which this was said before.
        declared: by fingerprint, the declarations that versions corrected since were issued with.
        joined: by id that was joined with another's, the id of the student; what was issued under
            it is among the student's earlier versions.
        joins: the same with their moments, in the order in which they were joined.
        former: by student id, how the register wrote the person before.
        answered: by file and by the digest of what it held when it was graded before, the id under
            which that is kept: who was asked need not answer again.
        said: the same of what a person said it is, which goes before the name of a file.
    """

    course: Course
    policy: Policy
    register: Mapping[str, Issued]
    whose: Mapping[str, str] = field(default_factory=dict)
    office: str | None = None
    recalculate: bool = False
    pattern: PathPattern | None = None
    earlier: Mapping[str, tuple[Issued, ...]] = field(default_factory=dict)
    either_version: bool | None = None
    either_for: frozenset[str] = frozenset()
    declared: Mapping[str, Course] = field(default_factory=dict)
    joined: Mapping[str, str] = field(default_factory=dict)
    joins: tuple[Join, ...] = ()
    former: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    answered: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    said: Mapping[str, Mapping[str, str]] = field(default_factory=dict)


def handed_in_by(
    file: str, identity: Identity | None, context: GradingContext, digest: str = ""
) -> HandedIn:
    """Tell whose a file is: a person's word first, then `identify`, then a person's earlier word.

    Args:
        file: path of the file.
        identity: what the workbook says; None where it could not be read.
        context: the course, its register, and what persons say.
        digest: of the bytes; empty where nobody could read them.
    """
    known, earlier = context.register, context.earlier
    pattern, joined, former = context.pattern, context.joined, context.former
    named = context.whose.get(file)
    if named is not None:
        return named_by_person(joined.get(named, named), identity, known, earlier, named)
    found = identify(file, identity, known, pattern, earlier, joined, former=former)
    by_name = found.known_by is KnownBy.FILE_NAME
    for before, counts in ((context.said, by_name), (context.answered, False)):
        id_ = before.get(file, {}).get(digest, "") if digest else ""
        student = joined.get(id_, id_)
        if (found.issued is None or counts) and student in known:
            return named_by_person(student, identity, known, earlier, id_)
    return found


def declarations_of(issued: Issued, context: GradingContext) -> str:
    """Return the fingerprint of the declarations that a version is judged by; empty for today's.

    A version that another one by other declarations replaced is judged by its own, where they were
    kept; everything else by today's.
    """
    last = context.register.get(issued.student.id, issued)
    own = issued.declarations if is_of_other_declarations(issued, last) else ""
    return own if own in context.declared else ""


def likely_composition(file: str, context: GradingContext) -> Composition | None:
    """Guess which composition a file is about, by its path alone; None where nothing tells.

    Whoever judges works of one composition makes its wrong methods once. Nothing else follows from
    a guess: whose a file is says `handed_in_by`.
    """
    path = PurePath(file)
    words = (path.stem, path.parent.name, *_WORD.findall(path.stem), *_WORD.findall(file))
    likely = (context.whose.get(file), *words)
    known = (context.joined.get(one, one) for one in likely if one)
    student = next((one for one in known if one in context.register), None)
    return None if student is None else context.register[student].variant.composition
