"""The picture of a scheme, as its author declares it: which symbols stand at which joints.

`diagram.toml` beside a scheme's declarations lists elements of a vocabulary (`diagram_words`).
An element names joints of the kinematics or points of its own, sizes as formulas, and the quantity
whose symbol is written beside it. How an element looks is the business of `drawing`. Elements that
several schemes share stand in `variants/diagram/`, and use points that each of these schemes names.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from gripcourse.course.diagram_keys import DIAGRAM
from gripcourse.course.diagram_words import MIRRORS, VOCABULARY, Role, Sort
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import Problem
from gripcourse.formula.parse import FormulaFault, caret, formula_of
from gripcourse.formula.tree import Formula
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

FILE = "diagram.toml"
_UNSAID = ""  # the diagram that takes the element decides
_NOTHING = formula_of("0", {})


@dataclass(frozen=True, slots=True)
class Element:
    """One symbol of a diagram.

    Attributes:
        kind: a word of the vocabulary.
        points: names of points by role.
        sizes: formulas by role; a length in SI, an angle, or a plain number.
        words: choices by role.
        quantity: id of the quantity whose symbol is written beside it, empty for none.
        positions: of the drive, at which it is drawn; empty for those that the course shows.
        moves: see `Word.moves`.
        mirror: `none`, `both` (on both sides of the axis) or `only` (on the other side); where the
            author does not say, `both` for the paired elements of a symmetric diagram, else `none`.
        options: it is drawn only where a variant's options are among these.
        file, key: where it stands, for messages.
    """

    kind: str
    points: Mapping[str, tuple[str, ...]]
    sizes: Mapping[str, Formula]
    words: Mapping[str, str]
    quantity: str
    positions: tuple[str, ...]
    moves: bool
    mirror: str
    options: Mapping[str, tuple[str, ...]]
    file: str
    key: str

    def is_drawn(self, options: Mapping[str, str]) -> bool:
        """Tell whether a variant with these options has the element."""
        return all(options.get(name) in among for name, among in self.options.items())


@dataclass(frozen=True, slots=True)
class Diagram:
    """The picture of a scheme.

    Attributes:
        axis: the coordinate that runs along the axis, `x` or `y`.
        points: points that the kinematics does not have: along the axis, across it.
        elements: in the order in which they are drawn.
        nominal: values of quantities in declared units, to which an assignment shows the type of
            the mechanism; what is not among them is as in the worked example.
        file: for messages.
    """

    axis: str
    points: Mapping[str, tuple[Formula, Formula]]
    elements: tuple[Element, ...]
    nominal: Mapping[str, float]
    file: str


def read_diagram(
    folder: Path,
    root: Path,
    symbols: Mapping[str, tuple[Element, ...] | None],
    problems: list[Problem],
) -> Diagram | None:
    """Read the diagram of a scheme, with the elements that it takes from the shared `symbols`.

    None where there is no file, or no readable one.
    """
    path = folder / FILE
    if not path.exists():
        return None
    table = read_toml(path, root, problems, DIAGRAM)
    if table is None:
        return None
    table.known_keys()
    symmetric = table.flag("symmetric")
    shared = [one for name in table.strings("shared") for one in _named(table, name, symbols)]
    points = table.table("point")
    return Diagram(
        axis=_one_of(table, "axis", ("x", "y")),
        points={name: _pair(points, name) for name in points.values} if points else {},
        elements=tuple(
            _on_its_sides(one, symmetric=symmetric) for one in (*_elements(table), *shared)
        ),
        nominal=table.numbers("nominal", {}),
        file=table.file,
    )


def read_elements(table: Table) -> tuple[Element, ...]:
    """Read a file of elements that several diagrams share."""
    table.known_keys()
    return tuple(_elements(table))


def _on_its_sides(element: Element, *, symmetric: bool) -> Element:
    """Say on which sides an element stands of which its author does not."""
    if element.mirror != _UNSAID:
        return element
    both = symmetric and VOCABULARY[element.kind].paired
    return replace(element, mirror="both" if both else "none")


def _named(
    table: Table, name: str, symbols: Mapping[str, tuple[Element, ...] | None]
) -> tuple[Element, ...]:
    if name not in symbols:
        what = message("There is no shared part of a diagram '{name}'.", name=name)
        table.add("shared", what, did_you_mean(name, symbols))
    return symbols.get(name) or ()


def _elements(table: Table) -> Iterator[Element]:
    return (one for one in map(_element, table.tables("element")) if one is not None)


def _element(table: Table) -> Element | None:
    kind = table.text("kind")
    word = VOCABULARY.get(kind)
    if word is None:
        if kind:
            what = message("There is no element '{kind}'.", kind=kind)
            table.unknown_word("kind", what, VOCABULARY)
        return None
    table.known_keys()
    of = {sort: {k: r for k, r in word.roles.items() if r.sort is sort} for sort in Sort}
    sizes = of[Sort.LENGTH] | of[Sort.ANGLE] | of[Sort.NUMBER]
    written = {name: role for name, role in sizes.items() if table.has(name) or _has(role)}
    quantities = [table.text(name, role.default) for name, role in of[Sort.QUANTITY].items()]
    return Element(
        kind=kind,
        points={
            name: (table.text(name),)
            for name, role in of[Sort.POINT].items()
            if table.has(name) or role.default is None
        }
        | {name: _names(table, name) for name in of[Sort.POINTS]},
        sizes={name: _size(table, name, role) for name, role in written.items()},
        words={name: _one_of(table, name, role.words) for name, role in of[Sort.WORD].items()},
        quantity=next(iter(quantities), ""),
        positions=table.strings("positions"),
        moves=word.moves,
        mirror=_one_of(table, "mirror", (_UNSAID, *MIRRORS)),
        options=_options(table),
        file=table.file,
        key=table.key,
    )


def _has(role: Role) -> bool:
    """Tell whether a size that is not written has a value, or should be asked for."""
    return role.default != ""


def _names(table: Table, name: str) -> tuple[str, ...]:
    names = table.strings(name)
    if len(names) < 2 and (not table.has(name) or isinstance(table.values[name], list)):  # noqa: PLR2004 (a line has two ends)
        table.add(
            name,
            message("There are not enough points."),
            message("Name two points at least, in order."),
        )
    return names


def _size(table: Table, name: str, role: Role) -> Formula:
    if not isinstance(table.values.get(name), (int, float)):
        return _formula(table, name, table.text(name, role.default))
    return _formula(table, name, repr(table.values[name]))


def _pair(points: Table, name: str) -> tuple[Formula, Formula]:
    match points.values[name]:
        case [str() as along, str() as across]:
            return _formula(points, name, along), _formula(points, name, across)
    points.add(
        name,
        message("The value has the wrong type."),
        message("Write two formulas, along the axis and across it: ['pin_x', 'pin_y/2']."),
    )
    return _NOTHING, _NOTHING


def _formula(table: Table, name: str, text: str) -> Formula:
    if not text:
        return _NOTHING
    try:
        return formula_of(text, {})
    except FormulaFault as fault:
        table.add(name, fault.what, message("Correct the formula."), caret(text, fault.span))
        return _NOTHING


def _one_of(table: Table, name: str, words: tuple[str, ...]) -> str:
    """Read a choice; the first word where nothing is written."""
    written = table.text(name, words[0])
    if written not in words:
        what = message("'{word}' means nothing here.", word=written)
        table.add(name, what, did_you_mean(written, words))
        return words[0]
    return written


def _options(table: Table) -> dict[str, tuple[str, ...]]:
    wanted = table.table("options")
    return {name: wanted.strings(name) for name in wanted.values} if wanted else {}
