"""By what jobs are done here: this program, the interpreter, libraries and fonts, with versions.

Two machines of which all of this is the same come to the same results, byte for byte.
"""

import hashlib
import platform
import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from importlib import metadata
from pathlib import Path
from typing import Final

from gripcourse.machine.fonts import FONT_PACKAGES, fonts_used, load_pango
from gripcourse.machine.resources import TEMPLATES, template_folders

_PACKAGE: Final = Path(__file__).parents[1]
_COUNTS: Final = {".py", ".csv", ".po"}
_NAME: Final = re.compile(r"[\w.-]+")
_OURS: Final = "gripcourse"
# They carry the jobs; what an extra brings besides does not decide over results.
_CARRIERS: Final = ("dask", "distributed")


@lru_cache(maxsize=1)
def program_here() -> Mapping[str, str]:
    """Return what decides what jobs come to on this machine, each by name with its version."""
    libraries = {name: metadata.version(name) for name in _libraries()}
    return {
        _OURS: f"{metadata.version(_OURS)} ({_digest()[:12]})",
        "Python": platform.python_version(),
        **libraries,
        "Pango": _pango(),
        **{f"font {name}": used for name, used in fonts_used(FONT_PACKAGES).items()},
    }


def differences(ours: Mapping[str, str], theirs: Mapping[str, str]) -> dict[str, tuple[str, str]]:
    """Return by name what is not the same: our version and theirs, empty for none."""
    names = (*ours, *(one for one in theirs if one not in ours))
    pairs = {name: (ours.get(name, ""), theirs.get(name, "")) for name in names}
    return {name: (mine, other) for name, (mine, other) in pairs.items() if mine != other}


def _pango() -> str:
    library = load_pango()[1]
    return "" if library is None else str(library.pango.pango_version())


def _libraries() -> list[str]:
    """Return the libraries that this program needs, and those that they need, where installed."""
    found: set[str] = set()
    wanted = [_OURS, *_CARRIERS]
    while wanted:
        name = _plain(wanted.pop())
        if name not in found:
            try:
                required = metadata.requires(name) or []
            except metadata.PackageNotFoundError:
                continue
            found.add(name)
            wanted += [one for one in required if "extra ==" not in one]
    return sorted(found - {_OURS})


def _plain(requirement: str) -> str:
    name = _NAME.match(requirement)
    return re.sub(r"[-_.]+", "-", name[0]).lower() if name else ""


def _digest() -> str:
    """Digest the files of this program and of its look that decide over results."""
    whole = hashlib.sha256()
    for name, path in sorted(_files()):
        content = path.read_bytes()
        # Lengths keep the end of one file apart from the beginning of the next.
        whole.update(f"{name}\n{len(content)}\n".encode())
        whole.update(content)
    return whole.hexdigest()


def _files() -> Iterator[tuple[str, Path]]:
    for path in _PACKAGE.rglob("*"):
        name = path.relative_to(_PACKAGE)
        # A wheel carries the reference course, which travels with the jobs.
        if path.suffix in _COUNTS and name.parts[0] != "_course":
            yield name.as_posix(), path
    for folder in template_folders(_PACKAGE / TEMPLATES):
        for path in folder.rglob("*"):
            if path.is_file():
                yield f"{TEMPLATES}/{path.relative_to(folder).as_posix()}", path
