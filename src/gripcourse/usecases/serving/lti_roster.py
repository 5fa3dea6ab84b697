"""The roster as a platform knows it: a table that issuing takes."""

from collections.abc import Sequence
from pathlib import Path

from gripcourse.access.lti.given_access import Access, open_access
from gripcourse.access.lti.launch import MEMBERS_SCOPE, Person
from gripcourse.access.lti.services import students_of
from gripcourse.errors import Problem, UsageError
from gripcourse.exports.csv_text import table_text, text_cell
from gripcourse.machine.files import write_bytes
from gripcourse.text.shown import one_line
from gripcourse.text.words import message
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.lti import store_of


def fetch_roster(context: DeskContext, access: Access) -> tuple[Person, ...]:
    """Return the students of the platform's courses that are declared.

    Args:
        context: the course.
        access: to the platform; nothing is granted yet.

    Raises:
        UsageError: nobody has opened the assignment there yet, or members are not named.
        PlatformFailedError: the platform names nobody.
    """
    platform = access.platform
    ours = (platform.issuer, platform.client_id)
    addresses = {
        one.members: None
        for one in store_of(context).places()
        if (one.issuer, one.client) == ours and one.members and one.context in platform.contexts
    }
    if not addresses:
        what = message("No place in the platform is known that names its members.")
        remedy = message("Let members be named there, and open the assignment there once.")
        raise UsageError([Problem("", "", what, remedy)])
    open_access(access, [MEMBERS_SCOPE])
    found = {one.user: one for members in addresses for one in students_of(access, members)}
    return tuple(found.values())


def write_roster(people: Sequence[Person], path: Path) -> None:
    """Write a roster; who has no number of the office gets an id when it is read.

    Raises:
        OSError: the file cannot be written.
    """
    rows = [
        tuple(map(_cell, (one.sourcedid, one.name or one.email or one.user, one.email)))
        for one in people
    ]
    text = table_text(("student", "name", "email"), rows)
    write_bytes(path, text.encode("utf-8-sig"), private=True)


def _cell(text: str) -> str:
    return text_cell(one_line(text))
