"""What keys of earlier programs are called now is a key of today, and none of them is one still."""

from collections.abc import Iterator

from gripcourse.course.shape import Key, Shape
from gripcourse.usecases.authoring.schema import FILE_KINDS


def keys_of(shape: Shape) -> list[Key]:
    further = [key for kind in shape.kinds.values() for key in kind.values()]
    return [*shape.keys.values(), *([shape.each] if shape.each else []), *further]


def shapes(shape: Shape) -> Iterator[Shape]:
    """Yield a shape and all that stand inside of it."""
    yield shape
    for key in keys_of(shape):
        if key.inside is not None:
            yield from shapes(key.inside)


EVERY = [one for kind in FILE_KINDS for one in shapes(kind.shape)]


def test_a_former_key_leads_to_a_key_of_today() -> None:
    found = [one for one in EVERY if one.former]
    assert found
    for shape in found:
        assert shape.former.keys().isdisjoint(shape.keys)
        assert {one.now.split(".")[0] for one in shape.former.values() if one.now} <= {*shape.keys}
        assert {name for one in shape.former.values() for name in one.adds} <= {*shape.keys}
    for shape in EVERY:
        for kind, former in shape.former_kinds.items():
            assert former.keys().isdisjoint({*shape.keys, *shape.kinds[kind]})


def test_a_former_word_leads_to_a_word_of_today() -> None:
    found = [key for shape in EVERY for key in keys_of(shape) if key.former]
    assert found
    for key in found:
        assert key.former.keys().isdisjoint(key.words)
        assert {*key.former.values()} <= {*key.words}
