"""What was issued to a whole term, lying on a shelf: grading looks at one student after the other.

Held of an entry are the student's id and where it lies, some 150 bytes. What many entries have in
common, as options and the names of given numbers, is held once and lies on no shelf.
"""

from array import array
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, islice
from typing import Any, Final, Generic, TypeAlias, TypeVar

from gripcourse.issuing.register import is_unchanged, refuse_changed
from gripcourse.issuing.withdrawal import (
    Join,
    Withdrawal,
    as_of_person,
    joined_to,
    joins_of,
    why_left,
    with_joined,
)
from gripcourse.machine.shelf import Shelved
from gripcourse.variants.given_numbers import GivenNumbers, SharedNames
from gripcourse.variants.model import Issued, Student, Variant

_Value = TypeVar("_Value")
_Place = TypeVar("_Place")
_Record: TypeAlias = tuple[tuple[Any, ...], tuple[int, ...]]

_PORTION: Final = 500  # names that are loaded at once


@dataclass(frozen=True, slots=True)
class ShelvedRegister:
    """All that was issued in one course, each entry loaded anew whenever somebody asks for it.

    Attributes:
        course_id: id of the course, part of every signature.
        last: by student id, the version that counts, in the order of the first issue.
        earlier: by student id, the versions before that, oldest first; without students who have
            none.
        joined: by id that was joined with another's, the id of the student.
        joins: the same with their moments, in the order in which they were joined.
        former: by student id, how the person was written before.
    """

    course_id: str
    last: Mapping[str, Issued]
    earlier: Mapping[str, tuple[Issued, ...]]
    joined: Mapping[str, str] = field(default_factory=dict)
    joins: tuple[Join, ...] = ()
    former: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


def shelved(
    entries: Iterable[Issued],
    course_id: str,
    keys: Sequence[bytes],
    place: str,
    withdrawals: Sequence[Withdrawal] = (),
) -> ShelvedRegister:
    """Put entries on a shelf as they come, and see that nobody has changed any.

    Args:
        entries: all versions of all students, in the order in which they were issued.
        course_id: of the course.
        keys: of the signatures.
        place: where the register is, for a person.
        withdrawals: of the course, oldest first.

    Raises:
        RegisterError: naming every student whose numbers are not those that were issued.
    """
    joined, left = joined_to(withdrawals), why_left(withdrawals)
    numbers: dict[str, int] = {}
    before: dict[str, list[int]] = {}
    replaced = array("q")
    changed: set[int] = set()

    def looked_at() -> Iterator[Issued]:
        for number, entry in enumerate(entries):
            if not is_unchanged(entry, course_id, keys):
                changed.add(number)
            student = entry.student.id
            if student in numbers:
                before.setdefault(student, []).append(numbers[student])
                replaced.append(numbers[student])
            numbers[student] = number
            yield replace(entry, left=left.get(student, "")) if student in left else entry

    rows = _on_shelf(looked_at())
    wrong = [one for one in chain(numbers.values(), replaced) if one in changed]
    refuse_changed([rows.entry(one) for one in wrong], len(rows.ids), place)
    oldest_first = {
        student: sorted((*mine, numbers[student]), key=lambda one: rows.entry(one).version)
        for student, mine in before.items()
    }
    of_others: dict[str, list[int]] = {}
    for student, person in joined.items():
        mine = oldest_first.pop(student, [numbers[student]])
        of_others.setdefault(person, []).extend(mine)
        rows.persons.update(dict.fromkeys(mine, numbers[person]))
        rows.others.setdefault(numbers[person], []).append(numbers[student])
    for student in joined:
        del numbers[student]
    earlier = {
        student: (
            *sorted(of_others.get(student, ()), key=lambda one: rows.entry(one).version),
            *oldest_first.get(student, ())[:-1],
        )
        for student in (*of_others, *(one for one in oldest_first if one not in of_others))
    }
    last = _LastVersions(numbers, rows.entry)
    loading = _Loading(earlier, rows.entries)
    return ShelvedRegister(course_id, last, loading, joined, joins_of(withdrawals))


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class _Loading(Mapping[str, _Value], Generic[_Value, _Place]):
    """A mapping that knows where its values lie.

    Attributes:
        places: of the values.
        load: returns the value of a place.
    """

    places: Mapping[str, _Place]
    load: Callable[[_Place], _Value]

    def __getitem__(self, name: str) -> _Value:
        return self.load(self.places[name])

    def __contains__(self, name: object) -> bool:
        return name in self.places

    def __iter__(self) -> Iterator[str]:
        return iter(self.places)

    def __len__(self) -> int:
        return len(self.places)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Mapping) or len(self) != len(other):
            return False
        return all(name in other and other[name] == value for name, value in self.items())

    __hash__ = None  # type: ignore[assignment] # as any mapping

    def __repr__(self) -> str:
        return f"<what was issued to {len(self)} students>"


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class _LastVersions(_Loading[Issued, int]):
    """The versions that count.

    Attributes:
        called: ids and names in portions, once anybody asked for them: of who is looked for by name
            every file of a batch may ask for all.
    """

    called: list[Sequence[tuple[tuple[str, str], ...]]] = field(default_factory=list)

    def names(self) -> Iterator[tuple[str, str]]:
        """Yield the id and the name of each student."""
        if not self.called:
            pairs = ((student, issued.student.name) for student, issued in self.items())
            self.called.append(Shelved(iter(lambda: tuple(islice(pairs, _PORTION)), ())))
        return chain.from_iterable(self.called[0])


