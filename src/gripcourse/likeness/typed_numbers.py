"""The numbers that a student typed, side by side: an object for each takes ten times the time."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.cells import Floats
from gripcourse.slips.model import SlipId

_BETWEEN: Final = " "  # no id has one


@dataclass(frozen=True, slots=True)
class Typed:
    """One number that a student typed.

    Attributes:
        quantity: id.
        value: in the declared unit.
        half_unit: half a unit of the last typed digit, likewise; 0 for a computed number.
        explained: whether it is right, or follows from the student's own numbers.
        slip: the wrong method that explains it otherwise; None for none.
    """

    quantity: str
    value: float
    half_unit: float
    explained: bool
    slip: SlipId | None


@dataclass(frozen=True, slots=True)
class TypedNumbers:
    """Numbers of one work.

    Attributes:
        names: ids of the quantities, with blanks between them.
        packed: values, then half units, of eight bytes each.
        told: of each a byte; whether it is right, or follows from the student's own numbers.
        slips: the wrong methods that explain some of them otherwise, by place.
    """

    names: str
    packed: bytes
    told: bytes
    slips: Mapping[int, SlipId]

    @classmethod
    def of(cls, numbers: Iterable[Typed]) -> "TypedNumbers":
        """Lay numbers side by side."""
        listed = tuple(numbers)
        reals = [*(one.value for one in listed), *(one.half_unit for one in listed)]
        return cls(
            names=_BETWEEN.join(one.quantity for one in listed),
            packed=np.array(reals, dtype=np.float64).tobytes(),
            told=bytes(one.explained for one in listed),
            slips={place: one.slip for place, one in enumerate(listed) if one.slip},
        )

    def __reduce__(self) -> "tuple[type[TypedNumbers], tuple[object, ...]]":
        # Half the time that dataclasses take of themselves.
        return TypedNumbers, (self.names, self.packed, self.told, self.slips)

    def __len__(self) -> int:
        return len(self.told)

    def __iter__(self) -> Iterator[Typed]:
        columns = (self.quantities, self.values.tolist(), self.half_units.tolist(), self.told)
        for place, (name, value, half, told) in enumerate(zip(*columns, strict=True)):
            yield Typed(name, value, half, bool(told), self.slips.get(place))

    def and_more(self, numbers: Iterable[Typed]) -> "TypedNumbers":
        """Return these with some more at their end; themselves where there are none."""
        more = tuple(numbers)
        return TypedNumbers.of((*self, *more)) if more else self

    @property
    def quantities(self) -> tuple[str, ...]:
        """The id of the quantity of each."""
        return tuple(self.names.split())

    @property
    def values(self) -> Floats:
        """The numbers, in declared units."""
        return np.frombuffer(self.packed, np.float64, len(self))

    @property
    def half_units(self) -> Floats:
        """Half a unit of the last typed digit of each, in declared units."""
        return np.frombuffer(self.packed)[len(self) :]

    @property
    def explained(self) -> NDArray[np.bool_]:
        """Whether each is right, or follows from the student's own numbers."""
        return np.frombuffer(self.told, np.bool_)
