"""Ranges of a course whose declarations are not sound yet: each range is judged by itself."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace

from gripcourse.course.compose import all_part_ids
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.course.toml_table import read_toml
from gripcourse.errors import Problem
from gripcourse.text.units import known
from gripcourse.variants.keys import SPACE
from gripcourse.variants.ranges import RangeReader
from gripcourse.variants.space import offered_choices


def range_problems(course: Course, problems: Collection[Problem]) -> list[Problem]:
    """Return what is wrong with ranges, beside givens and in spaces.

    Args:
        course: as read.
        problems: what was found in it; who is said to be wrong already is passed over.
    """
    found: list[Problem] = []
    told = {(one.file, ".".join(str(one.key).split(".")[:2])) for one in problems}
    offered = offered_choices(course)
    for scheme in course.schemes.values():
        givens = _givens(scheme, course)
        options = {one.id: {each.id for each in one.choices} for one in scheme.options}
        reader = RangeReader(course, givens, options, offered)
        for one in _declared(scheme, course):
            if one.range is not None and (one.file, f"quantity.{one.id}") not in told:
                reader.read(replace(one.range, problems=found), one, is_own=False)
        found += _in_spaces(course, scheme, reader)
    return list({(one.file, str(one.key), str(one.what)): one for one in found}.values())


def _in_spaces(course: Course, scheme: Scheme, reader: RangeReader) -> Iterator[Problem]:
    """Yield the problems of what spaces of a scheme say of givens; of unreadable files, too."""
    for path in sorted((course.root / "variants" / "spaces").glob("*.toml")):
        found: list[Problem] = []
        table = read_toml(path, course.root, found, SPACE, course.languages)
        if table is not None and table.values.get("scheme") == scheme.id:
            for name, written in table.named_tables("given").items():
                if name in reader.givens:
                    reader.read(written, reader.givens[name], is_own=True)
        yield from found


def _declared(scheme: Scheme, course: Course) -> Iterator[Quantity]:
    """Yield the givens of a scheme, with any of its options and as it changes them."""
    parts = (course.parts[one].quantities for one in all_part_ids(scheme) if one in course.parts)
    for quantities in (*parts, scheme.quantities, *scheme.changed):
        for one in quantities.values():
            if one.kind is Kind.GIVEN and known(one.unit):
                yield one


def _givens(scheme: Scheme, course: Course) -> Mapping[str, Quantity]:
    return {one.id: one for one in _declared(scheme, course)}
