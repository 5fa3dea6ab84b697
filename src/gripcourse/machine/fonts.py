"""The fonts of this machine, asked for the way a document asks for them.

Whoever asks for a font that is not there silently gets another one, or none.
"""

from collections.abc import Iterable
from contextlib import redirect_stdout
from io import StringIO
from typing import Any

from gripcourse.machine.process_wide import without_warnings
from gripcourse.text.words import Message, message

# The families that the style sheets name, each with the Debian package that brings it.
FONT_PACKAGES = {
    "PT Serif": "fonts-paratype",
    "PT Sans": "fonts-paratype",
    "DejaVu Serif": "fonts-dejavu-core",
    "DejaVu Sans": "fonts-dejavu-core",
}


def fonts_used(families: Iterable[str]) -> dict[str, str]:
    """Return for each family the one that a document really gets; nothing without Pango.

    The family is empty where the machine has no font at all.
    """
    library = load_pango()[1]
    return {one: _family_used(library, one) for one in families} if library else {}


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
        with without_warnings(), redirect_stdout(StringIO()):
            # 450 ms that no other command should pay for.
            from weasyprint.text import ffi  # noqa: PLC0415
    except OSError as error:
        return str(error), None
    return "", ffi


def _family_used(library: Any, family: str) -> str:  # noqa: ANN401 - WeasyPrint ships no types
    """Ask Pango which font family a document gets that asks for `family`; empty for none at all."""
    ffi, pango, gobject = library.ffi, library.pango, library.gobject
    fonts = ffi.gc(library.pangoft2.pango_ft2_font_map_new(), gobject.g_object_unref)
    context = ffi.gc(pango.pango_font_map_create_context(fonts), gobject.g_object_unref)
    free = pango.pango_font_description_free
    wanted = ffi.gc(pango.pango_font_description_new(), free)
    pango.pango_font_description_set_family(wanted, family.encode())
    loaded = pango.pango_font_map_load_font(fonts, context, wanted)
    if loaded == ffi.NULL:
        return ""
    font = ffi.gc(loaded, gobject.g_object_unref)
    used = ffi.gc(pango.pango_font_describe_with_absolute_size(font), free)
    return str(ffi.string(pango.pango_font_description_get_family(used)).decode())
