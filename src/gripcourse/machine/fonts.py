"""The fonts of this machine, asked for the way a document asks for them.

Whoever asks for a font that is not there silently gets another one, or none.
"""

import sys
from collections.abc import Iterable
from contextlib import redirect_stdout
from importlib import import_module
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from io import BytesIO, StringIO
from pathlib import Path
from types import ModuleType
from typing import Any, Final

from gripcourse.machine.process_wide import libraries_by_full_name, without_warnings
from gripcourse.text.words import Message, message

# The families that the style sheets name, each with the Debian package that brings it.
FONT_PACKAGES = {
    "PT Serif": "fonts-paratype",
    "PT Sans": "fonts-paratype",
    "Liberation Serif": "fonts-liberation",
    "Liberation Sans": "fonts-liberation",
    "DejaVu Serif": "fonts-dejavu-core",
    "DejaVu Sans": "fonts-dejavu-core",
}


_BINDINGS: Final = "weasyprint.text.ffi"
_GREEK = "αβγδηθλμπρστφψωΔΣ"


def fonts_used(families: Iterable[str]) -> dict[str, str]:
    """Return for each family the one that a document really gets; nothing without Pango.

    The family is empty where the machine has no font at all.
    """
    library = load_pango()[1]
    return {one: _family_used(library, one) for one in families} if library else {}


def without_greek(families: Iterable[str]) -> tuple[str, ...]:
    """Return those families that have no Greek letters: formulas take them from another font."""
    library = load_pango()[1]
    return tuple(one for one in families if library and not _has_greek(library, one))


def missing_font(family: str, used: str) -> Message:
    """Say that a document gets another font than it asks for, or none."""
    if not used:
        return message("Font {family} is missing, and this machine has no other", family=family)
    return message("Font {family} is missing, {used} is used", family=family, used=used)


def font_remedy(family: str) -> Message:
    """Say where a font family comes from."""
    package = FONT_PACKAGES.get(family)
    if package is None:
        return message("Install this font, or name one that is installed.")
    return install(package)


def install(packages: str) -> Message:
    """Say how Debian packages are installed."""
    return message("On Debian: apt-get install {packages}", packages=packages)


def load_pango() -> tuple[str, Any]:
    """Load the libraries the way WeasyPrint does: (reason of failure or "", its bindings)."""
    try:
        # WeasyPrint prints advice of its own on standard output and warns; the check says it all.
        with libraries_by_full_name(), without_warnings(), redirect_stdout(StringIO()):
            return "", _bindings()
    except OSError as error:
        return str(error), None


def _bindings() -> ModuleType:
    """Import the one module of WeasyPrint that loads libraries: all of it takes 350 ms longer.

    It needs nothing of the rest, which finds it imported when a document is made.
    """
    package = find_spec(_BINDINGS.partition(".")[0])
    path = None if package is None or package.origin is None else Path(package.origin).parent
    spec = None if path is None else spec_from_file_location(_BINDINGS, path / "text" / "ffi.py")
    if _BINDINGS in sys.modules or spec is None or spec.loader is None:
        return import_module(_BINDINGS)
    found = module_from_spec(spec)
    spec.loader.exec_module(found)
    sys.modules[_BINDINGS] = found
    return found


def _family_used(library: Any, family: str) -> str:  # noqa: ANN401 - WeasyPrint ships no types
    """Ask Pango which font family a document gets that asks for `family`; empty for none at all."""
    ffi, pango = library.ffi, library.pango
    font = _loaded(library, family)
    if font is None:
        return ""
    free = pango.pango_font_description_free
    used = ffi.gc(pango.pango_font_describe_with_absolute_size(font), free)
    return str(ffi.string(pango.pango_font_description_get_family(used)).decode())


def _has_greek(library: Any, family: str) -> bool:  # noqa: ANN401 - WeasyPrint ships no types
    """Look into the file of a font whether it has Greek letters, small and capital."""
    # A fifth of a second that only who checks a course pays for; it comes with WeasyPrint.
    from fontTools.ttLib import TTFont  # noqa: PLC0415

    ffi, harfbuzz = library.ffi, library.harfbuzz
    font = _loaded(library, family)
    if font is None:
        return False
    face = harfbuzz.hb_font_get_face(library.pango.pango_font_get_hb_font(font))
    blob = ffi.gc(harfbuzz.hb_face_reference_blob(face), harfbuzz.hb_blob_destroy)
    length = ffi.new("unsigned int *")
    data = harfbuzz.hb_blob_get_data(blob, length)
    file = TTFont(BytesIO(ffi.unpack(data, int(length[0]))), fontNumber=0, lazy=True)
    return all(ord(letter) in file.getBestCmap() for letter in _GREEK)


def _loaded(library: Any, family: str) -> Any:  # noqa: ANN401 - WeasyPrint ships no types
    """Return the font that Pango takes for a family; None where the machine has none at all."""
    ffi, pango, gobject = library.ffi, library.pango, library.gobject
    fonts = ffi.gc(library.pangoft2.pango_ft2_font_map_new(), gobject.g_object_unref)
    context = ffi.gc(pango.pango_font_map_create_context(fonts), gobject.g_object_unref)
    free = pango.pango_font_description_free
    wanted = ffi.gc(pango.pango_font_description_new(), free)
    pango.pango_font_description_set_family(wanted, family.encode())
    loaded = pango.pango_font_map_load_font(fonts, context, wanted)
    # The map goes before the font otherwise.
    return None if loaded == ffi.NULL else ffi.gc(loaded, lambda one: _unref(gobject, one, fonts))


def _unref(gobject: Any, font: Any, _fonts: Any) -> None:  # noqa: ANN401 - as above
    gobject.g_object_unref(font)
