"""Which values of a style say all by themselves."""

from typing import Any

_SIMPLE = (str, int, float, type(None))


def is_settled(value: Any) -> bool:  # noqa: ANN401 - whatever a style holds
    """Tell whether a computed value means the same in every style: no sum of sizes, for example."""
    if isinstance(value, tuple):  # a size with its unit is one, too
        return all(is_settled(one) for one in value)
    return isinstance(value, _SIMPLE)
