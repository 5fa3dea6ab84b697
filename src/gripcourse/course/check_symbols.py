"""Checking symbols: in an assignment each stands for one quantity, in every language."""

from collections.abc import Iterator, Mapping

from gripcourse.course.model import Scheme
from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.text.words import LANGUAGES, message


def check_symbols(
    scheme: Scheme, quantities: Mapping[str, Quantity], told: set[object]
) -> Iterator[Problem]:
    """Yield every symbol that two quantities share; `told` are those of earlier compositions."""
    doubled: dict[tuple[str, str, str], list[str]] = {}
    for language in LANGUAGES:
        seen: dict[str, str] = {}
        for one in quantities.values():
            symbol = one.symbol.of(language)
            if symbol and symbol in seen:
                doubled.setdefault((one.id, seen[symbol], symbol), []).append(language)
            seen[symbol] = one.id
    for (name, other, symbol), languages in doubled.items():
        if (name, other, symbol, *languages) in told:
            continue
        told.add((name, other, symbol, *languages))
        yield Problem(
            quantities[name].file,
            f"quantity.{name}.symbol",
            message(
                "'{symbol}' ({language}) is the symbol of {other} too, in {scheme}.",
                symbol=symbol,
                language=", ".join(languages),
                other=other,
                scheme=scheme.id,
            ),
            message("Give each quantity a symbol of its own."),
        )
