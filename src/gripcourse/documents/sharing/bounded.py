"""Memories that forget."""

from collections.abc import Hashable
from typing import Generic, TypeVar

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")


class Bounded(Generic[Key, Value]):
    """Values by key, never more than a number of them.

    There are a young and an old half. What is put or asked for is young; when the young half is
    full, it becomes the old one, and what was old until then is forgotten.
    """

    def __init__(self, most: int) -> None:
        self._half = max(most // 2, 1)
        self._young: dict[Key, Value] = {}
        self._old: dict[Key, Value] = {}

    def __len__(self) -> int:
        return len(self._young) + len(self._old)

    def get(self, key: Key) -> Value | None:
        """Return what was put under a key, None for nothing or where it was forgotten."""
        found = self._young.get(key)
        if found is None:
            found = self._old.pop(key, None)
            if found is not None:
                self.put(key, found)
        return found

    def put(self, key: Key, value: Value) -> None:
        """Keep a value, which is not None, for as long as there is room."""
        if len(self._young) >= self._half:
            self._old, self._young = self._young, {}
        self._young[key] = value
