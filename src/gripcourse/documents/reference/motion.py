"""The kinematics of a scheme: its coordinates as formulas of the drive's coordinate."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

from gripcourse.course.kinematics import Direction, Kinematics
from gripcourse.documents.reference.entry import link_to
from gripcourse.documents.reference.model import Link
from gripcourse.documents.reference.notation import name_box, symbol_of
from gripcourse.documents.reference.occurrence import Content
from gripcourse.formula.boxes import Box
from gripcourse.formula.tree import Formula, names
from gripcourse.formula.typeset import equation, typeset
from gripcourse.text.amounts import amount_text
from gripcourse.text.units import unit_text
from gripcourse.text.words import Words, message

_DIRECTIONS: Final = {
    Direction.GROWS: message("This coordinate grows while the drive works:"),
    Direction.FALLS: message("This coordinate falls while the drive works:"),
}


@dataclass(frozen=True, slots=True)
class JointPlace:
    """A position of the drive: what it is called, and the drive's coordinate there."""

    title: str
    formula: Box


@dataclass(frozen=True, slots=True)
class Ratio:
    """The quantity that is the ratio of efforts at a position, and what describes the position."""

    title: str
    link: Link
    state: tuple[Box, ...]


@dataclass(frozen=True, slots=True)
class Motion:
    """The kinematics, ready to print.

    Attributes:
        drive, unit: the drive's coordinate and its unit.
        coordinates: each as an equation, with its unit.
        places: of the drive.
        output, outputs: the coordinate that the drive moves against the load, None where no ratio
            is declared, and how many of them it moves.
        direction: what the output does while the drive works, in a sentence.
        ratios: of efforts.
        lossless: what is set so that a ratio holds no friction.
        points: joints with the coordinates along and across the axis.
    """

    drive: Box
    unit: str
    coordinates: tuple[tuple[Box, str], ...]
    places: tuple[JointPlace, ...]
    output: Box | None
    outputs: Box
    direction: str
    ratios: tuple[Ratio, ...]
    lossless: tuple[tuple[Link, str], ...]
    points: tuple[tuple[str, Box, Box], ...]


def motion_of(content: Content, words: Words) -> Motion | None:
    """Put the kinematics of a scheme into boxes; None where it declares none."""
    motion = content.scheme.kinematics
    if motion is None:
        return None
    symbols = _symbols(motion, content, words.language)
    drive = name_box(motion.drive)
    return Motion(
        drive=drive,
        unit=unit_text(motion.unit, words.language),
        coordinates=tuple(
            (
                equation((name_box(one.id), typeset(one.formula.tree, symbols, words.language))),
                unit_text(one.unit, words.language),
            )
            for one in motion.coordinates
        ),
        places=tuple(
            JointPlace(
                _title(position, content, words),
                equation((drive, typeset(formula.tree, symbols, words.language))),
            )
            for position, formula in motion.at.items()
        ),
        output=name_box(motion.output) if motion.output else None,
        direction=words.say(_DIRECTIONS[motion.direction]),
        outputs=typeset(motion.outputs.tree, symbols, words.language),
        ratios=tuple(_ratios(motion, content, words)),
        lossless=tuple(_lossless(motion, content, words)),
        points=tuple(
            (name, name_box(along), name_box(across))
            for name, (along, across) in motion.points.items()
        ),
    )


def _title(position: str, content: Content, words: Words) -> str:
    return content.course.positions[position].title.of(words.language)


def _formulas(motion: Kinematics) -> Iterator[Formula]:
    yield from (one.formula for one in motion.coordinates)
    yield from motion.at.values()
    yield motion.outputs


def _symbols(motion: Kinematics, content: Content, language: str) -> Mapping[str, Box]:
    """Return the symbol of every quantity; a coordinate stands with its name."""
    used = {name for formula in _formulas(motion) for name in names(formula.tree)}
    own = {motion.drive, *(one.id for one in motion.coordinates)}
    return {
        name: name_box(name)
        if name in own
        else symbol_of(content.meant(name)[0].quantity, language)
        for name in used
    }


def _ratios(motion: Kinematics, content: Content, words: Words) -> Iterator[Ratio]:
    for position, name in motion.ratio.items():
        state = (
            equation((symbol_of(content.meant(one)[0].quantity, words.language), name_box(where)))
            for one, where in motion.state.get(position, {}).items()
        )
        link = link_to(content.meant(name)[0], content, words.language)
        yield Ratio(_title(position, content, words), link, tuple(state))


def _lossless(motion: Kinematics, content: Content, words: Words) -> Iterator[tuple[Link, str]]:
    for name, value in motion.lossless.items():
        one = content.meant(name)[0]
        yield link_to(one, content, words.language), amount_text(value, one.quantity.unit, words)
