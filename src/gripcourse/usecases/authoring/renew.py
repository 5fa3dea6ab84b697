"""Bringing a course that was written for an earlier version up to what the program reads today.

Only keys and words that are called otherwise, or gone, are changed, where they stand: comments,
order and look of a file stay. What a file means is read before and after, and a file is only
written where nothing else of it has changed.
"""

from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import tomli

from gripcourse.course.shape import Former, KeySort, Shape
from gripcourse.course.toml_faults import toml_values
from gripcourse.course.toml_places import KeyPath, KeyPlace, key_places
from gripcourse.errors import CourseError, Problem
from gripcourse.machine.files import write_together
from gripcourse.usecases.authoring.schema import FILE_KINDS

_KEPT: Final = ".former"


@dataclass(frozen=True, slots=True)
class Renaming:
    """A key or a word of a file that is called otherwise now.

    Attributes:
        place: of the key, or of the key whose text is the word.
        former: what became of the key; of a word what is written now.
        is_word: whether it is the text that changes.
    """

    place: KeyPath
    former: Former
    is_word: bool

    @property
    def was(self) -> str:
        """The key as it is called in messages."""
        return _shown(self.place)


@dataclass(frozen=True, slots=True)
class Renewal:
    """A file that is written otherwise now.

    Attributes:
        file: in the course.
        before, text: its whole text as it is, and as it would be.
        renamings: that lie between.
    """

    file: str
    before: str
    text: str
    renamings: tuple[Renaming, ...]


@dataclass(frozen=True, slots=True)
class Renewals:
    """What of a course is called otherwise today.

    Attributes:
        files: as they would be.
        by_hand: files whose names cannot be changed where they stand; their author has to.
    """

    files: tuple[Renewal, ...]
    by_hand: tuple[str, ...]


def renewals(root: Path) -> Renewals:
    """Return what of a course is called otherwise today, and the files as they would be.

    Args:
        root: of the course.

    Raises:
        CourseError: a file is no TOML; with all such files.
    """
    found: list[Renewal] = []
    by_hand: list[str] = []
    problems: list[Problem] = []
    for file, shape in _files(root):
        values = toml_values(root / file, file, problems) or {}
        renamings = tuple(_renamings(shape, values, ()))
        if renamings:
            # As it stands, with the ends of its lines.
            before = (root / file).read_bytes().decode("utf-8")
            made = _renewed(file, before, values, renamings)
            if made is None:
                by_hand.append(file)
            else:
                found.append(made)
    if problems:
        raise CourseError(problems)
    return Renewals(tuple(found), tuple(by_hand))


def write_renewals(root: Path, found: Sequence[Renewal]) -> tuple[Path, ...]:
    """Write files as they would be, all or none; return the copies that were kept beside them."""
    copies = {one.file: _free_name(root / one.file) for one in found}
    texts: dict[Path, list[str | bytes]] = {copies[one.file]: [one.before] for one in found}
    write_together(texts | {root / one.file: [one.text] for one in found})
    return tuple(copies.values())


def _free_name(path: Path) -> Path:
    names = (path.with_name(f"{path.name}{_KEPT}{number or ''}") for number in range(1000))
    return next(one for one in names if not one.exists())


def _files(root: Path) -> Iterator[tuple[str, Shape]]:
    for kind in FILE_KINDS:
        for pattern in kind.places:
            for path in sorted(root.glob(pattern)):
                yield path.relative_to(root).as_posix(), kind.shape


def _renamings(shape: Shape, values: Mapping[str, object], place: KeyPath) -> Iterator[Renaming]:
    """Yield what is called otherwise in a table and in all that stand inside of it."""
    words = {
        name: now
        for name, value in values.items()
        if (key := shape.key(name, values)) is not None
        and isinstance(value, str)
        and (now := key.former.get(value)) is not None
    }
    # The keys of a table depend on its kind, which may be called otherwise itself.
    today = {**values, **words}
    for name, value in values.items():
        here = (*place, name)
        key = shape.key(name, today)
        if name in words:
            yield Renaming(here, Former(words[name]), is_word=True)
        elif key is None:
            former = shape.former_key(name, today)
            if former is not None and not (former.now and _has(values, former.now)):
                yield Renaming(here, former, is_word=False)
        elif key.inside is not None and isinstance(value, Mapping) and key.sort is KeySort.TABLE:
            yield from _renamings(key.inside, value, here)
        elif key.inside is not None and isinstance(value, list):
            for number, one in enumerate(value):
                if isinstance(one, Mapping):
                    yield from _renamings(key.inside, one, (*here, number))


