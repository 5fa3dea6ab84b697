"""The reference course, loaded once, and how property tests run."""

import gc
import os
import re
import subprocess
from collections.abc import Callable, Generator
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis.strategies import booleans
from xdist.workermanage import WorkerController

from gripcourse.course.load import load_course
from gripcourse.course.model import Course, WorkedExample
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan, make_plan
from support.by_folder import (
    ByFolder,
    dear_first,
    is_shared,
    one_before_the_others,
    tell_whether_fresh,
)
from support.classroom import classroom, issued
from support.databases import postgresql_server

REPOSITORY = Path(__file__).parents[1]
SCHEME = "rack_parallelogram"

# How long an example takes says something about the machine, nothing about the code.
settings.register_profile("gripcourse", deadline=None)
# The same examples each time, where runs are compared.
settings.register_profile("comparable", deadline=None, derandomize=True)
settings.load_profile("gripcourse")


# Programs that tests start import numpy in two thirds of the time: see `calculate_in_one_thread`.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


# Objects that are made before young, then middle-aged, then all objects are searched for garbage.
# What is loaded and collected lives on anyway: searching it took a sixth of the time of all tests.
gc.set_threshold(50_000, 20, 20)


def pytest_collection_finish() -> None:
    """Keep what is loaded by now, modules and tests, out of every search for garbage."""
    gc.collect()
    gc.freeze()
    # Hypothesis searches all objects once for its source of chance: now there are few.
    given(booleans())(lambda _: None)()


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish() -> None:
    """Search what the last tests left, not what lived all the time, when everything ends."""
    gc.collect(1)
    gc.freeze()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """Start one process more than there are processors: some tests wait for other programs."""
    return (os.cpu_count() or 1) + 1


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: object) -> ByFolder | None:
    """Give each process whole folders, where files were asked for."""
    return ByFolder(config, log) if config.getoption("dist") == "loadfile" else None


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: WorkerController) -> None:
    """Prepare a process that shares the tests with others."""
    tell_whether_fresh(node)


@pytest.hookimpl(wrapper=True)
def pytest_collection(session: pytest.Session) -> Generator[None, object, object]:
    """Read the tests; in a fresh clone one process before the others."""
    with one_before_the_others(session.config):
        return (yield)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Begin with what takes long, where several processes share the tests."""
    if is_shared(config):
        dear_first(items)


@pytest.fixture(scope="session")
def course() -> Course:
    """The reference course."""
    return load_course(REPOSITORY)


@pytest.fixture(scope="session")
def policy(course: Course) -> Policy:
    """The policy of the reference course."""
    return load_policy(course)


@pytest.fixture(scope="session")
def example(course: Course) -> WorkedExample:
    """The example of the guide, section 5."""
    found = course.schemes[SCHEME].example
    assert found is not None
    return found


@pytest.fixture(scope="session")
def plan(course: Course, example: WorkedExample) -> Plan:
    """The corrected calculation of the worked example."""
    return make_plan(course, SCHEME, example.options)


@pytest.fixture
def few_slips_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Count slips of all kinds in two variants: most of an audit's time, and no rule of it."""
    monkeypatch.setattr("gripcourse.variants.one_by_one.COUNTED", 2)


WORD = re.compile(r"<word ([^>]*)>(.*?)</word>")
EDGE = 12.0  # points, 4.2 mm: what a common printer leaves out


@pytest.fixture(scope="session")
def beyond_the_edge() -> Callable[[bytes], list[str]]:
    """Find the words of a document that do not stand wholly inside its pages."""

    def find(pdf: bytes) -> list[str]:
        command = ["pdftotext", "-bbox", "-", "-"]
        done = subprocess.run(command, input=pdf, capture_output=True, check=True)  # noqa: S603 (poppler)
        text = done.stdout.decode()
        outside = []
        for size, page in re.findall(r"<page (.*?)>(.*?)</page>", text, re.DOTALL):
            width, height = (float(side) for side in re.findall(r'"([\d.]+)"', size))
            for sides, word in WORD.findall(page):
                left, top, right, bottom = map(float, re.findall(r'"([-\d.]+)"', sides))
                nearest = min(left, top, width - right, height - bottom)
                if nearest < EDGE:
                    outside.append(word)
        return outside

    return find
