"""Which row of a platform's table is whose.

Platforms number people by themselves, and names are not unique: a row is a student's where the
platform's own number in the path of the work says so, else the id or the address, else a name that
occurs only once in the table and in the register: the whole name, or all but the patronymic. Where
two of these disagree, nobody's grade is written. A number counts with the name beside it: a team's
folder bears the number of the team, which may be that of a stranger among the people.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.exports.platforms.names import Names, names_by_words
from gripcourse.exports.platforms.works import GradedWork, PlatformRow
from gripcourse.grading.platforms import PlatformPart, words_of
from gripcourse.text.shown import first_of
from gripcourse.text.words import Message, message

_NO_OTHERS: Final[Mapping[str, str]] = MappingProxyType({})
_SHOWN: Final = 5  # namesakes, or rows


@dataclass(frozen=True, slots=True)
class Matching:
    """Which row is whose.

    Attributes:
        works: by the line of the row.
        notes: works that have no row, each with the reason.
    """

    works: Mapping[int, GradedWork]
    notes: tuple[Message, ...]


def match(
    works: Sequence[GradedWork],
    rows: Sequence[PlatformRow],
    file: str,
    people: Mapping[str, str] = _NO_OTHERS,
) -> Matching:
    """Tell which row is whose; see the module.

    Args:
        works: that count.
        rows: of the table.
        file: the table, for what is said of it.
        people: the name of everybody in the register, by id: who handed in nothing has a row, too.

    Raises:
        UsageError: two rows are of one person, or two works belong to one row.
    """
    problems = list(_doubled(rows, file))
    table = _Table.of(works, rows, people)
    found: dict[int, list[GradedWork]] = {}
    notes, by_part = [], list[tuple[PlatformRow, GradedWork]]()
    for work in works:
        surest = [table.by_number(work), table.by_key(work)]
        lines = {row.line for group in surest for row in group}
        if len(lines) == 1:
            found.setdefault(lines.pop(), []).append(work)
        elif surest[0] and surest[1]:
            notes.append(_disputed(work, lines))
        elif lines:
            problems.append(_two_rows(file, work, lines))
        elif isinstance(by_name := table.by_name(work), Message):
            notes.append(by_name)
        else:
            found.setdefault(by_name.line, []).append(work)
            if table.names.same(work.report.name) != [by_name.line]:
                by_part.append((by_name, work))
    problems += [_two_works(file, line, of) for line, of in found.items() if len(of) > 1]
    if problems:
        raise UsageError(problems)
    if by_part:
        notes.append(_by_a_part(by_part))
    matched = {line: one for line, (one,) in found.items()}
    return Matching(matched, (*notes, *_of_other_names(matched, table)))


@dataclass(frozen=True, slots=True)
class _Table:
    """The rows of a table, ready to be found.

    Attributes:
        lines: the rows by their line.
        numbers: by the platform's own number.
        keys: by each id and address.
        names: of the rows, by their line.
        people: the names of everybody, by id.
    """

    lines: Mapping[int, PlatformRow]
    numbers: Mapping[str, Sequence[PlatformRow]]
    keys: Mapping[str, Sequence[PlatformRow]]
    names: Names[int]
    people: Names[str]

    @classmethod
    def of(
        cls, works: Iterable[GradedWork], rows: Sequence[PlatformRow], people: Mapping[str, str]
    ) -> "_Table":
        """Make rows ready to be found; the works tell the names of who handed in."""
        numbers = defaultdict[str, list[PlatformRow]](list)
        keys = defaultdict[str, list[PlatformRow]](list)
        for row in rows:
            numbers[row.number].append(row)
            for key in row.keys:
                keys[_key(key)].append(row)
        handed_in = {one.report.student: one.report.name for one in works}
        return cls(
            {row.line: row for row in rows},
            numbers,
            keys,
            names_by_words({row.line: row.name for row in rows}),
            names_by_words({**people, **handed_in}),
        )

    def by_number(self, work: GradedWork) -> list[PlatformRow]:
        """Return the rows with the number in the path of a work."""
        part = work.part
        if part is None or not part.identifier:
            return []
        found = self.numbers.get(part.identifier, ())
        return [row for row in found if _is_of_person(part, work, row)]

    def by_key(self, work: GradedWork) -> list[PlatformRow]:
        """Return the rows with the id or the address of whose work it is."""
        own = {work.report.student, work.email} - {""}
        # Who has two accounts there, too, gets the grade by the one whose id is kept.
        return self._with_any(own) or self._with_any(work.other_keys)

    def _with_any(self, keys: Iterable[str]) -> list[PlatformRow]:
        return [row for key in keys for row in self.keys.get(_key(key), ())]

    def by_name(self, work: GradedWork) -> PlatformRow | Message:
        """Return the only row that a name can be that of, or say why there is none."""
        name, own = work.report.name, {work.report.student, *work.other_keys}
        whole = self.names.same(name)
        lines = whole or self.names.fitting(name)
        if not lines:
            return _absent(work)
        if len(lines) > 1:
            return _several_rows(work, lines)
        row = self.lines[lines[0]]
        fitting = self.people.same(name) if whole else self.people.fitting(row.name)
        others = [one for one in fitting if one not in own]
        return _of_others(work, row, others) if others else row


def is_of_team(work: GradedWork, row: PlatformRow) -> bool:
    """Tell whether a work lay where its platform puts the works of a team.

    Args:
        work: of a student.
        row: of the same student.
    """
    part = work.part
    return part is not None and not part.joined and not _is_of_person(part, work, row)


def _is_of_person(part: PlatformPart, work: GradedWork, row: PlatformRow) -> bool:
    return part.stands_for(row.name, work.report.name)


def _shares_a_word(name: str, other: str) -> bool:
    return not set(words_of(name)).isdisjoint(words_of(other))


def _key(text: str) -> str:
    return text.strip().casefold()


def _doubled(rows: Iterable[PlatformRow], file: str) -> Iterator[Problem]:
    lines: dict[str, int] = {}
    for row in rows:
        if row.number and (first := lines.setdefault(row.number, row.line)) != row.line:
            what = message(
                "Rows {first} and {second} have the same number {number}.",
                first=first,
                second=row.line,
                number=row.number,
            )
            yield Problem(file, "", what, _again())


def _two_rows(file: str, work: GradedWork, lines: Iterable[int]) -> Problem:
    what = message(
        "Rows {lines} are all of {student}.",
        lines=", ".join(map(str, sorted(lines))),
        student=work.said,
    )
    return Problem(file, "", what, _again())


def _two_works(file: str, line: int, works: Iterable[GradedWork]) -> Problem:
    what = message(
        "The works of {students} belong to the same row {line}.",
        students=", ".join(one.said for one in works),
        line=line,
    )
    remedy = message("Correct the ids and addresses of the roster, or fill in this row by hand.")
    return Problem(file, "", what, remedy)


def _again() -> Message:
    return message("Export the table from the platform again and leave its rows as they are.")


def _disputed(work: GradedWork, lines: Iterable[int]) -> Message:
    return message(
        "The work of {student} was handed in under another account: rows {lines}. No grade is"
        " written.",
        student=work.said,
        lines=", ".join(map(str, sorted(lines))),
    )


def _absent(work: GradedWork) -> Message:
    return message("{student} is not in the platform's table.", student=work.said)


def _several_rows(work: GradedWork, lines: Iterable[int]) -> Message:
    return message(
        "Rows {lines} have the name of {student}, and nothing else tells whose they are, so no"
        " grade is written. Write the platform's address into the roster, or fill it in by hand.",
        student=work.said,
        lines=first_of([str(one) for one in sorted(lines)], _SHOWN),
    )


def _of_others(work: GradedWork, row: PlatformRow, others: Sequence[str]) -> Message:
    return message(
        "Row {line}, {name}, may be that of {student} or of {others}, so no grade is written. Write"
        " the platform's address into the roster, or fill it in by hand.",
        student=work.said,
        line=row.line,
        name=row.name,
        others=first_of(sorted(others), _SHOWN),
    )


def _by_a_part(rows: Sequence[tuple[PlatformRow, GradedWork]]) -> Message:
    return message(
        "A part of the name alone tells whose {count} rows are, look at them: {rows}.",
        count=len(rows),
        rows=first_of([f"{row.line} {row.name} = {work.said}" for row, work in rows], _SHOWN),
    )


def _of_other_names(works: Mapping[int, GradedWork], table: _Table) -> Iterator[Message]:
    """Name the rows that the number alone tells and that have no word of the student's name."""
    rows = [
        (row, work)
        for line, work in works.items()
        if (row := table.lines[line]).name
        and row not in table.by_key(work)
        and not _shares_a_word(row.name, work.report.name)
    ]
    if rows:
        yield message(
            "The number in the path alone tells whose these rows are ({count}), and they bear other"
            " names; look at them: {rows}.",
            count=len(rows),
            rows=first_of([f"{row.line} {row.name} = {work.said}" for row, work in rows], _SHOWN),
        )
