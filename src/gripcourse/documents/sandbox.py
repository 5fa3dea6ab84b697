"""What a template may do: show the values that it gets, with loops, macros and filters; no more.

A course may be a stranger's, and `validate` fills its templates. Jinja's own sandbox closes the
way to Python's inside; here, in addition, only what is listed can be called, so that no method of
a value, however it came there, is a way to a file.
"""

import re
from collections.abc import Callable, Hashable, Mapping, Sequence
from datetime import date
from types import BuiltinMethodType, FunctionType, MethodType
from typing import Final

from jinja2 import sandbox
from jinja2.runtime import BlockReference, LoopContext, Macro, TemplateReference
from jinja2.utils import Cycler, Joiner, Namespace

_MOST_REPEATED: Final = 10_000
# What makes a text as wide as a number says: a gigabyte of blanks out of ten signs.
_WIDENING: Final = frozenset({"center", "expandtabs", "ljust", "replace", "rjust", "zfill"})
WIDENING_FILTERS: Final = ("center", "format", "indent", "replace", "wordwrap")
_WIDE_PLACE: Final = re.compile(r"\{[^{}]*:[^{}]*(?:\d{4}|\{)")
_PLAIN: Final = (str, int, float, list, tuple, dict, date, LoopContext, Cycler, Joiner)
_MADE_BY_TEMPLATES: Final = (Macro, BlockReference, LoopContext, TemplateReference, Namespace)


class TemplateSandbox(sandbox.ImmutableSandboxedEnvironment):
    """The environment of all templates; the library wants its rules as methods of a subclass."""

    intercepted_binops = frozenset({"*", "**", "%"})

    def is_safe_callable(self, obj: object) -> bool:
        """Whether a template may call something."""
        if not super().is_safe_callable(obj):
            return False
        if isinstance(obj, _MADE_BY_TEMPLATES):
            return True
        if isinstance(obj, BuiltinMethodType | MethodType):
            if isinstance(obj.__self__, str) and obj.__name__ in _WIDENING:
                return False
            return isinstance(obj.__self__, _PLAIN) or self._is_offered(obj)
        # What the library puts in the place of `format`, so that it reaches no inside either.
        is_format = isinstance(obj, FunctionType) and obj.__globals__ is vars(sandbox)
        return is_format or self._is_offered(obj)

    def wrap_str_format(self, value: object) -> Callable[..., str] | None:
        """Return what stands for the method `format` of a text; no place may be very wide."""
        wrapped = super().wrap_str_format(value)
        if wrapped is not None and _WIDE_PLACE.search(str(getattr(value, "__self__", ""))):
            raise OverflowError("a place of this text is too wide")
        return wrapped

    def call_binop(self, context: object, operator: str, left: object, right: object) -> object:
        """Multiply; but a text or a list is not repeated until the memory is full."""
        for repeated, times in ((left, right), (right, left)):
            if isinstance(repeated, Sequence) and (
                not isinstance(times, int) or times > _MOST_REPEATED
            ):
                raise OverflowError(f"{times!r} times is too often")
        if operator == "%" and isinstance(left, str):
            raise OverflowError("a text is filled in by its method format")
        if operator == "**":
            return float(left) ** float(right)  # type: ignore[arg-type]
        return super().call_binop(context, operator, left, right)  # type: ignore[arg-type]

    def _is_offered(self, obj: object) -> bool:
        offered: Mapping[str, object] = self.globals
        return isinstance(obj, Hashable) and any(obj == one for one in offered.values())
