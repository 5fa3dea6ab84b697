"""Sentences in the reader's language: gettext catalogues read through Babel.

A sentence is a `Message`: an English template and its values. It is made where something happens
and put into words only where a person reads it, so that no module but the last needs to know a
language.
"""

import gettext
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache

from gripcourse.text.conventions import is_english
from gripcourse.text.number_text import format_number
from gripcourse.text.shown import one_line
from gripcourse.text.translations import catalogue_file, read_translations

LANGUAGES = ("en", "ru", "uk")


@dataclass(frozen=True, slots=True)
class Message:
    """A sentence that has not been put into words yet.

    Attributes:
        text: the English sentence with `{named}` places; it is the key of the catalogues too.
        values: what stands in the places: text, numbers, other messages or `Texts`.
        many: the same sentence for any number but one, where its form goes with a number; else
            empty. The number is the value `count`.
    """

    text: str
    values: Mapping[str, object] = field(default_factory=dict)
    many: str = ""

    def __reduce__(self) -> "tuple[type[Message], tuple[str, Mapping[str, object], str]]":
        # Half the time that dataclasses take of themselves; a batch unpacks millions.
        return Message, (self.text, self.values, self.many)

    def __str__(self) -> str:
        """The sentence in English."""
        return Words("en").say(self)


@dataclass(frozen=True, slots=True)
class Texts:
    """One text of the course in each language, for example a quantity's title."""

    by_language: Mapping[str, str]

    def of(self, language: str) -> str:
        """Return the text in `language`; a course that passed its check has all of them."""
        return self.by_language[language]


def message(text: str, /, **values: object) -> Message:
    """Make a message; the name that the extractor of catalogues looks for."""
    return Message(text, values)


def counted(one: str, many: str, count: int, /, **values: object) -> Message:
    """Make a message whose form goes with a whole number, which stands in the place `{count}`.

    Args:
        one: the English sentence for one.
        many: the same for any other number.
        count: the number.
        **values: what stands in the other places.
    """
    return Message(one, {**values, "count": count}, many)


@dataclass(frozen=True, slots=True)
class Words:
    """The language that one reader sees."""

    language: str

    def say(self, said: Message) -> str:
        """Put a message into words: translated, numbers written as the language writes them."""
        template = self._form(said) if said.many else self.translate(said.text)
        return template.format(**{name: self._place(v) for name, v in said.values.items()})

    def translate(self, text: str) -> str:
        """Return the translation of a plain English sentence (itself where there is none)."""
        return _catalogue(self.language).gettext(text) if text else ""

    def counted(self, one: str, many: str, count: int) -> str:
        """Return the form of a sentence that goes with a whole number; it is not put in yet.

        Args:
            one: the English sentence for one.
            many: the same for any other number.
            count: the number.
        """
        return _catalogue(self.language).ngettext(one, many, count)

    def declared(self, text: str | None) -> str:
        """Put into words what was declared as plain English elsewhere, as the help of an option."""
        return self.translate(text) if text else ""

    def number(self, value: float, figures: int = 5) -> str:
        """Write a number with so many significant figures, as the language writes it."""
        return format_number(value, self.language, figures)

    def _form(self, said: Message) -> str:
        count = said.values["count"]
        if not isinstance(count, int):
            raise TypeError(count)
        return self.counted(said.text, said.many, count)

    def _place(self, value: object) -> str:
        if isinstance(value, Message):
            return self.say(value)
        if isinstance(value, Texts):
            return value.of(self.language)
        if isinstance(value, float):
            return self.number(value)
        return one_line(str(value))


@lru_cache(maxsize=len(LANGUAGES))
def _catalogue(language: str) -> gettext.NullTranslations:
    """Read `locale/<language>.po`; English is the language of the keys and has no catalogue."""
    if is_english(language):
        return gettext.NullTranslations()
    return read_translations(catalogue_file(language), language).catalogue
