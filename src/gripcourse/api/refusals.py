"""What the system refuses comes to callers as an error of this library, with place and remedy."""

from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, TypeVar

from gripcourse.errors import SystemRefusedError, system_problem

_Given = ParamSpec("_Given")
_Made = TypeVar("_Made")


def refusals_said(call: Callable[_Given, _Made]) -> Callable[_Given, _Made]:
    """Let a call of the library raise nothing of the system that its caller can correct."""

    @wraps(call)
    def calling(*given: _Given.args, **named: _Given.kwargs) -> _Made:
        try:
            return call(*given, **named)
        except OSError as fault:
            raise SystemRefusedError([system_problem(fault)]) from fault

    return calling
