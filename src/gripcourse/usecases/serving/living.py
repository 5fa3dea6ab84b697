"""The course of a server: read again where its files are others than they were."""

import logging
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Final, TypeAlias

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.errors import CourseError, GripcourseError, Problem, system_problem
from gripcourse.gradebook.fingerprint import declaring_files, fingerprints, policy_files
from gripcourse.policy.load import load_policy
from gripcourse.text.words import message
from gripcourse.usecases.serving.desk import DeskContext, open_context

_log = logging.getLogger(__name__)

_SECONDS: Final = 1.0
"""So long nobody looks again: nobody edits a file and opens a page faster, visitors come faster."""

_FileState: TypeAlias = tuple[int, int, int, int]
CourseState: TypeAlias = tuple[tuple[Path, _FileState | None], ...]
"""Which files there are, and when and how each was written; nothing is read for it."""


class LivingCourse:
    """A course that is open, as its files say now; safe between threads.

    Where they cannot be used, what they said before goes on, and `faults` says why.
    """

    def __init__(
        self, context: DeskContext, seen: CourseState | None = None, seconds: float = _SECONDS
    ) -> None:
        """Begin with a course that was read.

        Args:
            context: the course, opened.
            seen: its files as they were before it was read; None: they have not changed since.
            seconds: how long nobody looks again.
        """
        self._context = context
        self._seen = state_of(context.course.root) if seen is None else seen
        self._read: tuple[str, str] | None = None  # what the files said, where anybody has asked
        self._faults: tuple[Problem, ...] = ()
        self._lock = threading.Lock()
        self._seconds = seconds
        self._next = time.monotonic()

    @property
    def context(self) -> DeskContext:
        """The course as it was last fit for use."""
        return self._context

    @property
    def faults(self) -> tuple[Problem, ...]:
        """What is wrong with its files as they are now; nothing where they can be used."""
        return self._faults

    @property
    def is_due(self) -> bool:
        """Whether somebody should look at its files again."""
        return time.monotonic() >= self._next

    def look(self, renewed: Callable[[DeskContext], None]) -> None:
        """Read the course again where its files are others; who comes meanwhile waits for it.

        Args:
            renewed: called with what counts from now on, before anybody else sees it.
        """
        with self._lock:
            if not self.is_due:
                return
            try:
                seen = state_of(self._context.course.root)
                if seen != self._seen:
                    # Before it is read: what changes meanwhile is seen the next time.
                    self._seen = seen
                    self._read_again(renewed)
            finally:
                self._next = time.monotonic() + self._seconds

    def _read_again(self, renewed: Callable[[DeskContext], None]) -> None:
        root = self._context.course.root
        try:
            said = fingerprints(root)
            if (said.course, said.policy) != self._read:
                course = load_course(root)
                _see_same_course(self._context.course, course)
                context = replace(self._context, course=course, policy=load_policy(course))
                renewed(context)
                self._context, self._read = context, (said.course, said.policy)
            self._faults = ()
        except GripcourseError as error:
            self._faults = error.problems
        except OSError as error:
            self._faults = (system_problem(error),)
        for one in self._faults:
            _log.error("%s: %s: %s", one.file, one.key, one.what)


def open_living(root: Path) -> LivingCourse:
    """Open a course that a server follows.

    Raises:
        GripcourseError: course, policy, key or database cannot be used.
    """
    seen = state_of(root)
    return LivingCourse(open_context(root), seen)


def state_of(root: Path) -> CourseState:
    """Return how the files of a course are that decide over results."""
    return tuple((path, _written(path)) for path in (*declaring_files(root), *policy_files(root)))


def _written(path: Path) -> _FileState | None:
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_ctime_ns, found.st_size, found.st_ino


def _see_same_course(before: Course, now: Course) -> None:
    if now.id != before.id:
        what = message("The course was '{before}' when this server began.", before=before.id)
        remedy = message("Write its id as it was, or start the server again.")
        raise CourseError([Problem("variants/course.toml", "id", what, remedy)])
