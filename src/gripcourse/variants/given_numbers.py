"""Given numbers of many variants in little room: those of one kind share the names."""

from array import array
from collections.abc import Iterable, Iterator, Mapping

_Names = tuple[str, ...]


class GivenNumbers(Mapping[str, float]):
    """Numbers by name, in the order in which they were given; it stands where a `dict` would.

    A `dict` of thirty floats takes 1500 bytes, this takes 400.
    """

    __slots__ = ("_places", "_values")

    def __init__(self, places: Mapping[str, int], values: "array[float]") -> None:
        """Make it of numbers and of the place of each; see `SharedNames`."""
        self._places = places
        self._values = values

    @classmethod
    def of(cls, places: Mapping[str, int], packed: bytes) -> "GivenNumbers":
        """Make it of the place of each number and of what `packed` returned."""
        values = array("d")
        values.frombytes(packed)
        return cls(places, values)

    @property
    def places(self) -> Mapping[str, int]:
        """The place of each number among the values."""
        return self._places

    def packed(self) -> bytes:
        """Return the values alone, as bytes of this machine."""
        return self._values.tobytes()

    def __getitem__(self, name: str) -> float:
        return self._values[self._places[name]]

    def __contains__(self, name: object) -> bool:
        return name in self._places

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._places)

    def __eq__(self, other: object) -> bool:
        # Every report of a batch is compared with what was issued.
        return isinstance(other, Mapping) and self._plain() == dict(other.items())

    __hash__ = None  # type: ignore[assignment] # as any mapping

    def __repr__(self) -> str:
        return repr(self._plain())

    def _plain(self) -> dict[str, float]:
        return dict(zip(self._places, self._values, strict=True))

    def __reduce__(self) -> tuple[object, ...]:
        return GivenNumbers.of, (self._places, self.packed())


class SharedNames:
    """What variants of one kind have in common, held once."""

    __slots__ = ("_known",)

    def __init__(self) -> None:
        self._known: dict[_Names, Mapping[str, int]] = {}

    def numbers(self, pairs: Iterable[tuple[str, float]]) -> GivenNumbers:
        """Return numbers by name; of several of one name the last counts."""
        given = dict(pairs)
        names = tuple(given)
        if names not in self._known:
            self._known[names] = {name: place for place, name in enumerate(names)}
        return GivenNumbers(self._known[names], array("d", given.values()))
