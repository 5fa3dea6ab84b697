"""What a cell may say, in the words of its table: titles in its language, or ids as its author."""

from collections.abc import Iterable, Mapping
from difflib import get_close_matches

from gripcourse.course.model import Course
from gripcourse.text.spelling import plain
from gripcourse.text.words import LANGUAGES, Message, Texts, message
from gripcourse.variants.headings import TableColumn, given_quantities


def language_of(course: Course, columns: Mapping[str, TableColumn]) -> str:
    """Return the language in which the headings of a table are titles; empty where they are ids.

    Args:
        course: whose table it is.
        columns: of the table, by id.
    """
    called = {id_: plain(one.name) for id_, one in columns.items()}
    titles = {id_: one.title for id_, one in given_quantities(course).items()}
    options = (option for scheme in course.schemes.values() for option in scheme.options)
    titles |= {f"option:{option.id}": option.title for option in options}
    own = {id_: name for id_, name in called.items() if id_ in titles}
    counts = {
        "": sum(name.startswith(plain(id_.removeprefix("option:"))) for id_, name in own.items())
    }
    for language in (course.language, *LANGUAGES):
        counts[language] = sum(
            name.startswith(plain(titles[id_].of(language))) for id_, name in own.items()
        )
    return max(counts, key=counts.__getitem__)  # of equal ones the first


def allowed_names(written: str, known: Iterable[tuple[str, Texts]], language: str) -> Message:
    """Say what a cell may say, and which of it was meant, where one is near.

    Args:
        written: what it says.
        known: ids and titles of what may stand there.
        language: of the titles; empty for the ids.
    """
    names = [title.of(language) if language else id_ for id_, title in known]
    small = {plain(name): name for name in names}
    # Titles have commas in them.
    listed = message("Allowed here: {names}.", names="; ".join(names))
    near = get_close_matches(plain(written), small, n=1)
    if not near:
        return listed
    return message("Did you mean '{near}'? {allowed}", near=small[near[0]], allowed=listed)
