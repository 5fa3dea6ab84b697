"""Instructors sign in by a link from the command line that is good once."""

import secrets
from datetime import datetime, timedelta
from typing import Final

from gripcourse.usecases.serving.desk import DeskBooks

SIGN_IN_MINUTES: Final = 30
SESSION_HOURS: Final = 10
_BYTES: Final = 24


def offer_sign_in(context: DeskBooks, name: str, now: datetime) -> str:
    """Make a token with which somebody can sign in once, within half an hour."""
    token = secrets.token_urlsafe(_BYTES)
    context.desk.add_sign_in(token, name, now + timedelta(minutes=SIGN_IN_MINUTES))
    return token


def sign_in(context: DeskBooks, token: str, now: datetime) -> str | None:
    """Use up a token for a session that nobody knew before; None where it is no good."""
    session = secrets.token_urlsafe(_BYTES)
    expires = now + timedelta(hours=SESSION_HOURS)
    return session if context.desk.begin_session(token, session, expires, now) else None
