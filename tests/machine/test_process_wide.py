"""What is changed for the whole process for a moment is put back, whatever happens meanwhile."""

import gc
import logging
import os
import threading
import warnings
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from ctypes import util

import pytest

from gripcourse.machine.process_wide import (
    DATE_VARIABLE,
    few_collections,
    libraries_by_full_name,
    strange_date,
    without_advice,
    without_strange_date,
    without_warnings,
)

Change = Callable[[], AbstractContextManager[None]]
BOTH = (few_collections, without_warnings)
ALL = (*BOTH, libraries_by_full_name)


@pytest.fixture(autouse=True)
def usual_collections() -> Iterator[None]:
    """Garbage is collected as in a fresh process, whatever ran in this one before."""
    before = gc.get_threshold()
    gc.set_threshold(700, 10, 10)
    yield
    gc.set_threshold(*before)


def settings() -> tuple[object, ...]:
    return gc.get_threshold(), tuple(warnings.filters), util.find_library


def fail_inside(changed: Change) -> None:
    with changed():
        raise ArithmeticError


@pytest.mark.parametrize("changed", ALL)
def test_it_is_put_back_after_a_failure(changed: Change) -> None:
    before = settings()
    with pytest.raises(ArithmeticError):
        fail_inside(changed)
    assert settings() == before


def test_two_threads_do_not_put_back_each_others_warnings() -> None:
    before, inside, leave = settings(), threading.Event(), threading.Event()

    def first() -> None:
        with without_warnings():
            inside.set()
            leave.wait(10)

    def second() -> None:
        inside.wait(10)
        with without_warnings():
            pass

    threads = [threading.Thread(target=one) for one in (first, second)]
    for one in threads:
        one.start()
    inside.wait(10)
    threads[1].join(0.05)
    assert threads[1].is_alive()  # it waits for the first
    leave.set()
    for one in threads:
        one.join(10)
    assert settings() == before


def test_who_wants_few_collections_waits_for_nobody_and_the_last_one_puts_it_back() -> None:
    before, inside, leave = settings(), threading.Event(), threading.Event()

    def other() -> None:
        with few_collections():
            inside.set()
            leave.wait(10)

    thread = threading.Thread(target=other)
    with few_collections():
        changed = settings()
        thread.start()
        assert inside.wait(10)
    assert before != changed == settings()
    leave.set()
    thread.join(10)
    assert settings() == before


def test_a_warning_inside_is_not_heard() -> None:
    with without_warnings():
        warnings.warn("never heard", stacklevel=1)


@pytest.mark.parametrize("date", ["abc", "", "-5", "1e9", "9" * 12])
def test_a_date_that_is_none_is_away_meanwhile_and_put_back(
    monkeypatch: pytest.MonkeyPatch, date: str
) -> None:
    monkeypatch.setenv(DATE_VARIABLE, date)
    assert strange_date() == date
    with without_strange_date(), without_strange_date():
        assert DATE_VARIABLE not in os.environ
    assert os.environ[DATE_VARIABLE] == date


def test_a_date_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(DATE_VARIABLE, "1700000000")
    assert strange_date() is None
    with without_strange_date():
        assert os.environ[DATE_VARIABLE] == "1700000000"


def test_advice_of_a_library_inside_is_not_heard_and_its_errors_are(
    caplog: pytest.LogCaptureFixture,
) -> None:
    log = logging.getLogger("some_library.part")
    with without_advice("some_library"):
        log.warning("set a variable")
        log.error("failed")
    log.warning("heard again")
    assert caplog.messages == ["failed", "heard again"]
