"""What options of a database URL may be set to, where PostgreSQL takes only certain words.

Its driver says of a wrong one only that no connection was made, as of a server that is away.
"""

import re
from collections.abc import Mapping
from typing import Final

from sqlalchemy.engine import URL

from gripcourse.machine.database.said import failure, without_password
from gripcourse.text.words import message

# Parameters of libpq 17: https://www.postgresql.org/docs/17/libpq-connect.html
_SWITCH: Final = ("0", "1")
_PROTOCOLS: Final = ("TLSv1", "TLSv1.1", "TLSv1.2", "TLSv1.3")
_WORDS: Final[Mapping[str, tuple[str, ...]]] = {
    "channel_binding": ("disable", "prefer", "require"),
    "gssencmode": ("disable", "prefer", "require"),
    "keepalives": _SWITCH,
    "load_balance_hosts": ("disable", "random"),
    "ssl_max_protocol_version": _PROTOCOLS,
    "ssl_min_protocol_version": _PROTOCOLS,
    "sslcertmode": ("disable", "allow", "require"),
    "sslcompression": _SWITCH,
    "sslmode": ("disable", "allow", "prefer", "require", "verify-ca", "verify-full"),
    "sslnegotiation": ("postgres", "direct"),
    "sslsni": _SWITCH,
    "target_session_attrs": (
        *("any", "read-write", "read-only", "primary", "standby", "prefer-standby"),
    ),
}
_NUMBERS: Final = frozenset(
    {
        *("connect_timeout", "keepalives_count", "keepalives_idle", "keepalives_interval"),
        "tcp_user_timeout",
    }
)
_NUMBER: Final = re.compile("-?[0-9]{1,9}")
_PORT: Final = re.compile("([0-9]{1,5}(,|$))+")
_LAST_PORT: Final = 65_535


def refuse_values(url: URL) -> None:
    """Refuse a URL with an option that PostgreSQL never takes so.

    Raises:
        GradebookError: it has one; the value is not shown, for a password may stand in its place.
    """
    for name in sorted(url.query):
        found = url.query[name]
        values = (found,) if isinstance(found, str) else found
        permitted = _permitted(name, values)
        if permitted:
            raise failure(
                without_password(url.difference_update_query([name])),
                message(
                    "The option {option} of this URL has a value that it cannot have.", option=name
                ),
                message("Write one of these: {values}.", values=permitted),
            )


def _permitted(name: str, values: tuple[str, ...]) -> str:
    """Return what an option may be set to, where it is set to something else; else nothing."""
    words = _WORDS.get(name)
    if words is not None:
        return "" if all(one in words for one in values) else ", ".join(words)
    if name in _NUMBERS:
        return "" if all(map(_NUMBER.fullmatch, values)) else "0, 1, 2, …"
    if name == "port" and not all(map(_is_port, values)):
        return f"1, 2, … {_LAST_PORT}"
    return ""


def _is_port(text: str) -> bool:
    """Tell whether a text names a port, or one for each of several hosts."""
    ports = [int(one) for one in text.split(",") if one] if _PORT.fullmatch(text) else [0]
    return all(0 < one <= _LAST_PORT for one in ports)
