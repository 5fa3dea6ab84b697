"""Quantities that are called the same but for the end of the range that they are of."""

from collections.abc import Iterator

from gripcourse.policy.slips import GenericSlip


def other_ends(name: str, slip: GenericSlip) -> Iterator[str]:
    """Yield the ids that are a name with its ending changed for the other of a pair."""
    for pair in slip.pairs:
        for one, another in (pair, pair[::-1]):
            other = name.removesuffix(one) + another
            if name.endswith(one) and other != name:
                yield other
