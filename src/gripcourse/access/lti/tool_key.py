"""Our own key: platforms verify with its public half that a request is ours."""

import json
from pathlib import Path
from typing import Any, Final

from joserfc.errors import JoseError
from joserfc.jwk import KeySet, RSAKey

from gripcourse.access.lti.key_sets import ALGORITHM
from gripcourse.errors import Problem, UsageError
from gripcourse.machine.files import make_private_folder, write_text
from gripcourse.text.words import message

_BITS: Final = 2048
_FORMER: Final = 2
"""How many former keys are still published: a platform keeps for a while what it fetched."""


def tool_key_path(root: Path) -> Path:
    """Return where a course keeps its key for platforms."""
    return root / "private" / "lti_key.json"


def make_tool_key(root: Path) -> Path:
    """Put a new key on top: it signs from now on; where there was one, it is still published.

    Raises:
        UsageError: the key that is there is damaged.
        OSError: the folder cannot be written.
    """
    path = tool_key_path(root)
    former = read_tool_keys(root).keys if path.is_file() else []
    made = RSAKey.generate_key(_BITS, auto_kid=True)
    keys = KeySet([made, *former[:_FORMER]])
    make_private_folder(path.parent)
    write_text(path, json.dumps(keys.as_dict(private=True)) + "\n", private=True)
    return path


def read_tool_keys(root: Path) -> KeySet:
    """Read our keys; the first of them signs.

    Raises:
        UsageError: there is none, or the file is damaged.
        OSError: the file cannot be read.
    """
    try:
        keys = KeySet.import_key_set({"keys": _written(root)})
    except (JoseError, ValueError, KeyError, TypeError) as fault:
        raise _damaged(tool_key_path(root)) from fault
    if not keys.keys or not all(isinstance(one, RSAKey) and one.is_private for one in keys.keys):
        raise _damaged(tool_key_path(root))
    return keys


def public_keys(root: Path) -> dict[str, list[dict[str, str]]]:
    """Return what platforms may know of our keys; they are asked for by anybody, so none is tested.

    Raises:
        UsageError: there is none, or the file is damaged.
        OSError: the file cannot be read.
    """
    published = []
    for written in _written(root):
        match written:
            case {"kty": "RSA", "kid": str(key_id), "n": str(n), "e": str(e)}:
                shown = {"kty": "RSA", "kid": key_id, "n": n, "e": e}
                published.append({**shown, "use": "sig", "alg": ALGORITHM})
            case _:
                raise _damaged(tool_key_path(root))
    return {"keys": published}


def _written(root: Path) -> list[Any]:
    path = tool_key_path(root)
    if not path.is_file():
        what = message("There is no key for learning platforms yet.")
        remedy = message("Declare a platform first; that makes the key.")
        raise UsageError([Problem(str(path), "", what, remedy)])
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as fault:
        raise _damaged(path) from fault
    match content:
        case {"keys": [_, *_] as keys}:
            return list(keys)
    raise _damaged(path)


def _damaged(path: Path) -> UsageError:
    what = message("The key for learning platforms is damaged.")
    remedy = message("Restore it from a backup, or remove the file to make a new one.")
    return UsageError([Problem(str(path), "", what, remedy)])
