"""What this machine has and lacks: looked at once, then judged without touching anything.

`look` observes, `assess` is a pure function of what was observed, `checks` does both.
"""

import sys
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from pyexpat import version_info as expat_version

from gripcourse.machine.fonts import (
    FONT_PACKAGES,
    font_remedy,
    fonts_used,
    install,
    load_pango,
    missing_font,
)
from gripcourse.machine.office import office_command
from gripcourse.text.conventions import is_english
from gripcourse.text.translations import TranslationFault, catalogue_file, read_translations
from gripcourse.text.words import LANGUAGES, Message, message

PYTHON_NEEDED = (3, 11)
EXPAT_NEEDED = (2, 4)


@dataclass(frozen=True, slots=True)
class Machine:
    """What was seen.

    Attributes:
        python: version of the interpreter.
        expat: version of the XML parser that Python was built with.
        pango: why the text layout library cannot be loaded; empty when it can.
        subsetting: whether the library that cuts fonts to the used letters was found.
        fonts: for each wanted family, the family that a document would really get.
        translations: for each language, what is wrong with its sentences.
        office: the command that starts LibreOffice, None where there is none.
        folder: where results would be written.
        writable: whether a file could be made there.
    """

    python: tuple[int, ...]
    expat: tuple[int, ...]
    pango: str
    subsetting: bool
    fonts: tuple[tuple[str, str], ...]
    translations: tuple[tuple[str, tuple[TranslationFault, ...]], ...]
    office: str | None
    folder: Path
    writable: bool


@dataclass(frozen=True, slots=True)
class MachineCheck:
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


def checks(folder: Path) -> tuple[MachineCheck, ...]:
    """Look at this machine and judge it; results would be written to `folder`."""
    return assess(look(folder))


def look(folder: Path) -> Machine:
    """Observe what `assess` judges; a font is asked for the way a document asks for it."""
    pango, library = load_pango()
    return Machine(
        python=tuple(sys.version_info[:3]),
        expat=expat_version,
        pango=pango,
        subsetting=library is not None and library.harfbuzz_subset is not None,
        fonts=tuple(fonts_used(FONT_PACKAGES).items()),
        translations=tuple(
            (language, read_translations(catalogue_file(language), language).faults)
            for language in LANGUAGES
            if not is_english(language)
        ),
        office=office_command(),
        folder=folder,
        writable=_writable(folder),
    )


def assess(machine: Machine) -> tuple[MachineCheck, ...]:
    """Judge what was observed; pure, the order is the order of the output."""
    return (
        _python(machine),
        _expat(machine),
        _pango(machine),
        _subsetting(machine),
        *_fonts(machine.fonts),
        *_translations(machine.translations),
        _office(machine),
        _folder(machine),
    )


def _python(machine: Machine) -> MachineCheck:
    return MachineCheck(
        name="python",
        ok=machine.python >= PYTHON_NEEDED,
        required=True,
        message=message("Python {version}", version=_dotted(machine.python)),
        remedy=message("Install Python {version} or newer.", version=_dotted(PYTHON_NEEDED)),
    )


def _expat(machine: Machine) -> MachineCheck:
    return MachineCheck(
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


def _pango(machine: Machine) -> MachineCheck:
    found = message("Pango lays out the text of PDF files")
    failed = message("Pango cannot be loaded: {reason}", reason=machine.pango)
    return MachineCheck(
        name="pango",
        ok=not machine.pango,
        required=True,
        message=failed if machine.pango else found,
        remedy=install("libpango-1.0-0 libpangoft2-1.0-0"),
    )


def _subsetting(machine: Machine) -> MachineCheck:
    found = message("HarfBuzz cuts fonts to the letters that a document uses")
    failed = message("HarfBuzz for cutting fonts is missing: every PDF file takes twice as long")
    return MachineCheck(
        name="harfbuzz-subset",
        ok=machine.subsetting,
        required=True,
        message=found if machine.subsetting else failed,
        remedy=install("libharfbuzz-subset0"),
    )


def _fonts(fonts: Iterable[tuple[str, str]]) -> Iterable[MachineCheck]:
    for wanted, used in fonts:
        found = message("Font {family}", family=wanted)
        failed = missing_font(wanted, used)
        ok = wanted == used
        yield MachineCheck(
            name=f"font {wanted}",
            ok=ok,
            required=True,
            message=found if ok else failed,
            remedy=font_remedy(wanted),
        )


def _translations(
    found: Iterable[tuple[str, tuple[TranslationFault, ...]]],
) -> Iterable[MachineCheck]:
    for language, faults in found:
        whole = message("Sentences in the language {language} are whole", language=language)
        for said in map(_translation_fault, faults or (None,)):
            place = message("{language}.po: {fault}", language=language, fault=said)
            yield MachineCheck(
                name=f"translation {language}",
                ok=not faults,
                required=True,
                message=whole if said is None else place,
                remedy=message(
                    "Until it is corrected the English text stands there. Install gripcourse "
                    "again; in a catalogue of your own, give every sentence the names in braces "
                    "that the English one has."
                ),
            )


def _translation_fault(fault: TranslationFault | None) -> Message | None:
    if fault is None:
        return None
    match fault.kind:
        case "lost":
            said = message("line {line} loses {places}", line=fault.line, places=fault.detail)
        case "invented":
            said = message(
                "line {line} has {places}, which nobody gives", line=fault.line, places=fault.detail
            )
        case "braces":
            said = message(
                "line {line} has a brace that does not close: {text}",
                line=fault.line,
                text=fault.detail,
            )
        case "plural":
            said = message(
                "the plural forms are not those of the language: {forms}", forms=fault.detail
            )
        case "empty":
            said = message("there is no sentence in it")
        case "unreadable":
            said = message("the catalogue cannot be read: {reason}", reason=fault.detail)
    return said


def _office(machine: Machine) -> MachineCheck:
    found = message("LibreOffice: {path}", path=machine.office)
    failed = message("LibreOffice is missing: only needed to recalculate workbooks and for tests")
    return MachineCheck(
        name="libreoffice",
        ok=machine.office is not None,
        required=False,
        message=found if machine.office else failed,
        remedy=install("libreoffice-calc-nogui"),
    )


def _folder(machine: Machine) -> MachineCheck:
    found = message("Files can be written to {folder}", folder=machine.folder)
    failed = message("No file can be written to {folder}", folder=machine.folder)
    return MachineCheck(
        name="folder",
        ok=machine.writable,
        required=True,
        message=found if machine.writable else failed,
        remedy=message("Work in a folder of your own, or name one for the results."),
    )


def _dotted(version: Iterable[int]) -> str:
    return ".".join(str(part) for part in version)


def _writable(folder: Path) -> bool:
    """Try it: permission bits say nothing about full or read-only file systems."""
    try:
        with tempfile.TemporaryFile(dir=folder):
            return True
    except OSError:
        return False
