"""Personal links: made for the students of the register, opened, revoked."""

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path

from gripcourse.access.desk.links import Refused, SignedLink, link_text, read_link, refusal_of
from gripcourse.errors import Problem, UsageError
from gripcourse.exports.csv_text import table_text, text_cell
from gripcourse.gradebook.joined import family
from gripcourse.issuing.withdrawal import persons_of
from gripcourse.machine.files import write_bytes
from gripcourse.text.words import message
from gripcourse.usecases.serving.desk import DeskBooks
from gripcourse.variants.model import Issued


@dataclass(frozen=True, slots=True)
class PersonalLink:
    """A student's link: its address, and until when it opens anything."""

    issued: Issued
    address: str
    expires: datetime


def make_links(
    context: DeskBooks, address: str, days: int, now: datetime
) -> tuple[PersonalLink, ...]:
    """Make a link for everybody in the course; older ones stay good until they end.

    Args:
        context: of the course.
        address: of the server; empty for the course's own.
        days: that the links are good for.
        now: with its zone.

    Raises:
        UsageError: there is no address.
    """
    base = address_of(context.address, address)
    expires = (now + timedelta(days=days)).replace(microsecond=0)
    return tuple(
        PersonalLink(issued, f"{base}/s/{token_of(context, student, expires)}/", expires)
        for student, issued in context.register().items()
        if not issued.left
    )


def address_of(declared: str, address: str = "") -> str:
    """Return where the server is found, as somebody says or the course declares.

    Args:
        declared: address that the course declares; empty for none.
        address: as somebody says; empty for nobody.

    Raises:
        UsageError: neither says it.
    """
    base = (address or declared).rstrip("/")
    if not base:
        what = message("Nobody knows at which address the server is found.")
        remedy = message("Name it, or write `address` into the course.")
        raise UsageError([Problem("", "", what, remedy, parameter="address")])
    return base


def refuse_no_address(declared: str) -> None:
    """Refuse to print personal links on sheets of a course that does not say where its server is.

    Args:
        declared: address that the course declares; empty for none.

    Raises:
        UsageError: there is none.
    """
    if not declared:
        what = message("Nobody knows at which address the server is found.")
        remedy = message("Write `address` into variants/course.toml.")
        raise UsageError([Problem("", "", what, remedy, parameter="link_days")])


def token_of(context: DeskBooks, student: str, expires: datetime) -> str:
    """Make the part of an address by which a student is known."""
    link = SignedLink(student, expires, context.desk.revoked(student))
    return link_text(link, context.key, context.course_id)


def write_links(links: Iterable[PersonalLink], path: Path) -> None:
    """Write links as a table for a mail merge; only its owner may read it.

    Raises:
        OSError: the file cannot be written.
    """
    rows = (
        (
            *map(text_cell, (one.issued.student.id, one.issued.student.name)),
            *map(text_cell, (one.issued.student.group, one.issued.student.email)),
            one.address,
            one.expires.isoformat(),
        )
        for one in links
    )
    header = ("student", "name", "group", "email", "link", "expires")
    write_bytes(path, table_text(header, rows).encode("utf-8-sig"), private=True)


def revoke_links(context: DeskBooks, student: str, by: str, now: datetime) -> None:
    """Let no link that a student has open anything any more, under whatever id it was made.

    Raises:
        UsageError: the register has no such student.
    """
    joins = context.joins()
    person = persons_of(joins).get(student, student)
    if person not in context.register():
        what = message("The register has no student '{student}'.", student=student)
        remedy = message("Name a student by the id of the roster.")
        raise UsageError([Problem("", "", what, remedy, parameter="revoke")])
    for id_ in sorted(family({person}, joins)):
        context.desk.revoke(id_, by, now)


def open_link(context: DeskBooks, token: str, now: datetime) -> Issued | Refused:
    """Return whose link this is, with what was issued; or why it opens nothing."""
    link = read_link(token, context.key, context.course_id)
    revoked = 0 if link is None else context.desk.revoked(link.student)
    refused = refusal_of(link, revoked, now)
    if refused is not None or link is None:
        return refused or Refused.FORGED
    return context.find(link.student) or Refused.FORGED


def signed_for(context: DeskBooks, token: str) -> Issued | None:
    """Return for whom a link was signed, whether or not it opens anything any more.

    None for a link without our signature: whoever wrote it is told nothing of anybody.
    """
    link = read_link(token, context.key, context.course_id)
    return None if link is None else context.find(link.student)
