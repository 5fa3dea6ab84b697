"""LibreOffice, where a machine has it: workbooks of other formats, and formulas without results.

It gets files of strangers: it has a profile of its own that runs no macros, follows no links and
knows no network, bounded memory and time, and nobody's documents.
"""

import hashlib
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

_TO_START: Final = 60.0  # seconds, the first time and on a machine that is busy
_OF_EACH: Final = 5.0  # for a file
_AT_ONCE: Final = 100  # files in one call
_MEMORY: Final = 4 * 1024**3  # bytes of address space; the program itself takes 1.5 GB of it
_LARGEST: Final = 100 * 1000**2  # bytes of what it writes
_LOCALES: Final = {"en": "en-US", "ru": "ru-RU", "uk": "uk-UA"}

# Codes of an end that a file alone is to blame for: the program says that it cannot open it, or has
# taken all its processor time (the last is that of the shell which starts it). Memory and time by
# the clock may have been the machine's.
_BY_ITSELF: Final = frozenset({0, 1, -24, 128 + 24})

_ITEM: Final = (
    '<item oor:path="/org.openoffice.{}"><prop oor:name="{}" oor:op="fuse">'
    "<value>{}</value></prop></item>"
)
_SETTINGS: Final = (
    ("Office.Calc/Formula/Load", "OOXMLRecalcMode", "0"),  # always
    ("Office.Calc/Content/Update", "Link", "2"),  # never
    ("Office.Common/Security/Scripting", "MacroSecurityLevel", "3"),
    ("Office.Common/Security/Scripting", "DisableMacrosExecution", "true"),
    ("Office.Common/Security/Scripting", "BlockUntrustedRefererLinks", "true"),
    ("Inet/Settings", "ooInetProxyType", "2"),
    ("Inet/Settings", "ooInetHTTPProxyName", "127.0.0.1"),  # nobody listens there
    ("Inet/Settings", "ooInetHTTPProxyPort", "9"),
    ("Inet/Settings", "ooInetHTTPSProxyName", "127.0.0.1"),
    ("Inet/Settings", "ooInetHTTPSProxyPort", "9"),
)


def office_command() -> str | None:
    """Return the command that starts LibreOffice, None where there is none."""
    return shutil.which("soffice") or shutil.which("libreoffice")


@dataclass(frozen=True, slots=True)
class Conversion:
    """What LibreOffice made of files.

    Attributes:
        made: content by name.
        unopened: names of those that it gave up by itself, each alone: it would do so again.
    """

    made: Mapping[str, bytes]
    unopened: frozenset[str]


def office_identity(command: str | None) -> str:
    """Return what tells one LibreOffice from another that may open what this one could not."""
    if command is None:
        return ""
    program = Path(command).resolve()
    for told_by in (program.with_name("versionrc"), program):
        with suppress(OSError):
            return f"{command} {hashlib.sha256(told_by.read_bytes()).hexdigest()}"
    return command


def converted(files: Mapping[str, bytes], office: str, language: str) -> Conversion:
    """Let LibreOffice open files, compute their formulas and save them as `.xlsx`.

    All go through one call, which costs a start and little more for each. One that takes the others
    along is tried again alone.

    Args:
        files: content by name; names end as the format does, and without that they differ.
        office: the command that starts it.
        language: of the course; formulas read texts as numbers as it writes them.
    """
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        _write_profile(folder / "profile", language)
        for name, data in files.items():
            (folder / name).write_bytes(data)
        names = list(files)
        if len(names) > 1:
            for start in range(0, len(names), _AT_ONCE):
                _convert(folder, names[start : start + _AT_ONCE], office)
        left = [name for name in names if not _result(folder, name).exists()]
        ended = {name: _convert(folder, [name], office) for name in left}
        made = {
            name: _result(folder, name).read_bytes()
            for name in names
            if _result(folder, name).exists()
        }
        given_up = (name for name, code in ended.items() if code in _BY_ITSELF)
        return Conversion(made, frozenset(given_up) - made.keys())


def _result(folder: Path, name: str) -> Path:
    return folder / "out" / f"{Path(name).stem}.xlsx"


def _write_profile(profile: Path, language: str) -> None:
    locale = ("Setup/L10N", "ooSetupSystemLocale", _LOCALES.get(language, "en-US"))
    items = "".join(_ITEM.format(*one) for one in (*_SETTINGS, locale))
    (profile / "user").mkdir(parents=True)
    (profile / "user" / "registrymodifications.xcu").write_text(
        '<?xml version="1.0" encoding="UTF-8"?>'
        f'<oor:items xmlns:oor="http://openoffice.org/2001/registry">{items}</oor:items>',
        encoding="utf-8",
    )


def _convert(folder: Path, names: Iterable[str], office: str) -> int | None:
    """Start LibreOffice once, and return the code that it ended with; None where it was stopped."""
    paths = [str(folder / name) for name in names]
    command = [
        *(office, f"-env:UserInstallation={(folder / 'profile').as_uri()}"),
        *("--headless", "--norestore", "--convert-to", "xlsx", "--outdir", str(folder / "out")),
        *paths,
    ]
    seconds = _TO_START + _OF_EACH * len(paths)
    with subprocess.Popen(  # noqa: S603 (a found program; file names are ours)
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        cwd=folder,
        start_new_session=True,
    ) as program:
        _bound(program.pid, seconds)
        try:
            return program.wait(seconds)
        except subprocess.TimeoutExpired:
            _end(program)
            return None
        except BaseException:
            _end(program)
            raise


def _bound(process: int, seconds: float) -> None:
    """Bound what it starts, too; elsewhere than on Linux there is the clock alone."""
    if sys.platform == "linux":
        import resource  # noqa: PLC0415 (exists on Unix only)

        for kind, wanted in (
            (resource.RLIMIT_AS, _MEMORY),
            (resource.RLIMIT_CPU, int(seconds)),
            (resource.RLIMIT_FSIZE, _LARGEST),
        ):
            with suppress(ProcessLookupError):
                _, hard = resource.prlimit(process, kind)
                most = wanted if hard == resource.RLIM_INFINITY else min(wanted, hard)
                resource.prlimit(process, kind, (most, most))


def _end(program: "subprocess.Popen[bytes]") -> None:
    """End it and what it started."""
    if sys.platform == "win32":
        program.kill()
        return
    with suppress(ProcessLookupError):
        os.killpg(program.pid, signal.SIGKILL)
