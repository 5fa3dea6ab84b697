"""What every job of a batch needs, sent to a worker as bytes and unpacked there only once.

A course takes longer to send as an object, and to put together again, than a workbook to read.
"""

import pickle
from functools import lru_cache
from typing import Any


def pack(value: object) -> bytes:
    """Make bytes of a value, once for all jobs."""
    return pickle.dumps(value)


@lru_cache(maxsize=1)
def unpack(packed: bytes) -> Any:  # noqa: ANN401 (whatever was packed)
    """Return the value again; the last one is remembered."""
    return pickle.loads(packed)  # noqa: S301 (packed by the process that started this one)
