"""People found by their names and addresses: who looks through all for each takes an hour."""

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.text.spelling import as_seen
from gripcourse.variants.model import Student


@dataclass(frozen=True, slots=True)
class KnownPeople:
    """People of a list or of the register.

    Attributes:
        ids: of all who have one.
        by_name: in their order, by names as they are seen.
        by_address: likewise those who have a mail address.
    """

    ids: frozenset[str]
    by_name: Mapping[str, Sequence[Student]]
    by_address: Mapping[str, Sequence[Student]]

    @classmethod
    def of(cls, people: Iterable[Student]) -> "KnownPeople":
        """Look everybody up once."""
        ids: set[str] = set()
        by_name: dict[str, list[Student]] = defaultdict(list)
        by_address: dict[str, list[Student]] = defaultdict(list)
        for one in people:
            ids.add(one.id)
            by_name[as_seen(one.name)].append(one)
            if one.email:
                by_address[as_seen(one.email)].append(one)
        return cls(frozenset(ids - {""}), dict(by_name), dict(by_address))

    def namesakes(self, student: Student) -> Sequence[Student]:
        """Return those whose names look the same."""
        return self.by_name.get(as_seen(student.name), ())

    def with_address_of(self, student: Student) -> Sequence[Student]:
        """Return those who have somebody's mail address; nobody where there is none."""
        return self.by_address.get(as_seen(student.email), ()) if student.email else ()

    def namesakes_or_with_address_of(self, student: Student) -> Sequence[Student]:
        """Return both, each of them once."""
        both = (*self.namesakes(student), *self.with_address_of(student))
        return tuple({id(one): one for one in both}.values())
