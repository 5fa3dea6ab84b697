"""What files of a batch are called on a screen: short, and no two of them alike."""

from array import array
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path

from gripcourse.text.shown import one_line


def told_apart(files: Sequence[str]) -> Callable[[str], str]:
    """Return what names a file of a batch: its name, with as many folders as tell it apart."""
    # Of ends of paths, the shortest first, those that several files have; most names are unique.
    several = list[frozenset[int]]()

    def length(parts: Sequence[str]) -> int:
        """Return with how many parts a path is told apart from those that were looked at."""
        ends = (parts[-one:] for one in range(1, len(parts)))
        alone = (hash(end) not in same for end, same in zip(ends, several, strict=False))
        return next((one for one, is_alone in enumerate(alone, 1) if is_alone), len(several) + 1)

    while True:
        found = array("q")
        for file in files:
            parts = Path(file).parts
            if (needed := length(parts)) == len(several) + 1 <= len(parts):
                found.append(hash(parts[-needed:]))
        same = frozenset(hashed for hashed, count in Counter(found).items() if count > 1)
        if not same:
            break
        several.append(same)

    def called(file: str) -> str:
        parts = Path(file).parts or ("",)
        return one_line("/".join(parts[-length(parts) :]))

    return called
