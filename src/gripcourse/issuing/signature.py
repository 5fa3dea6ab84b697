"""The signature over what was issued: it shows whether anybody changed the numbers.

The key is 32 random bytes in the course's private folder. Whoever has it can sign; losing it makes
old signatures unverifiable, so it belongs into a backup and never into a repository.

The first line of the file is the key that signs; below it stand those that signed before, so that
what was issued with them stays verifiable.
"""

import hashlib
import hmac
import json
import re
from pathlib import Path

from gripcourse.errors import Problem, RegisterError
from gripcourse.machine.files import make_private_folder, making, write_text
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Variant

KEY_BYTES = 32

_KEY = re.compile(rf"[0-9a-f]{{{2 * KEY_BYTES}}}")
_MOST_KEYS = 100  # a file of more is no file of keys


def key_path(root: Path) -> Path:
    """Return where a course keeps its key."""
    return root / "private" / "key"


def make_key(path: Path, random_bytes: bytes) -> bytes:
    """Write a new key that only its owner can read.

    Args:
        path: of the file; nothing may be there yet.
        random_bytes: 32 bytes from a source fit for secrets.

    Returns:
        The key: of two programs that make one at once, both get that of the first.

    Raises:
        RegisterError: there is a key already; a new one would void every signature.
        ValueError: not 32 bytes.
        OSError: the folder cannot be written.
    """
    _check_length(random_bytes)
    if path.exists():
        raise _failure(
            path,
            message("There is a key already; a new one would void all signatures."),
            message("Keep it. To start a new course, move it away together with the register."),
        )
    make_private_folder(path.parent)
    with making(path) as unfinished:
        write_text(unfinished, random_bytes.hex() + "\n", private=True)
    return read_key(path)


def key_of(path: Path, *, issued: bool) -> bytes | None:
    """Return the key of a course; None where there is none and none is missed.

    Args:
        path: of the file.
        issued: whether anything was issued: then there was a key, and another one would void every
            signature that was made with it.

    Raises:
        RegisterError: the key is damaged or was lost.
    """
    return read_key(path) if issued or path.exists() else None


def read_key(path: Path) -> bytes:
    """Read the key that signs; errors as in `read_keys`."""
    return read_keys(path)[0]


def rotate_key(path: Path, random_bytes: bytes) -> int:
    """Put a new key on top: it signs from now on, the others still verify.

    Args:
        path: of the file.
        random_bytes: 32 bytes from a source fit for secrets.

    Returns:
        How many keys there are now.

    Raises:
        RegisterError: there is no key that could be replaced, or it is damaged.
        ValueError: not 32 bytes.
        OSError: the folder cannot be written; the old key is untouched.
    """
    _check_length(random_bytes)
    keys = (random_bytes, *read_keys(path))
    write_text(path, "".join(f"{one.hex()}\n" for one in keys), private=True)
    return len(keys)


def read_keys(path: Path) -> tuple[bytes, ...]:
    """Read the key that signs, and behind it those that signed before.

    Raises:
        RegisterError: the key is missing or damaged.
    """
    try:
        lines = path.read_text(encoding="ascii").split()
    except FileNotFoundError:
        raise _failure(
            path,
            message("The key of the signatures is missing."),
            message("Restore it from a backup; a new course gets one with its first issue."),
        ) from None
    except UnicodeDecodeError:
        lines = []
    if not 0 < len(lines) <= _MOST_KEYS or not all(map(_KEY.fullmatch, lines)):
        raise _failure(
            path,
            message("The key of the signatures is damaged: it must be {digits} digits 0-9 a-f.",
                    digits=2 * KEY_BYTES),
            message("Restore it from a backup."),
        )  # fmt: skip
    return tuple(map(bytes.fromhex, lines))


def sign(key: bytes, course_id: str, student_id: str, variant: Variant, version: int = 1) -> str:
    """Return the HMAC-SHA256 over course, student, variant and version, in hexadecimal.

    A student's name or language may be corrected later, so they are not part of it.
    """
    signed = _canonical(course_id, student_id, variant, version)
    return hmac.new(key, signed, hashlib.sha256).hexdigest()


def verify(
    key: bytes,
    course_id: str,
    student_id: str,
    variant: Variant,
    signature: str,
    version: int = 1,
) -> bool:
    """Tell whether a signature belongs to these numbers, in time that says nothing about it."""
    expected = sign(key, course_id, student_id, variant, version)
    return hmac.compare_digest(expected.encode(), signature.encode())


def _check_length(random_bytes: bytes) -> None:
    if len(random_bytes) != KEY_BYTES:
        raise ValueError(f"a key has {KEY_BYTES} bytes, not {len(random_bytes)}")


def _canonical(course_id: str, student_id: str, variant: Variant, version: int) -> bytes:
    """Write what is signed in the one form that equal values have."""
    signed: dict[str, object] = {
        "course": course_id,
        "student": student_id,
        "variant": variant.id,
        "scheme": variant.scheme,
        "options": dict(variant.options),
        "given": {id_: float(value) for id_, value in variant.given.items()},
    }
    if version > 1:
        # What was signed before there were versions stays as it was.
        signed["version"] = version
    return json.dumps(
        signed, sort_keys=True, ensure_ascii=True, allow_nan=False, separators=(",", ":")
    ).encode()


def _failure(path: Path, what: Message, remedy: Message) -> RegisterError:
    return RegisterError([Problem(str(path), "", what, remedy)])
