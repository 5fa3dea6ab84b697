"""What keys of earlier programs are called now is a key of today, and none of them is one still."""

from collections.abc import Iterator

from gripcourse.course.shape import Key, Shape
from gripcourse.usecases.authoring.schema import FILE_KINDS


def shapes(shape: Shape) -> Iterator[Shape]:
    """Yield a shape and all that stand inside of it."""
    yield shape
    keys: list[Key] = [*shape.keys.values(), *([shape.each] if shape.each else [])]
    keys += [key for kind in shape.kinds.values() for key in kind.values()]
    for key in keys:
        if key.inside is not None:
            yield from shapes(key.inside)


def test_a_former_key_leads_to_a_key_of_today() -> None:
    found = [one for kind in FILE_KINDS for one in shapes(kind.shape) if one.former]
    assert found
    for shape in found:
        assert shape.former.keys().isdisjoint(shape.keys)
        assert {now for now in shape.former.values() if now} <= shape.keys.keys()
