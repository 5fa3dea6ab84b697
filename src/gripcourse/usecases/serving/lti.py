"""Learning platforms: declared, and their people told to be students of the roster."""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from enum import StrEnum
from pathlib import Path
from typing import Final

from gripcourse.access.lti.launch import Launch, Person
from gripcourse.access.lti.model import Bond, PlatformPlace, Stranger, UserKey
from gripcourse.access.lti.platforms import Platform, add_platform, load_platforms
from gripcourse.access.lti.store import LtiStore
from gripcourse.access.lti.tool_key import make_tool_key, tool_key_path
from gripcourse.access.lti.user_rule import UserRule
from gripcourse.errors import Problem, UsageError
from gripcourse.text.words import Message, message
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.variants.model import Issued


class NotTold(StrEnum):
    """Why a platform's user is nobody of the roster."""

    UNKNOWN = "unknown"  # no rule finds a student
    AMBIGUOUS = "ambiguous"  # rules find several
    TAKEN = "taken"  # another user of the platform is that student


_WHY: Final[Mapping[str, Message]] = {
    NotTold.UNKNOWN: message("nobody on the list"),
    NotTold.AMBIGUOUS: message("several on the list"),
    NotTold.TAKEN: message("somebody else is that student"),
}
_OTHER: Final = message("cannot be told")


@dataclass(frozen=True, slots=True)
class Registered:
    """A platform was declared: in which file, and where our key is."""

    declared: Path
    key: Path


def register_platform(root: Path, platform: Platform) -> Registered:
    """Declare a platform; the first one makes our key.

    Raises:
        UsageError: there is one of that name.
        CourseError: it cannot be used as it is written.
        OSError: nothing can be written.
    """
    declared = add_platform(root, platform)
    key = tool_key_path(root)
    return Registered(declared, key if key.is_file() else make_tool_key(root))


def store_of(context: DeskContext) -> LtiStore:
    """Return what a course keeps of platforms."""
    return LtiStore(context.desk.engine, context.course.id)


def user_key(platform: Platform, user: str) -> UserKey:
    """Return the key of a platform's person."""
    return UserKey(platform.issuer, platform.client_id, user)


def why_not_told(stranger: Stranger) -> Message:
    """Say in a few words why somebody of a platform waits; what a newer program kept, too."""
    return _WHY.get(stranger.reason, _OTHER)


def student_of(context: DeskContext, launch: Launch, now: datetime) -> Issued | NotTold:
    """Tell which student opened the assignment; who cannot be told is kept for the instructor.

    Who was told once stays that student, whatever the platform says of him later; and a student is
    one user of a platform, so nobody becomes another by an address of his choice.
    """
    store, register = store_of(context), context.register()
    key, bonds = user_key(launch.platform, launch.person.user), store.bonds()
    bond = bonds.get(key)
    found = bond.student if bond is not None else _found(register, launch)
    if isinstance(found, NotTold):
        return _not_told(store, key, launch.person, found, now)
    issued = context.find(found)
    if issued is None:
        return _not_told(store, key, launch.person, NotTold.UNKNOWN, now)
    found = issued.student.id
    if bond is None:
        made = Bond(key.issuer, key.client, key.user, found, "rule", now)
        is_taken = store.bind(made) is not None
    else:
        is_taken = any(_holds(one, key, found) for one in bonds.values())
    if is_taken:
        return _not_told(store, key, launch.person, NotTold.TAKEN, now)
    return issued


def note_place(context: DeskContext, launch: Launch, now: datetime) -> None:
    """Keep where in the platform the assignment stands: grades go there."""
    services = launch.services
    place = PlatformPlace(
        launch.platform.issuer,
        launch.platform.client_id,
        launch.context,
        launch.link,
        services.line_item,
        services.line_items,
        services.members,
        now,
    )
    store_of(context).note_place(place)


def bind(
    context: DeskContext, platform: Platform, user: str, student: str, by: str, now: datetime
) -> None:
    """Say that a platform's user is a student; or nobody, where the student is empty.

    Raises:
        UsageError: the register has no such student, or another user is that student.
    """
    store, key = store_of(context), user_key(platform, user)
    if student and student not in context.register():
        what = message("The register has no student '{student}'.", student=student)
        remedy = message("Name a student by the id of the roster.")
        raise UsageError([Problem("", "", what, remedy, parameter="student")])
    other = store.bind(Bond(key.issuer, key.client, user, student, by, now))
    if other is not None:
        what = message("The platform's user {user} is this student.", user=other.user)
        remedy = message("Let that one be nobody first.")
        raise UsageError([Problem("", "", what, remedy, parameter="student")])


def chosen_platform(root: Path, name: str) -> Platform:
    """Return a platform by its name; the only one where none is named.

    Raises:
        UsageError: there is none of that name, or several and none is named.
        CourseError: the file cannot be used.
    """
    platforms = load_platforms(root)
    if name in platforms:
        return platforms[name]
    if not name and len(platforms) == 1:
        return next(iter(platforms.values()))
    what = message("No platform is declared.")
    remedy = message("Declare one first.")
    if platforms:
        what = message("There is no platform '{name}'.", name=name)
        remedy = message("Name one of: {all}.", all=", ".join(platforms))
    if platforms and not name:
        what = message("Several platforms are declared.")
    raise UsageError([Problem("", "", what, remedy, parameter="platform")])


def platform_names(root: Path) -> Mapping[tuple[str, str], str]:
    """Return what platforms are called, by issuer and by what they call us.

    Raises:
        CourseError: the file cannot be used.
    """
    return {(one.issuer, one.client_id): name for name, one in load_platforms(root).items()}


def _found(register: Mapping[str, Issued], launch: Launch) -> str | NotTold:
    told = [
        {id_ for id_, one in register.items() if _fits(rule, one, launch.person)}
        for rule in launch.platform.known_by
    ]
    everybody = set().union(*told)
    if not everybody:
        return NotTold.UNKNOWN
    return NotTold.AMBIGUOUS if len(everybody) > 1 else everybody.pop()


def _fits(rule: UserRule, issued: Issued, person: Person) -> bool:
    if rule is UserRule.SOURCEDID:
        return person.sourcedid != "" and person.sourcedid == issued.student.id
    email = _mailbox(person.email)
    return email != "" and email == _mailbox(issued.student.email)


def _mailbox(email: str) -> str:
    """Return an address of mail as it is compared: of ASCII letters the size means nothing.

    Other letters are not folded: the sign of kelvin would be a k, and whoever gets an address with
    that sign would be the student whose address has the letter.
    """
    return "".join(one.lower() if one.isascii() else one for one in email.strip())


def _holds(bond: Bond, key: UserKey, student: str) -> bool:
    """Tell whether another user of the same platform is that student."""
    same = (bond.issuer, bond.client) == (key.issuer, key.client)
    return same and bond.user != key.user and bond.student == student


def _not_told(
    store: LtiStore, key: UserKey, person: Person, why: NotTold, now: datetime
) -> NotTold:
    who = (person.name, person.email, person.sourcedid)
    store.add_stranger(Stranger(key.issuer, key.client, key.user, why, *who, now))
    return why
