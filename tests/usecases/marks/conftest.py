"""Marks in databases of either kind, and an office that gives them."""

import shutil
from typing import TYPE_CHECKING

import pytest

from support.databases import either_place
from support.office import Office

if TYPE_CHECKING:
    from pathlib import Path

    from support.classroom import Classroom

place = either_place


@pytest.fixture
def office(issued: "Classroom", tmp_path: "Path", place: str) -> Office:
    return Office(shutil.copytree(issued.course.root, tmp_path / "course"), place)
