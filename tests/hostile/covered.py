"""Look for files that fail a reader, led by the lines that each runs: `covered.py READER [OPTION…]`.

Atheris, which drives libFuzzer, counts what ran; the options are libFuzzer's, for example
`-max_total_time=60`. Members of archives are changed one by one, else every change would be one
check sum that does not fit. What fails is kept in `once_failed/READER/`: the tests read it for ever.
"""

import hashlib
import json
import random
import sys
import tempfile
import time
import traceback
import zipfile
import zlib
from io import BytesIO
from pathlib import Path
from typing import Final

import atheris

if __name__ == "__main__":  # as a program it does not know where the tests are
    sys.path.insert(0, str(Path(__file__).parents[1]))

with atheris.instrument_imports(include=["gripcourse"]):
    from gripcourse.errors import GripcourseError
    from gripcourse.jobs.limits import peak_memory
    from hostile.kept import FAILED
    from hostile.mutations import CHANGES
    from hostile.readers import READERS, Form, Reader

SECONDS: Final = 2.0  # of processor time; who counts what runs is three times as slow
MEGABYTES: Final = 256
_SLOWER: Final = 3.0
_LARGEST: Final = 200_000  # bytes of a file that is tried
_OF_THE_ARCHIVE: Final = 0.1  # of changes are done to the archive itself, not to a member
_OUR_OWN: Final = 0.5  # of changes of a member are those of the tests, which know what matters

_DEEPER: Final = 0.9
_VALUES: Final = (
    *(None, True, 0, -1, 1e308, float("nan"), float("inf"), 10**4000, [], {}, ""),
    *("x", "\0", "\ud800", "2026-02-30", "0001-01-01T00:00:00-23:59", "9" * 5000, "graded"),
)


def fault_of(reader: Reader, data: bytes) -> str:
    """Return what is wrong with how a file is read; empty for nothing."""
    started, before = time.process_time(), peak_memory()
    try:
        if not reader.read(data):
            return "nothing came of it"
    except GripcourseError:
        pass
    except Exception as fault:  # noqa: BLE001 (it is what is looked for)
        return f"{fault!r} at {_place_of(fault)}"
    taken, grown = time.process_time() - started, (peak_memory() - before) / 1e6
    if taken > SECONDS * _SLOWER:
        return f"{taken:.1f} s"
    return f"{grown:.0f} MB" if grown > MEGABYTES else ""


def _place_of(fault: Exception) -> str:
    ours = [
        one for one in traceback.extract_tb(fault.__traceback__) if "gripcourse" in one.filename
    ]
    return f"{Path(ours[-1].filename).name}:{ours[-1].lineno}" if ours else "no line of ours"


def changed(data: bytes, largest: int, seed: int) -> bytes:
    """Change an archive: a member of it, or its own bytes."""
    draw = random.Random(seed)  # noqa: S311 (nothing secret)
    members = _members(data)
    if not members or draw.random() < _OF_THE_ARCHIVE:
        return bytes(atheris.Mutate(data, largest))
    if draw.random() < _OUR_OWN:
        draw.choice(CHANGES)(draw, members)
    else:
        name = draw.choice(list(members))
        members[name] = bytes(atheris.Mutate(members[name], largest))
    stream = BytesIO()
    with zipfile.ZipFile(stream, "w") as made:
        for name, content in members.items():
            made.writestr(zipfile.ZipInfo(name), content)
    return stream.getvalue()[:largest]


def changed_below(data: bytes, largest: int, _seed: int) -> bytes:
    """Change what stands below the first line, which says what it is."""
    line, end, rest = data.partition(b"\n")
    return line + end + bytes(atheris.Mutate(rest, largest - len(line) - 1))


def changed_values(data: bytes, largest: int, seed: int) -> bytes:
    """Put something else in one or two places of a JSON document."""
    draw = random.Random(seed)  # noqa: S311 (nothing secret)
    try:
        plain = json.loads(data)
    except (ValueError, RecursionError):
        return bytes(atheris.Mutate(data, largest))
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


_CHANGES: Final = {
    Form.PACKED: changed,
    Form.HEADED: changed_below,
    Form.JSON: changed_values,
}


def _members(data: bytes) -> dict[str, bytes]:
    try:
        with zipfile.ZipFile(BytesIO(data)) as opened:
            small = [one for one in opened.infolist() if one.file_size < _LARGEST]
            return {one.filename: opened.read(one) for one in small}
    except (OSError, ValueError, RuntimeError, EOFError, zipfile.BadZipFile, zlib.error):
        return {}


def main(name: str, options: list[str]) -> None:
    """Try files until the options say that it is enough."""
    reader, known = READERS[name], set[str]()
    folder = FAILED / name

    def one_input(data: bytes) -> None:
        fault = fault_of(reader, data)
        # One file of each fault; how many seconds it took makes no other one.
        kind = fault.rpartition(" at ")[2] if " at " in fault else fault.rpartition(" ")[2]
        if fault and kind not in known:
            known.add(kind)
            folder.mkdir(parents=True, exist_ok=True)
            file = folder / hashlib.sha256(data).hexdigest()[:12]
            file.write_bytes(data)
            sys.stderr.write(f"FAILED {file}: {fault[:300]}\n")

    with tempfile.TemporaryDirectory() as corpus:
        for number, data in enumerate(reader.sound):
            (Path(corpus) / f"sound{number}").write_bytes(data)
        arguments = [__file__, f"-max_len={_LARGEST}", "-len_control=0", *options, corpus]
        mutator = {"custom_mutator": _CHANGES[reader.form]} if reader.form in _CHANGES else {}
        with atheris.instrument_imports(include=["gripcourse", "ezdxf"]):
            for data in reader.sound:  # some packages are imported where they are used
                reader.read(data)
        atheris.Setup(arguments, one_input, enable_python_coverage=True, **mutator)
        atheris.Fuzz()


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
