"""What variants are called, and what a spreadsheet program makes of it."""

from collections.abc import Sequence

from gripcourse.variants.model import Variant


def without_leading_zeros(name: str) -> str:
    """Return a name as a spreadsheet program saves it: of a whole number the leading zeros go."""
    return name.lstrip("0") or "0" if name.isdecimal() else name


def find_variant(variants: Sequence[Variant], written: str) -> Variant | None:
    """Find a variant by its name; `7` finds `007` where it is the only one it can mean.

    A spreadsheet program that saves a roster or a table cuts zeros off.
    """
    exact = [variant for variant in variants if variant.id == written]
    meant = without_leading_zeros(written)
    loose = [variant for variant in variants if without_leading_zeros(variant.id) == meant]
    found = exact or loose
    return found[0] if len(found) == 1 else None
