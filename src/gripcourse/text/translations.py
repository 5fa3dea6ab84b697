"""Catalogues of translated sentences: read, and judged before anybody reads a sentence of them.

A sentence whose values got lost in translation, or that asks for one that nobody gives, is left
out: the English sentence with all its values is better than a wrong one.
"""

import gettext
import io
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from string import Formatter
from typing import TYPE_CHECKING, Literal

# Babel costs 60 ms to import: only a reader of another language pays for it.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable

    from babel.messages.catalog import Catalog

Kind = Literal["unreadable", "empty", "plural", "lost", "invented", "braces"]


@dataclass(frozen=True, slots=True)
class TranslationFault:
    """Something wrong with a catalogue.

    Attributes:
        kind: `unreadable`, `empty` or `plural` for the catalogue; for one sentence, places `lost`,
            places `invented`, or `braces` that do not close.
        line: where the sentence stands, 0 for the whole catalogue.
        detail: the places that differ, or what the library says.
    """

    kind: Kind
    line: int
    detail: str


_EMPTY = TranslationFault("empty", 0, "")


@dataclass(frozen=True, slots=True)
class Translations:
    """A catalogue without the sentences that cannot be used, and what is wrong with it."""

    catalogue: gettext.NullTranslations
    faults: tuple[TranslationFault, ...]


def catalogue_file(language: str) -> "Traversable":
    """Return the catalogue of a language."""
    return files("gripcourse") / "locale" / f"{language}.po"


def read_translations(source: "Traversable", language: str) -> Translations:
    """Read a catalogue; one that cannot be read at all leaves every sentence in English.

    Args:
        source: a `.po` file.
        language: whose plural forms the catalogue must have.
    """
    try:
        return _parsed(source.read_bytes(), language)
    except OSError as error:
        return _unreadable(error)


# Whoever checks a machine reads what its sentences are printed with.
@lru_cache(maxsize=4)
def _parsed(written: bytes, language: str) -> Translations:
    from babel.messages.mofile import write_mo
    from babel.messages.pofile import PoFileError, read_po

    compiled = io.BytesIO()
    try:
        catalogue = read_po(io.BytesIO(written), locale=language, abort_invalid=True)
        faults = (
            *_plural_faults(catalogue, language),
            *_leave_out(catalogue),
            *(() if any(entry.string for entry in catalogue if entry.id) else (_EMPTY,)),
        )
        write_mo(compiled, catalogue)
        compiled.seek(0)
        return Translations(gettext.GNUTranslations(compiled), faults)
    except (PoFileError, ValueError, LookupError, OSError) as error:
        return _unreadable(error)


def _unreadable(error: Exception) -> Translations:
    fault = TranslationFault("unreadable", 0, str(error).rstrip("."))
    return Translations(gettext.NullTranslations(), (fault,))


def places(text: str) -> frozenset[str] | None:
    """Return the names in braces of a sentence, None where its braces do not close."""
    try:
        return frozenset(name for _, name, _, _ in Formatter().parse(text) if name is not None)
    except ValueError:
        return None


def _leave_out(catalogue: "Catalog") -> Iterator[TranslationFault]:
    """Take the sentences that cannot be used out of a catalogue and name them."""
    for entry in list(catalogue):
        if not entry.id or not entry.string:
            continue
        sentences = (entry.id,) if isinstance(entry.id, str) else entry.id
        wanted = frozenset().union(*(places(one) or frozenset() for one in sentences))
        forms = (entry.string,) if isinstance(entry.string, str) else entry.string
        found = [*_faults(wanted, forms, entry.lineno or 0)]
        if found:
            entry.string = "" if isinstance(entry.id, str) else ("",) * len(forms)
            yield from found


def _faults(wanted: frozenset[str], forms: Sequence[str], line: int) -> Iterator[TranslationFault]:
    for form in forms:
        found = places(form)
        if found is None:
            yield TranslationFault("braces", line, form)
            continue
        if lost := wanted - found:
            yield TranslationFault("lost", line, ", ".join(sorted(lost)))
        if invented := found - wanted:
            yield TranslationFault("invented", line, ", ".join(sorted(invented)))


def _plural_faults(catalogue: "Catalog", language: str) -> Iterator[TranslationFault]:
    """Name a catalogue that counts otherwise than its language."""
    from babel.messages.plurals import get_plural

    usual = get_plural(language)
    if catalogue.num_plurals != usual.num_plurals:
        yield TranslationFault("plural", 0, str(usual))
