"""A new key for a course: what is issued from now on is signed with it."""

import secrets
from pathlib import Path

from gripcourse.issuing.signature import KEY_BYTES, key_path, rotate_key


def rotate(root: Path) -> Path:
    """Give a course a new key and return where it is; old signatures stay verifiable.

    Raises:
        RegisterError: the course has no key yet, or it is damaged.
        OSError: the folder cannot be written; the old key is untouched.
    """
    place = key_path(root)
    rotate_key(place, secrets.token_bytes(KEY_BYTES))
    return place
