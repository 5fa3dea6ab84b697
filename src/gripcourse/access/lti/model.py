"""What is kept of platforms: who is who, who is unknown, where grades go, which were sent."""

from dataclasses import dataclass
from datetime import datetime


@dataclass(frozen=True, slots=True)
class UserKey:
    """A person of a platform; ids of other platforms may be the same."""

    issuer: str
    client: str
    user: str


@dataclass(frozen=True, slots=True)
class Bond:
    """A platform's user is a student of the roster, from now on.

    Attributes:
        issuer, client, user: of the platform's person.
        student: id; empty where the user is nobody of the roster any more.
        by: a person, or the rule by which it was found.
        at: when.
    """

    issuer: str
    client: str
    user: str
    student: str
    by: str
    at: datetime

    @property
    def key(self) -> UserKey:
        """Whose bond it is."""
        return UserKey(self.issuer, self.client, self.user)


@dataclass(frozen=True, slots=True)
class Stranger:
    """Somebody came as a student by a platform and could not be told to be one of the roster.

    Attributes:
        issuer, client, user: of the platform's person.
        reason: `unknown`, `ambiguous` or `taken`.
        name, email, sourcedid: as the platform says; may be empty.
        at: when.
    """

    issuer: str
    client: str
    user: str
    reason: str
    name: str
    email: str
    sourcedid: str
    at: datetime

    @property
    def key(self) -> UserKey:
        """Who it is."""
        return UserKey(self.issuer, self.client, self.user)


@dataclass(frozen=True, slots=True)
class PlatformPlace:
    """Where the assignment stands in a platform's course, and what is offered there.

    Attributes:
        issuer, client: the platform.
        context, link: its course, and what was opened in it.
        line_item, line_items, members: addresses; empty for none.
        at: when it was said first.
    """

    issuer: str
    client: str
    context: str
    link: str
    line_item: str
    line_items: str
    members: str
    at: datetime


@dataclass(frozen=True, slots=True)
class SentScore:
    """A score that a platform took.

    Attributes:
        issuer, client, user: of the platform's person.
        student: id.
        line_item: address of the column.
        points, maximum, comment, final: what was sent.
        by: who did it.
        at: when.
    """

    issuer: str
    client: str
    user: str
    student: str
    line_item: str
    points: float
    maximum: float
    comment: str
    final: bool
    by: str
    at: datetime