def _has(values: Mapping[str, object], dotted: str) -> bool:
    inside: object = values
    for name in dotted.split("."):
        if not isinstance(inside, Mapping) or name not in inside:
            return False
        inside = inside[name]
    return True


def _renewed(
    file: str, text: str, values: Mapping[str, object], renamings: tuple[Renaming, ...]
) -> Renewal | None:
    """Write a file as it is called now; None where that cannot be done word by word."""
    at: dict[KeyPath, list[KeyPlace]] = {}
    for place in key_places(text):
        at.setdefault(place.path, []).append(place)
    edits = [
        edit
        for one in renamings
        for place in at.get(one.place, [])
        for edit in _edits(one, place, text, values)
    ]
    made = text
    for (start, end), put in sorted(edits, reverse=True):
        made = made[:start] + put + made[end:]
    try:
        is_meant = tomli.loads(made) == _meant(values, renamings)
    except tomli.TOMLDecodeError:
        return None
    return Renewal(file, text, made, renamings) if is_meant else None


def _edits(
    one: Renaming, place: KeyPlace, text: str, values: Mapping[str, object]
) -> Iterator[tuple[tuple[int, int], str]]:
    """Yield what is put where instead of what stands there."""
    if one.is_word:
        if place.value is not None:
            yield place.value, f'"{one.former.now}"'
        return
    if not one.former.now:
        if place.statement is not None:
            yield _whole_lines(place.statement, text), ""
        return
    yield place.span, one.former.now
    if place.statement is not None:
        start = text.rfind("\n", 0, place.statement[0]) + 1
        indent = text[start : place.statement[0]]
        end = _end_of_line(text, place.value[1] if place.value else place.statement[1])
        newline = "\r\n" if "\r\n" in text else "\n"
        for name, word in _added(one, values).items():
            yield (end, end), f'{newline}{indent}{name} = "{word}"'
    elif place.value is not None:
        end = place.value[1]
        for name, word in _added(one, values).items():
            yield (end, end), f', {name} = "{word}"'


def _added(one: Renaming, values: Mapping[str, object]) -> dict[str, str]:
    table = _inside(values, one.place[:-1])
    return {name: word for name, word in one.former.adds.items() if name not in table}


def _whole_lines(statement: tuple[int, int], text: str) -> tuple[int, int]:
    end = text.find("\n", statement[1]) + 1
    return text.rfind("\n", 0, statement[0]) + 1, end or len(text)


def _end_of_line(text: str, at: int) -> int:
    found = text.find("\n", at)
    end = len(text) if found < 0 else found
    return end - 1 if text[at:end].endswith("\r") else end


def _meant(values: Mapping[str, object], renamings: Sequence[Renaming]) -> dict[str, object]:
    """Return what a file says when everything in it is called as it is today."""
    made: dict[str, Any] = deepcopy(dict(values))
    for one in renamings:
        table, name = _inside(made, one.place[:-1]), one.place[-1]
        if one.is_word:
            table[name] = one.former.now
            continue
        for added, word in _added(one, made).items():
            table[added] = word
        value = table.pop(name)
        *path, last = one.former.now.split(".")
        for step in path:
            table = table.setdefault(step, {})
        if last:
            table[last] = value
    return made


def _inside(values: Any, place: KeyPath) -> Any:  # noqa: ANN401 (of a file, of any form)
    for step in place:
        values = values[step]
    return values


def _shown(place: KeyPath) -> str:
    said = "".join(f"[{one + 1}]" if isinstance(one, int) else f".{one}" for one in place)
    return said.removeprefix(".")
