"""What to do about a name that a drawing uses and its scheme does not have."""

from collections.abc import Iterable

from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message


def unknown_name(
    what: Message, name: str, known: Iterable[str], scheme: str, *, is_shared: bool
) -> tuple[Message, Message]:
    """Return what is wrong and how to correct it.

    Args:
        what: the fault in a sentence.
        name: that is not known.
        known: the names that the scheme has.
        scheme: id of the scheme that the drawing is made for.
        is_shared: whether the name stands in a file that several schemes share; such a file may
            use only what each of them has.
    """
    near = did_you_mean(name, known)
    if not is_shared:
        return what, near
    return (
        message("{what} The scheme '{scheme}' uses this shared file.", what=what, scheme=scheme),
        message(
            "{near} A shared drawing may use only what every scheme that takes it has: give the"
            " scheme '{scheme}' this name, or move what uses it into the drawings of the schemes"
            " that have it.",
            near=near,
            scheme=scheme,
        ),
    )
