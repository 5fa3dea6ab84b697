"""A test that looks at many things; each that fails is a subtest that bears its name."""

import inspect
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import wraps
from typing import Any

import pytest

Test = Callable[..., None]


@contextmanager
def named_if_it_fails(subtests: pytest.Subtests, **names: object) -> Iterator[None]:
    """Tell of one of many things only where something is wrong with it, then as a subtest.

    What passes would be told too, thousands of times, by each process to the one that listens.
    """
    try:
        yield
    except (Exception, pytest.fail.Exception, pytest.skip.Exception):
        with subtests.test(**names):
            raise


def each(many: str, one: str) -> Callable[[Test], Test]:
    """Let a test of one thing look at each of those that a fixture has.

    A test of its own for each would take much longer than most statements.

    Args:
        many: name of the fixture.
        one: name of the test's argument that takes them one after the other.
    """

    def decorate(test: Test) -> Test:
        asked = inspect.signature(test)
        own = [parameter for parameter in asked.parameters.values() if parameter.name != one]
        kind = inspect.Parameter.KEYWORD_ONLY
        more = [inspect.Parameter(name, kind) for name in (many, "subtests")]

        @wraps(test)
        def look_at_each(**fixtures: Any) -> None:  # noqa: ANN401 (whatever the fixtures are)
            things: Iterable[object] = fixtures.pop(many)
            subtests: pytest.Subtests = fixtures.pop("subtests")
            for thing in things:
                with named_if_it_fails(subtests, **{one: str(getattr(thing, "name", thing))}):
                    test(**{one: thing}, **fixtures)

        # What pytest asks for fixtures by.
        look_at_each.__signature__ = asked.replace(parameters=[*own, *more])  # type: ignore[attr-defined]
        return look_at_each

    return decorate
