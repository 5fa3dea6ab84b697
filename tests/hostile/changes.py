"""Changes of files by their form, for who is led by what ran: see `covered.py`.

Each takes a file, how large it may get, a number that the change is drawn from, and what changes
bytes as it likes.
"""

import json
import random
import zipfile
import zlib
from collections.abc import Callable, Mapping
from enum import Enum, auto
from functools import partial
from io import BytesIO
from typing import Final, TypeAlias

from hostile.mutations import CHANGES

Mutate: TypeAlias = Callable[[bytes, int], bytes]
Change: TypeAlias = Callable[[bytes, int, int], bytes]

LARGEST: Final = 200_000  # bytes of a file that is tried
LONGEST_NAME: Final = 300
_BYTES: Final = 0.1  # of changes look at nothing but bytes
_OUR_OWN: Final = 0.5  # of changes of a member are those of the tests, which know what matters
_RENAMED: Final = 0.3  # of the others give a member another name
_ANEW: Final = 0.6  # of files with a first line are changed from a sound one
_DEEPER: Final = 0.9
_VALUES: Final = (
    *(None, True, 0, -1, 1e308, float("nan"), float("inf"), 10**4000, [], {}, ""),
    *("x", "\0", "\ud800", "2026-02-30", "0001-01-01T00:00:00-23:59", "9" * 5000, "graded"),
)
_WRITTEN: Final = (
    *(b"0", b"-1", b"1e308", b"nan", b"-inf", b"0x10", b"9" * 5000, b"1e999", b"true", b"1,5"),
    *(b'""', b'"x"', b"'''a\nb'''", b"[]", b"[[]]", b"[1, 'a', {}]", b"{}", b"{a = {b = 1}}"),
    *(b'"\\u202e"', b'"\\ud800"', b"2026-02-30", b"2026-02-28T25:00:00Z", b"12:00:00", b"..."),
    *(b'"' + b"x" * 70_000 + b'"', b"[" * 600 + b"]" * 600, b'"' + b"(" * 400 + b'"', b"\xff"),
    *(b'"mass ^ 9999"', b'"m**m**m"', b'"sqrt(-1)"', b'"__import__"', b'"1/0"', b'"../../x"'),
    *(b'"mm^99999999999999999"', b'"N*m/s"', b'"%"', b'"load if load > 0 else mass"', b'"sum(x)"'),
    *(b'"mass + load * 2"', b'["mass", "load"]', b'{ru = "x"}', b'{en = "x", ru = 1}', b'"CON"'),
)


class Form(Enum):
    """What a file is made of: whatever, members, a line that says what the rest is, values."""

    PLAIN = auto()
    PACKED = auto()
    HEADED = auto()
    JSON = auto()


def change_of(form: Form, sound: tuple[bytes, ...], mutate: Mutate) -> Change | None:
    """Return what changes files of a form; None where bytes are as good as anything."""
    changes: Mapping[Form, Change] = {
        Form.PACKED: partial(_packed, mutate=mutate),
        Form.HEADED: partial(_headed, mutate=mutate, sound=sound),
        Form.JSON: partial(_values, mutate=mutate),
    }
    return changes.get(form)


def _packed(data: bytes, largest: int, seed: int, *, mutate: Mutate) -> bytes:
    """Change an archive: a member of it, or its own bytes."""
    draw = random.Random(seed)  # noqa: S311 (nothing secret)
    members = _members(data)
    if not members or draw.random() < _BYTES:
        return mutate(data, largest)
    name = draw.choice(list(members))
    if draw.random() < _OUR_OWN:
        draw.choice(CHANGES)(draw, members)
    elif draw.random() < _RENAMED:
        members[mutate(name.encode(), LONGEST_NAME).decode("utf-8", "replace")] = members.pop(name)
    else:
        members[name] = mutate(members[name], largest)
    stream = BytesIO()
    with zipfile.ZipFile(stream, "w") as made:
        for name, content in members.items():
            made.writestr(zipfile.ZipInfo(name), content)
    return stream.getvalue()[:largest]


def _members(data: bytes) -> dict[str, bytes]:
    try:
        with zipfile.ZipFile(BytesIO(data)) as opened:
            small = [one for one in opened.infolist() if one.file_size < LARGEST]
            return {one.filename: opened.read(one) for one in small}
    except (OSError, ValueError, RuntimeError, EOFError, zipfile.BadZipFile, zlib.error):
        return {}


def _headed(
    data: bytes, largest: int, seed: int, *, mutate: Mutate, sound: tuple[bytes, ...]
) -> bytes:
    """Change what stands below the first line.

    Often of a sound file: who reads all files of a course runs nearly the same lines for each, so
    that one file would be all that is kept.
    """
    draw = random.Random(seed)  # noqa: S311 (nothing secret)
    line, end, rest = (draw.choice(sound) if draw.random() < _ANEW else data).partition(b"\n")
    for _ in range(draw.choice((1, 1, 2, 3))):
        rest = _with_another_line(draw, rest)
    if draw.random() < _BYTES:
        rest = mutate(rest, largest - len(line) - 1)
    return (line + end + rest)[:largest]


def _with_another_line(draw: random.Random, text: bytes) -> bytes:
    lines = text.split(b"\n")
    place = draw.randrange(len(lines))
    name, equals, value = lines[place].partition(b"=")
    match draw.randrange(6):
        case 0:
            del lines[place]
        case 1:
            lines.insert(draw.randrange(len(lines)), lines[place])
        case 2:
            lines[place] = draw.choice(lines)
        case 3:
            lines[place] = name + equals + draw.choice(lines).partition(b"=")[2]
        case 4:
            words = value.split(b" ")
            words[draw.randrange(len(words))] = draw.choice(_WRITTEN)
            lines[place] = name + equals + b" ".join(words)
        case _:
            lines[place] = name + equals + b" " + draw.choice(_WRITTEN)
    return b"\n".join(lines)


def _values(data: bytes, largest: int, seed: int, *, mutate: Mutate) -> bytes:
    """Put something else in one or two places of a JSON document."""
    draw = random.Random(seed)  # noqa: S311 (nothing secret)
    try:
        plain = json.loads(data)
    except (ValueError, RecursionError):
        return mutate(data, largest)
    for _ in range(draw.choice((1, 1, 2))):
        plain = _with_another_value(draw, plain)
    return json.dumps(plain).encode()[:largest]


def _with_another_value(draw: random.Random, plain: object) -> object:
    if isinstance(plain, dict) and plain and draw.random() < _DEEPER:
        name = draw.choice(list(plain))
        other = draw.choice((name, name, name, "", "schema", "x" * 300))
        return {**plain, other: _with_another_value(draw, plain[name])}
    if isinstance(plain, list) and plain and draw.random() < _DEEPER:
        place = draw.randrange(len(plain))
        return [*plain[:place], _with_another_value(draw, plain[place]), *plain[place:]]
    return draw.choice((*_VALUES, [plain], {"x": plain}, [plain] * 3))
