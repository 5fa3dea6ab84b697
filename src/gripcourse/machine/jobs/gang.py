"""A cluster's worker's side: it opens no file of a job itself, its children do.

A worker of Dask that died would take along what is on its way to it. So every job is done by a
child process with the limits of any worker; whatever it does to itself, the worker lives.
"""

import pickle
import shutil
import weakref
from collections import deque
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from tempfile import mkdtemp
from typing import TYPE_CHECKING, Any, Final, TypeAlias

from gripcourse.machine.jobs.child import DIED, GROWN, NOT_ANSWERED, ask, end, start
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.program import differences, program_here
from gripcourse.machine.jobs.work import Task

if TYPE_CHECKING:
    from subprocess import Popen

_Children: TypeAlias = "deque[Popen[bytes]]"

# Long after a child should have ended itself, whatever its job was.
_LONGEST: Final = 600.0  # seconds


@dataclass(frozen=True, slots=True)
class GangOrder:
    """What travels once to each worker that gets jobs of one task.

    Attributes:
        first: the pickled call that makes a child ready, with its arguments.
        limits: of each child.
        program: by which the jobs are to be done; see `program_here`.
    """

    first: bytes
    limits: Limits
    program: Mapping[str, str]


class OtherProgramError(Exception):
    """A worker has another program than who sends the jobs; its arguments are what differs."""


class Gang:
    """Children of one worker for the jobs of one task; they may be asked from any thread.

    They live as long as the worker keeps this object: Dask drops it when who sent it lets it go, or
    is gone.
    """

    def __init__(self, order: GangOrder) -> None:
        self.order = order
        self._idle: _Children = deque()
        self._scratch = Path(mkdtemp(prefix="gripcourse-", dir=_folder()))
        # Children end with the thread that starts them, and those of a worker come and go.
        self._keeper = ThreadPoolExecutor(1, "keeper of children")
        weakref.finalize(self, _disband, self._idle, self._scratch, self._keeper)

    def __reduce__(self) -> tuple[type["Gang"], tuple[GangOrder]]:
        # Another worker hires children of its own.
        return Gang, (self.order,)

    def do(self, packed: bytes) -> bytes:
        """Do a packed call in a child and return its packed result; see `unpacked`.

        What ends its child is done once more by a new one, in case that the old one died of
        something else; what ends that one too is lost.
        """
        for try_ in range(2):
            child = None
            try:
                child = self._hired(anew=try_ > 0)
                outcome, grown = ask(child, packed, _LONGEST)
            except NOT_ANSWERED:
                if child is not None:
                    end(child)
            else:
                self._release(child, grown)
                return _as_bytes(outcome)
        return pickle.dumps(Lost(DIED))

    def _hired(self, *, anew: bool) -> "Popen[bytes]":
        if not anew:
            try:
                return self._idle.pop()
            except IndexError:  # all are busy
                pass
        child = self._keeper.submit(start, self.order.limits, self._scratch).result()
        ask(child, self.order.first, _LONGEST)
        return child

    def _release(self, child: "Popen[bytes]", grown: int) -> None:
        if grown > GROWN:
            end(child)
        else:
            self._idle.append(child)


def packed_call(call: Any, *arguments: Any) -> bytes:  # noqa: ANN401 (a function that pickle finds)
    """Pack a call for `Gang.do`; what it returns stays packed until `unpacked`."""
    return pickle.dumps((Task(_call, None, _LONGEST, None), pickle.dumps((call, arguments))))


def unpacked(outcome: bytes) -> Any:  # noqa: ANN401 (whatever the call returned)
    """Return what a packed call came to."""
    return pickle.loads(outcome)  # noqa: S301 (of a worker that docs/security.md says to trust)


def program_there() -> Mapping[str, str]:
    """Return by what jobs are done at a worker; see `program_here`."""
    return program_here()


def do_there(gang: Gang, packed: bytes) -> bytes:
    """Do a packed call at a worker of a cluster.

    Raises:
        OtherProgramError: this worker has another program than who sent the call.
    """
    found = differences(gang.order.program, program_here())
    if found:
        raise OtherProgramError(found)
    return gang.do(packed)


def _call(packed: bytes, _: None) -> bytes:
    call, arguments = pickle.loads(packed)  # noqa: S301 (our own program)
    return pickle.dumps(call(*arguments))


def _as_bytes(outcome: bytes | Lost) -> bytes:
    return pickle.dumps(outcome) if isinstance(outcome, Lost) else outcome


def _folder() -> str | None:
    """Return the folder of this worker, which Dask clears also after a worker was killed."""
    from distributed import get_worker  # noqa: PLC0415 (an extra)

    try:
        return str(get_worker().local_directory)
    except ValueError:  # no worker, or not in one of its jobs
        return None


def _disband(idle: _Children, scratch: Path, keeper: ThreadPoolExecutor) -> None:
    while idle:
        end(idle.pop())
    keeper.shutdown(wait=False)
    shutil.rmtree(scratch, ignore_errors=True)
