"""Names found by their words: whole, or without the patronymic that most platforms do not know."""

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final, Generic, TypeVar

from gripcourse.grading.platforms import words_of

_Key = TypeVar("_Key")
_FEWEST_WORDS: Final = 2  # a first name or a surname alone is many people's


@dataclass(frozen=True, slots=True)
class Names(Generic[_Key]):
    """Names, each with whose it is.

    Attributes:
        words: of each name, in one order and one spelling.
        keys: of the names that have a word.
    """

    words: Mapping[_Key, Sequence[str]]
    keys: Mapping[str, Sequence[_Key]]

    def same(self, name: str) -> list[_Key]:
        """Return whose name has the same words, in any order."""
        words = _words(name)
        return (
            [key for key in self.keys.get(words[0], ()) if self.words[key] == words]
            if words
            else []
        )

    def fitting(self, name: str) -> list[_Key]:
        """Return whose name has the same words but for some that one of both lacks."""
        words = set(_words(name))
        shared = Counter(key for word in words for key in self.keys.get(word, ()))
        return [
            key
            for key, count in shared.items()
            if count >= _FEWEST_WORDS and count == min(len(words), len(set(self.words[key])))
        ]


def names_by_words(names: Mapping[_Key, str]) -> Names[_Key]:
    """Make names ready to be found.

    Args:
        names: each by whose it is.
    """
    words = {key: _words(name) for key, name in names.items()}
    keys = defaultdict[str, list[_Key]](list)
    for key, found in words.items():
        for word in dict.fromkeys(found):
            keys[word].append(key)
    return Names(words, keys)


def _words(name: str) -> list[str]:
    return sorted(words_of(name))
