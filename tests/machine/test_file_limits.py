"""The system may cut files: what it would cut is refused before."""

import errno

import pytest

from gripcourse.machine.file_limits import demand_file_of, largest_file

resource = pytest.importorskip("resource")


def test_what_would_be_cut_is_refused_and_nothing_else(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(resource, "getrlimit", lambda _: (1000, resource.RLIM_INFINITY))
    assert largest_file() == 1000
    demand_file_of(1000)
    with pytest.raises(OSError) as refused:  # noqa: PT011 (its number is looked at)
        demand_file_of(1001)
    assert refused.value.errno == errno.EFBIG


def test_without_a_limit_nothing_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(resource, "getrlimit", lambda _: (resource.RLIM_INFINITY,) * 2)
    assert largest_file() is None
    demand_file_of(10**15)
