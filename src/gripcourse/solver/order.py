"""Order of calculation: what is needed comes before what needs it."""

from collections.abc import Hashable, Iterable, Mapping
from heapq import heapify, heappop, heappush
from typing import TypeVar

Key = TypeVar("Key", bound=Hashable)


def in_order_of_need(needed: Mapping[Key, Iterable[Key]]) -> list[Key]:
    """Order keys so that each comes after those that it needs.

    Among those that are ready, the one that is declared first comes first.

    Args:
        needed: by key, the keys that it needs; each of them is a key too.

    Returns:
        The keys in order, without those that need each other in a circle or need such ones.
    """
    keys = list(needed)
    rank = {key: place for place, key in enumerate(keys)}
    users: dict[Key, list[Key]] = {key: [] for key in keys}
    missing = dict.fromkeys(keys, 0)
    for key, before in needed.items():
        for one in before:
            users[one].append(key)
            missing[key] += 1
    ready = [rank[key] for key in keys if not missing[key]]
    heapify(ready)
    ordered: list[Key] = []
    while ready:
        key = keys[heappop(ready)]
        ordered.append(key)
        for user in users[key]:
            missing[user] -= 1
            if not missing[user]:
                heappush(ready, rank[user])
    return ordered
