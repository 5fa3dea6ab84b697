"""What this machine has and lacks: looked at once, then judged without touching anything.

`look` observes, `assess` is a pure function of what was observed, `checks` does both.
"""

import shutil
import sys
import tempfile
import warnings
from collections.abc import Iterable
from contextlib import redirect_stdout
from dataclasses import dataclass
from io import StringIO
from pathlib import Path
from pyexpat import version_info as expat_version
from typing import Any

from gripcourse.words import Message, message

PYTHON_NEEDED = (3, 11)
EXPAT_NEEDED = (2, 4)
# The families that the style sheets name, each with the Debian package that brings it.
FONT_PACKAGES = {
    "PT Serif": "fonts-paratype",
    "PT Sans": "fonts-paratype",
    "DejaVu Serif": "fonts-dejavu-core",
    "DejaVu Sans": "fonts-dejavu-core",
}


@dataclass(frozen=True, slots=True)
class Machine:
    """What was seen.

    Attributes:
        python: version of the interpreter.
        expat: version of the XML parser that Python was built with.
        pango: why the text layout library cannot be loaded; empty when it can.
        subsetting: whether the library that cuts fonts to the used letters was found.
        fonts: for each wanted family, the family that a document would really get.
        office: the command that starts LibreOffice, None where there is none.
        folder: where results would be written.
        writable: whether a file could be made there.
    """

    python: tuple[int, ...]
    expat: tuple[int, ...]
    pango: str
    subsetting: bool
    fonts: tuple[tuple[str, str], ...]
    office: str | None
    folder: Path
    writable: bool


@dataclass(frozen=True, slots=True)
class Check:
    """The judgement on one thing.

    Attributes:
        name: short and fixed, for scripts that read the output.
        ok: whether it is as it should be.
        required: whether the program does not work, or works badly, without it.
        message: what was found.
        remedy: what to do about it when it is not ok.
    """

    name: str
    ok: bool
    required: bool
    message: Message
    remedy: Message


def checks(folder: Path) -> tuple[Check, ...]:
    """Look at this machine and judge it; results would be written to `folder`."""
    return assess(look(folder))


def look(folder: Path) -> Machine:
    """Observe what `assess` judges; a font is asked for the way a document asks for it."""
    pango, library = _load_pango()
    families = FONT_PACKAGES if library else ()
    return Machine(
        python=tuple(sys.version_info[:3]),
        expat=expat_version,
        pango=pango,
        subsetting=library is not None and library.harfbuzz_subset is not None,
        fonts=tuple((family, _family_used(library, family)) for family in families),
        office=shutil.which("soffice") or shutil.which("libreoffice"),
        folder=folder,
        writable=_writable(folder),
    )


def assess(machine: Machine) -> tuple[Check, ...]:
    """Judge what was observed; pure, the order is the order of the output."""
    return (
        _python(machine),
        _expat(machine),
        _pango(machine),
        _subsetting(machine),
        *_fonts(machine.fonts),
        _office(machine),
        _folder(machine),
    )


def _python(machine: Machine) -> Check:
    return Check(
        name="python",
        ok=machine.python >= PYTHON_NEEDED,
        required=True,
        message=message("Python {version}", version=_dotted(machine.python)),
        remedy=message("Install Python {version} or newer.", version=_dotted(PYTHON_NEEDED)),
    )


def _expat(machine: Machine) -> Check:
    return Check(
        name="expat",
        ok=machine.expat >= EXPAT_NEEDED,
        required=True,
        message=message("XML parser expat {version}", version=_dotted(machine.expat)),
        remedy=message(
            "A workbook made to exhaust memory is not refused by this version: use a Python with "
            "expat {version} or newer.",
            version=_dotted(EXPAT_NEEDED),
        ),
    )


def _pango(machine: Machine) -> Check:
    found = message("Pango lays out the text of PDF files")
    failed = message("Pango cannot be loaded: {reason}", reason=machine.pango)
    return Check(
        name="pango",
        ok=not machine.pango,
        required=True,
        message=failed if machine.pango else found,
        remedy=_install("libpango-1.0-0 libpangoft2-1.0-0"),
    )


def _subsetting(machine: Machine) -> Check:
    found = message("HarfBuzz cuts fonts to the letters that a document uses")
    failed = message("HarfBuzz for cutting fonts is missing: every PDF file takes twice as long")
    return Check(
        name="harfbuzz-subset",
        ok=machine.subsetting,
        required=True,
        message=found if machine.subsetting else failed,
        remedy=_install("libharfbuzz-subset0"),
    )


def _fonts(fonts: Iterable[tuple[str, str]]) -> Iterable[Check]:
    for wanted, used in fonts:
        found = message("Font {family}", family=wanted)
        failed = message("Font {family} is missing, {used} is used", family=wanted, used=used)
        ok = wanted == used
        yield Check(
            name=f"font {wanted}",
            ok=ok,
            required=True,
            message=found if ok else failed,
            remedy=_install(FONT_PACKAGES[wanted]),
        )


def _office(machine: Machine) -> Check:
    found = message("LibreOffice: {path}", path=machine.office)
    failed = message("LibreOffice is missing: only needed to recalculate workbooks and for tests")
    return Check(
        name="libreoffice",
        ok=machine.office is not None,
        required=False,
        message=found if machine.office else failed,
        remedy=_install("libreoffice-calc-nogui"),
    )


def _folder(machine: Machine) -> Check:
    found = message("Files can be written to {folder}", folder=machine.folder)
    failed = message("No file can be written to {folder}", folder=machine.folder)
    return Check(
        name="folder",
        ok=machine.writable,
        required=True,
        message=found if machine.writable else failed,
        remedy=message("Work in a folder of your own, or name one for the results."),
    )


def _install(packages: str) -> Message:
    return message("On Debian: apt-get install {packages}", packages=packages)


def _dotted(version: Iterable[int]) -> str:
    return ".".join(str(part) for part in version)


def _load_pango() -> tuple[str, Any]:
    """Load the libraries the way WeasyPrint does: (reason of failure or "", its bindings)."""
    try:
        # WeasyPrint prints advice of its own on standard output and warns; the check says it all.
        with redirect_stdout(StringIO()), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            # 450 ms that no other command should pay for.
            from weasyprint.text import ffi  # noqa: PLC0415
    except OSError as error:
        return str(error), None
    return "", ffi


def _family_used(library: Any, family: str) -> str:  # noqa: ANN401 - WeasyPrint ships no types
    """Ask Pango which font family a document gets that asks for `family`."""
    ffi, pango, gobject = library.ffi, library.pango, library.gobject
    fonts = ffi.gc(library.pangoft2.pango_ft2_font_map_new(), gobject.g_object_unref)
    context = ffi.gc(pango.pango_font_map_create_context(fonts), gobject.g_object_unref)
    free = pango.pango_font_description_free
    wanted = ffi.gc(pango.pango_font_description_new(), free)
    pango.pango_font_description_set_family(wanted, family.encode())
    font = ffi.gc(pango.pango_font_map_load_font(fonts, context, wanted), gobject.g_object_unref)
    used = ffi.gc(pango.pango_font_describe_with_absolute_size(font), free)
    return str(ffi.string(pango.pango_font_description_get_family(used)).decode())


def _writable(folder: Path) -> bool:
    """Try it: permission bits say nothing about full or read-only file systems."""
    try:
        with tempfile.TemporaryFile(dir=folder):
            return True
    except OSError:
        return False
