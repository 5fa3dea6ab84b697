"""`import gripcourse` costs nothing until something is asked for."""

import subprocess
import sys

import pytest

import gripcourse


def test_importing_loads_nothing_else() -> None:
    code = (
        "import sys; before = set(sys.modules); import gripcourse; "
        "print(sorted(one for one in set(sys.modules) - before if 'gripcourse' in one "
        "or one.partition('.')[0] not in sys.stdlib_module_names))"
    )
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, check=True)  # noqa: S603 (ours)
    assert done.stdout.strip() == "['gripcourse']"


def test_what_is_offered_is_found_and_listed() -> None:
    from gripcourse import api  # noqa: PLC0415

    for name in api.__all__:
        assert getattr(gripcourse, name) is getattr(api, name)
        assert name in dir(gripcourse)


def test_what_is_not_offered_is_missing_like_anything_else() -> None:
    with pytest.raises(AttributeError, match="no attribute 'Curse'"):
        gripcourse.Curse  # noqa: B018