@dataclass(frozen=True, slots=True)
class _NumberedEntries:
    """Entries by their numbers.

    Attributes:
        ids: of the students.
        records: of each entry what nobody else has, and the numbers of what is in common.
        common: texts and days; see `_Common`.
        options: what variants choose.
        names: of given numbers, with their places.
        persons: of entries that were issued under an id that was joined with a student's, the last
            entry of that student.
        others: the other way round, the last one under each such id.
    """

    ids: Sequence[str]
    records: Sequence[_Record]
    common: Sequence[Any]
    options: Sequence[Mapping[str, str]]
    names: Sequence[Mapping[str, int]]
    persons: dict[int, int] = field(default_factory=dict)
    others: dict[int, list[int]] = field(default_factory=dict)

    def entry(self, number: int) -> Issued:
        """Load an entry."""
        found = self._issued(number)
        if number in self.others:
            return with_joined(found, map(self._issued, self.others[number]))
        if number not in self.persons:
            return found
        return as_of_person(found, self._issued(self.persons[number]).student)

    def _issued(self, number: int) -> Issued:
        own, in_common = self.records[number]
        name, email, fixed, variant, given, signature, version, why, issued_by, left = own
        options, names, *places = in_common
        group, language, scheme, issued_on, deadline, declarations = map(
            self.common.__getitem__, places
        )
        numbers = GivenNumbers.of(self.names[names], given)
        return Issued(
            Student(self.ids[number], name, group, email, language, fixed),
            Variant(variant, scheme, self.options[options], numbers),
            issued_on,
            deadline,
            signature,
            version,
            why,
            issued_by,
            declarations,
            left=left,
        )

    def entries(self, numbers: Iterable[int]) -> tuple[Issued, ...]:
        """Load several entries."""
        return tuple(map(self.entry, numbers))


class _Common(Generic[_Value]):
    """Values that many entries have in common, each held once and known by its number."""

    __slots__ = ("numbers", "values")

    def __init__(self) -> None:
        self.values: list[_Value] = []
        self.numbers: dict[Hashable, int] = {}

    def number(self, value: _Value, key: Hashable) -> int:
        """Return the number of a value; `key` is that of all values that are the same."""
        found = self.numbers.setdefault(key, len(self.values))
        if found == len(self.values):
            self.values.append(value)
        return found


def _on_shelf(entries: Iterable[Issued]) -> _NumberedEntries:
    """Put entries on a shelf, each as it comes."""
    ids: list[str] = []
    common, options = _Common[Any](), _Common[Mapping[str, str]]()
    names, shared = _Common[Mapping[str, int]](), SharedNames()

    def record(entry: Issued) -> _Record:
        student, variant, given = entry.student, entry.variant, entry.variant.given
        ids.append(student.id)
        numbers = given if isinstance(given, GivenNumbers) else shared.numbers(given.items())
        texts_and_days = (
            *(student.group, student.language, variant.scheme),
            *(entry.issued_on, entry.deadline, entry.declarations),
        )
        own = (
            *(student.name, student.email, student.variant, variant.id, numbers.packed()),
            *(entry.signature, entry.version, entry.why, entry.issued_by, entry.left),
        )
        in_common = (
            options.number(variant.options, tuple(variant.options.items())),
            names.number(numbers.places, tuple(numbers.places)),
            *(common.number(one, one) for one in texts_and_days),
        )
        return own, in_common

    records: Shelved[_Record] = Shelved(map(record, entries))
    return _NumberedEntries(ids, records, common.values, options.values, names.values)
