"""What a student reads of a wrong method: the sentence of its kind with its places filled.

A quantity is introduced by its title and its symbol, and has its symbol alone where a sentence
before has introduced it.
"""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from typing import TypeAlias

from gripcourse.course.column_symbols import column_symbols
from gripcourse.course.model import Catalogue
from gripcourse.course.quantity import Quantity
from gripcourse.formula.plain import text
from gripcourse.formula.tree import Name, Node, names
from gripcourse.formula.typeset import declared_symbol, symbol_box, typeset
from gripcourse.slips.practical import practical_unit
from gripcourse.slips.surroundings import Place
from gripcourse.text.number_text import format_number
from gripcourse.text.units import known, unit_text
from gripcourse.text.words import LANGUAGES, Texts, Words, message

Places: TypeAlias = Mapping[str, Place]


@dataclass(frozen=True, slots=True)
class Hint:
    """A sentence that waits for its places to be filled; few of thousands are ever wanted.

    Attributes:
        sentence: of the kind, with places in braces.
        places: what fills them.
        quantities, catalogues: that the places name.
        practical: whether the result is that of numbers in millimetres, newtons and megapascals,
            which is not the one of SI units.
    """

    sentence: Texts
    places: Places
    quantities: Mapping[str, Quantity]
    catalogues: Mapping[str, Catalogue]
    practical: bool = False

    @property
    def introduced(self) -> frozenset[str]:
        """Ids of the quantities that the sentence calls by their titles."""
        return frozenset(one.id for one in map(self._quantity, self.places.values()) if one)

    def say(self, introduced: Collection[str] = ()) -> Texts:
        """Put the hint into words, after sentences that have introduced quantities."""
        return Texts({one: self._said(introduced, one) for one in LANGUAGES})

    def place(self, name: str) -> Texts:
        """Return what fills a place of the sentence, with a quantity by its symbol alone."""
        place = self.places[name]
        symbols = {one.id for one in self._said_of([place])}
        return Texts({one: self._written(place, symbols, one) for one in LANGUAGES})

    def _said(self, introduced: Collection[str], language: str) -> str:
        places = {
            name: self._written(place, introduced, language) for name, place in self.places.items()
        }
        said = self.sentence.of(language).format(**places)
        units = self._units(language) if self.practical else ""
        if not units:
            return said
        fits = message("This fits numbers in these units: {units}.", units=units)
        return f"{said} {Words(language).say(fits)}"

    def _quantity(self, place: Place) -> Quantity | None:
        """Return the quantity that a place is, by itself or by its name in a formula."""
        match place:
            case Quantity():
                return place
            case Name(name):
                return self.quantities.get(name)
        return None

    def _written(self, place: Place, introduced: Collection[str], language: str) -> str:
        quantity = self._quantity(place)
        if quantity is not None:
            symbol = text(declared_symbol(quantity.symbol.of(language)))
            title = quantity.short_title.of(language)
            return symbol if quantity.id in introduced else f"{title} ({symbol})"
        match place:
            case float():
                return format_number(place, language)
            case tuple():
                return "; ".join(format_number(one, language) for one in place)
            case str():
                return unit_text(place, language) if place and known(place) else place or "1"
            case Quantity():
                return place.id
        return self._formula(place, language)

    def _formula(self, node: Node, language: str) -> str:
        symbols = {
            name: symbol_box(self.quantities[name].symbol.of(language))
            for name in names(node)
            if name in self.quantities
        }
        columns = column_symbols(node, None, self.quantities, self.catalogues, language)
        return text(typeset(node, symbols | columns, language))

    def _units(self, language: str) -> str:
        """Name the units of what the places say, as far as they are not those of SI."""
        symbols: dict[str, list[str]] = {}
        for one in self._said_of(self.places.values()):
            unit = practical_unit(one.unit)
            if unit is not None:
                symbol = text(declared_symbol(one.symbol.of(language)))
                symbols.setdefault(unit_text(unit, language), []).append(symbol)
        return "; ".join(f"{', '.join(some)} ({unit})" for unit, some in symbols.items())

    def _said_of(self, places: Iterable[Place]) -> list[Quantity]:
        """Return the quantities that places name, each once, in their order."""
        found: dict[str, Quantity] = {}
        for place in places:
            match place:
                case Quantity():
                    found[place.id] = place
                case float() | tuple() | str():
                    pass
                case _:
                    found |= {
                        name: self.quantities[name]
                        for name in names(place)
                        if name in self.quantities
                    }
        return list(found.values())
