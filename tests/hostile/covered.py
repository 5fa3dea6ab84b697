"""Look for files that fail a reader, led by the lines that ran: `covered.py READER [OPTION…]`.

Atheris, which drives libFuzzer, counts what ran; the options are libFuzzer's, for example
`-max_total_time=60`. Members of archives are changed one by one, else every change would be one
check sum that does not fit. What fails is kept in `once_failed/READER/`: the tests read it for
ever. Who counts what runs is slower, so a file that takes too long here need not do so elsewhere.
"""

import hashlib
import sys
import tempfile
import time
import traceback
from pathlib import Path
from typing import Final

import atheris

if __name__ == "__main__":  # as a program it does not know where the tests are
    sys.path.insert(0, str(Path(__file__).parents[1]))

with atheris.instrument_imports(include=["gripcourse"]):
    from gripcourse.errors import GripcourseError
    from gripcourse.machine.jobs.limits import peak_memory
    from hostile.changes import LARGEST, change_of
    from hostile.readers import FAILED, READERS, Reader

SECONDS: Final = 2.0  # of processor time
MEGABYTES: Final = 256
_SLOWER: Final = 3.0  # where what runs is counted


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
    ran = traceback.extract_tb(fault.__traceback__)
    ours = [one for one in ran if "gripcourse" in one.filename]
    return f"{Path(ours[-1].filename).name}:{ours[-1].lineno}" if ours else "no line of ours"


def _mutate(data: bytes, largest: int) -> bytes:
    return bytes(atheris.Mutate(data, largest))  # which is another function before it begins


def main(name: str, options: list[str]) -> None:
    """Try files until the options say that it is enough."""
    reader, known = READERS[name], set[str]()
    folder = FAILED / name
    folder.mkdir(parents=True, exist_ok=True)

    def one_input(data: bytes) -> None:
        fault = fault_of(reader, data)
        # One file of each fault; how many seconds it took makes no other one.
        kind = fault.rpartition(" at ")[2] if " at " in fault else fault.rpartition(" ")[2]
        if fault and kind not in known:
            known.add(kind)
            file = folder / hashlib.sha256(data).hexdigest()[:12]
            file.write_bytes(data)
            sys.stderr.write(f"FAILED {file}: {fault[:300]}\n")

    change = change_of(reader.form, reader.sound, _mutate)
    with tempfile.TemporaryDirectory() as corpus:
        for number, data in enumerate(reader.sound):
            (Path(corpus) / f"sound{number}").write_bytes(data)
        with atheris.instrument_imports(include=["gripcourse", "ezdxf"]):
            for data in reader.sound:  # some packages are imported where they are used
                reader.read(data)
        atheris.Setup(
            [
                *(__file__, f"-max_len={LARGEST}", "-len_control=0"),
                f"-artifact_prefix={folder}/",  # what no Python could catch: no end, no memory
                *(*options, corpus),
            ],
            one_input,
            enable_python_coverage=True,
            **({} if change is None else {"custom_mutator": change}),
        )
        atheris.Fuzz()


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
