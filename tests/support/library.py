"""The library on a course whose assignments were issued once for all tests."""

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import gripcourse as gc

if TYPE_CHECKING:
    from support.classroom import Classroom


@pytest.fixture(scope="session")
def own(issued: "Classroom") -> gc.Course:
    """The course of three students, speaking English."""
    return gc.Course(issued.course, issued.policy, "en")


@pytest.fixture(scope="session")
def table(issued: "Classroom") -> Path:
    """The small table that was issued from."""
    assert isinstance(issued.order.table, Path)
    return issued.order.table
