"""The platforms that a course trusts: declared in a file of its private folder."""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from ipaddress import ip_address
from pathlib import Path
from typing import Final
from urllib.parse import urlsplit

from gripcourse.access.lti.user_rule import UserRule
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import CourseError, Problem, UsageError
from gripcourse.machine.files import make_private_folder, write_text
from gripcourse.text.words import Message, message


@dataclass(frozen=True, slots=True)
class Platform:
    """A learning platform as its administrator declared it.

    Attributes:
        name: what it is called here.
        issuer: what its tokens say of who made them.
        client_id: what it calls us.
        authorization_url, token_url, jwks_url: where it is asked.
        deployments: where on the platform we were put in.
        contexts: its courses whose people are let in; no other course's teacher is one here.
        known_by: rules by which a user is a student of the roster; all that tell must agree.
        frames: origins of its pages, which may show our notice within a frame.
        token_audience: to whom our requests for access are addressed.
    """

    name: str
    issuer: str
    client_id: str
    authorization_url: str
    token_url: str
    jwks_url: str
    deployments: tuple[str, ...]
    contexts: tuple[str, ...]
    known_by: tuple[UserRule, ...]
    frames: tuple[str, ...]
    token_audience: str


_KEYS: Final = (
    "issuer",
    "client_id",
    "authorization_url",
    "token_url",
    "jwks_url",
    "deployments",
    "contexts",
    "known_by",
    "frames",
    "token_audience",
)
_NAME: Final = re.compile(r"[a-z0-9_-]{1,40}")
_HEADING: Final = """\
# Learning platforms whose people are let in (LTI 1.3). Read anew whenever somebody comes.
# contexts: ids of the platform's courses that this course is taught in.
"""


def platforms_path(root: Path) -> Path:
    """Return the file that declares the platforms of a course."""
    return root / "private" / "lti.toml"


def load_platforms(root: Path) -> Mapping[str, Platform]:
    """Read the platforms of a course, by name; none where there is no such file.

    Raises:
        CourseError: with all problems of the file.
    """
    path = platforms_path(root)
    if not path.is_file():
        return {}
    problems: list[Problem] = []
    table = read_toml(path, root, problems)
    found: dict[str, Platform] = {}
    if table is not None:
        table.known_keys(["platform"])
        found = {name: _platform(name, one) for name, one in table.named_tables("platform").items()}
    if table is not None and not problems:
        _refuse_doubles(table, found)
    if problems:
        raise CourseError(problems)
    return found


def add_platform(root: Path, platform: Platform) -> Path:
    """Declare one more platform.

    Raises:
        UsageError: there is one of that name.
        CourseError: what was declared, or this, cannot be used; nothing was written.
        OSError: the file cannot be written.
    """
    path = platforms_path(root)
    if platform.name in load_platforms(root):
        what = message("There is a platform '{name}' already.", name=platform.name)
        remedy = message("Give it another name, or change what stands in the file.")
        raise UsageError([Problem(str(path), "", what, remedy, parameter="name")])
    before = path.read_text(encoding="utf-8") if path.is_file() else _HEADING
    lines = [f"{name} = {_toml(getattr(platform, name))}" for name in _KEYS]
    added = "\n".join([f"[platform.{platform.name}]", *lines])
    problems: list[Problem] = []
    values = {name: _plain(getattr(platform, name)) for name in _KEYS}
    _platform(platform.name, Table(values, "", platform.name, problems))
    if problems:
        raise CourseError(problems)
    make_private_folder(path.parent)
    write_text(path, f"{before.rstrip()}\n\n{added}\n", private=True)
    return path


def is_safe(address: str) -> bool:
    """Tell whether an address may be asked: by https, or on this machine for a trial."""
    try:
        parts = urlsplit(address)
        host, _ = parts.hostname or "", parts.port  # one that is no port raises
    except ValueError:
        return False
    if not host or parts.username is not None or not address.isprintable() or " " in address:
        return False
    return parts.scheme == "https" or (parts.scheme == "http" and _is_this_machine(host))


def is_of_platform(platform: Platform, address: str) -> bool:
    """Tell whether a platform may name an address of its own; one by https names none without."""
    plain = platform.token_url.startswith("http://")
    return is_safe(address) and (plain or address.startswith("https://"))


def origin_of(address: str) -> str:
    """Return scheme, host and port of an address."""
    parts = urlsplit(address)
    return f"{parts.scheme}://{parts.netloc}"


def _is_this_machine(host: str) -> bool:
    if host == "localhost":
        return True
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return False


def _platform(name: str, table: Table) -> Platform:
    table.known_keys(_KEYS)
    if not _NAME.fullmatch(name):
        what = message("'{name}' is no name of a platform.", name=name)
        table.add("", what, message("Write lower-case Latin letters, digits, - and _."))
    token_url = _address(table, "token_url")
    issuer = table.text("issuer")
    authorization_url = _address(table, "authorization_url")
    frames = table.strings("frames") or (origin_of(authorization_url),)
    for one in frames:
        if not is_safe(one) or origin_of(one) != one or set(one) & set(";,'\""):
            _no_address(table, "frames", one)
    return Platform(
        name=name,
        issuer=issuer,
        client_id=table.text("client_id"),
        authorization_url=authorization_url,
        token_url=token_url,
        jwks_url=_address(table, "jwks_url"),
        deployments=_some(table, "deployments"),
        contexts=table.strings("contexts"),
        known_by=_rules(table),
        frames=frames,
        token_audience=table.text("token_audience", "") or token_url,
    )


def _address(table: Table, name: str) -> str:
    address = table.text(name)
    if address and not is_safe(address):
        _no_address(table, name, address)
    return address


def _no_address(table: Table, name: str, address: str) -> None:
    what = message("'{address}' is not an address by https.", address=address)
    table.add(name, what, message("Write it whole, beginning with https://."))


def _some(table: Table, name: str) -> tuple[str, ...]:
    found = table.strings(name)
    if not found and name not in table.values:
        table.add(name, message("This key is missing."), message("Name at least one."))
    elif not found:
        table.add(name, message("The list is empty."), message("Name at least one."))
    return found


def _rules(table: Table) -> tuple[UserRule, ...]:
    written = table.strings("known_by")
    known = {one.value for one in UserRule}
    for one in written:
        if one not in known:
            what = message("'{rule}' is no rule.", rule=one)
            table.add("known_by", what, message("Write some of: {all}.", all=", ".join(known)))
    return tuple(UserRule(one) for one in written if one in known)


def _refuse_doubles(table: Table, found: Mapping[str, Platform]) -> None:
    seen: dict[tuple[str, str], str] = {}
    for name, one in found.items():
        other = seen.setdefault((one.issuer, one.client_id), name)
        if other != name:
            what: Message = message("This is the same platform as '{other}'.", other=other)
            table.add(f"platform.{name}", what, message("Declare it once."))


def _toml(value: object) -> str:
    """Write a text or texts as TOML does: like JSON, but it knows no pairs of half signs."""
    return json.dumps(_plain(value), ensure_ascii=False).replace("\x7f", "\\u007f")


def _plain(value: object) -> object:
    return list(map(str, value)) if isinstance(value, tuple) else value
