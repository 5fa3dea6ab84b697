"""What is computed alike: a scheme with one choice of each of its options."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self


@dataclass(frozen=True, slots=True, order=True)
class Composition:
    """A scheme and what a variant chooses, in an order of its own: a key of caches and groups.

    Attributes:
        scheme: id of the scheme.
        choices: ids of each option and of what is chosen, sorted by option.
    """

    scheme: str
    choices: tuple[tuple[str, str], ...]

    @classmethod
    def of(cls, scheme: str, options: Mapping[str, str]) -> Self:
        """Make one of loose values, in whatever order they are."""
        return cls(scheme, tuple(sorted(options.items())))

    @property
    def options(self) -> dict[str, str]:
        """What is chosen, by the id of the option."""
        return dict(self.choices)
