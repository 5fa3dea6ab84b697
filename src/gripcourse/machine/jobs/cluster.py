"""Workers on a Dask cluster: the same port as for processes of this machine.

Bytes travel, never paths: a worker needs this program, and neither a course nor a shared disk. What
Dask knows of our jobs is one function with bytes in and bytes out (`gang.do_there`); that a job is
done again elsewhere when its worker goes away is Dask's part.
"""

import logging
import pickle
import warnings
from collections.abc import Iterator, Mapping
from concurrent.futures import BrokenExecutor, CancelledError, Future
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from functools import partial
from threading import Event, Thread
from typing import TYPE_CHECKING, Any, Final

from gripcourse.errors import Problem, UsageError
from gripcourse.machine.jobs.certificates import demand_certificates
from gripcourse.machine.jobs.gang import (
    Gang,
    GangOrder,
    OtherProgramError,
    do_there,
    packed_call,
    program_there,
    unpacked,
)
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.pools import PROCESSES, Initializer, Pool
from gripcourse.machine.jobs.program import differences, program_here
from gripcourse.text.shown import first_of
from gripcourse.text.words import message

_LOGGERS: Final = ("distributed", "distributed.client", "distributed.core", "distributed.comm")

# Dask takes a third of a second to import, and it is an extra.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from distributed import Client
    from distributed import Future as Distant

_TO_CONNECT: Final = 10.0  # seconds
_LOOKS_EVERY: Final = 2.0  # seconds, whether any worker is left
_PATIENCE: Final = 60.0  # seconds without any worker: they may be starting again
_MOST_SAID: Final = 8  # differences of a worker's program
_LIMITS: Final = Limits()
_QUIET: Final = {
    # A submission may have 60 MB; nobody is to be advised to send it otherwise.
    "distributed.admin.large-graph-warning-threshold": "1GB",
}


@dataclass(frozen=True, slots=True)
class Cluster:
    """A cluster that is connected.

    Attributes:
        pool: its workers.
        workers: how many jobs they do at a time.
    """

    pool: Pool
    workers: int


@dataclass(frozen=True, slots=True)
class _OnCluster:
    """An executor on a cluster, for one task.

    Attributes:
        address: of the scheduler.
        client: the connection.
        gang: what each worker needs for the task, on the cluster.
        running: what is on its way, with its counterpart on the cluster, which Dask drops as soon
            as nobody keeps it.
    """

    address: str
    client: "Client"
    gang: "Distant[Gang]"
    running: "dict[Future[Any], Distant[bytes]]" = field(default_factory=dict)

    def submit(self, call: Any, /, *arguments: Any) -> Future[Any]:  # noqa: ANN401 (as in `Executing`)
        """Give a job to the cluster; see `Executing`."""
        there = self.client.submit(
            do_there, self.gang, packed_call(call, *arguments), pure=False, retries=0
        )
        outcome: Future[Any] = Future()
        self.running[outcome] = there
        there.add_done_callback(partial(self._settle, outcome))
        return outcome

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:  # noqa: ARG002, FBT001, FBT002 (as in `Executing`)
        """Let go of what is still on its way, and of the workers' children."""
        left = list(self.running.values())
        self.running.clear()
        # Where the scheduler is gone there is nobody to tell.
        with suppress(OSError, CancelledError, RuntimeError):
            if self.client.status == "running":
                self.client.cancel(left)
        self.gang.release()

    def give_up(self, problem: Problem) -> None:
        """End all that is on its way."""
        for outcome in tuple(self.running):
            self.running.pop(outcome, None)
            if not outcome.done():
                outcome.set_exception(UsageError([problem]))

    def _settle(self, outcome: Future[Any], there: "Distant[bytes]") -> None:
        from distributed.scheduler import KilledWorker

        if self.running.pop(outcome, None) is None:
            return  # nobody waits any more
        try:
            result = unpacked(there.result())
        except KilledWorker as fault:
            outcome.set_exception(BrokenExecutor(str(fault)))
        except (CancelledError, OSError):
            outcome.set_exception(UsageError([_gone(self.address)]))
        except OtherProgramError as fault:
            (found,) = fault.args
            outcome.set_exception(UsageError([_stranger("", found)]))
        except Exception as fault:  # noqa: BLE001 (whatever a strange worker makes of a job)
            outcome.set_exception(UsageError([_unfit("", f"{type(fault).__name__}: {fault}")]))
        else:
            outcome.set_result(result)


@contextmanager
def open_workers(workers: int, cluster: str | None) -> Iterator[tuple[int, Pool]]:
    """Open the workers that a person asks for: how many jobs they do at a time, and their kind.

    Args:
        workers: processes of this machine.
        cluster: address of a cluster that is used instead; None for none.

    Raises:
        UsageError: the cluster cannot be used, see `open_cluster`, or this process alone was to
            work.
    """
    if cluster is None:
        yield workers, PROCESSES
    elif workers == 0:
        what = message("Without any process there is no cluster either.")
        remedy = message("Leave one of the two out: the cluster, or no workers.")
        raise UsageError([Problem("", "", what, remedy, parameter="workers")])
    else:
        with open_cluster(cluster) as found:
            yield found.workers, found.pool


@contextmanager
def open_cluster(address: str) -> Iterator[Cluster]:
    """Connect to a cluster whose workers have our program.

    For an address `tls://...` Dask's own configuration names the certificates.

    Args:
        address: of the scheduler, `tcp://HOST:PORT` or `tls://HOST:PORT`.

    Raises:
        UsageError: Dask is not installed, nobody answers at the address, there is no worker, or one
            of them has another program than this one.
    """
    try:
        import dask
        import distributed  # noqa: F401 (whether it is there)
    except ModuleNotFoundError as missing:
        what = message("A cluster needs the package {name}.", name=str(missing.name))
        remedy = message("Install gripcourse with its extra 'cluster'.")
        raise UsageError([Problem("", "", what, remedy, parameter="cluster")]) from missing
    with dask.config.set(_QUIET), _silent():
        client = _connected(address)
        opened: list[_OnCluster] = []
        try:
            workers = _fit_workers(client, address)
            stop = Event()
            watch = Thread(target=_watch, args=(client, address, opened, stop), daemon=True)
            watch.start()
            try:
                pool = Pool(
                    partial(_open, client, address, opened),
                    apart=True,
                    limits=_LIMITS,
                    shares_disk=False,
                )
                yield Cluster(pool, workers)
            finally:
                stop.set()
        finally:
            with suppress(OSError, CancelledError, RuntimeError):
                client.close(timeout=2)


@contextmanager
def _silent() -> Iterator[None]:
    """Let Dask say nothing: whatever goes wrong is said by us, once."""
    loggers = [logging.getLogger(name) for name in _LOGGERS]
    before = [one.level for one in loggers]
    for one in loggers:
        one.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for one, level in zip(loggers, before, strict=True):
            one.setLevel(level)


def _open(
    client: "Client",
    address: str,
    opened: list[_OnCluster],
    _workers: int,
    first: Initializer,
    arguments: tuple[Any, ...],
) -> _OnCluster:
    order = GangOrder(packed_call(first, *arguments), _LIMITS, program_here())
    # Packed by ourselves: Dask need not look into it on its way.
    gang = client.submit(_gang, pickle.dumps(order), pure=False)
    executor = _OnCluster(address, client, gang)
    opened[:] = [executor]
    return executor


def _gang(packed: bytes) -> Gang:
    return Gang(pickle.loads(packed))  # noqa: S301 (our own program)


def _connected(address: str) -> "Client":
    from distributed import Client

    if not address.startswith(("tcp://", "tls://")):
        what = message("'{address}' is no address of a Dask scheduler.", address=address)
        remedy = message("Write tcp://HOST:PORT, or tls://HOST:PORT.")
        raise UsageError([Problem("", "", what, remedy, parameter="cluster")])
    if address.startswith("tls://"):
        # Before a client is made, which would try to say good-bye for long.
        demand_certificates(address)
    try:
        with warnings.catch_warnings():
            # Other versions are refused by us, with names.
            warnings.simplefilter("ignore")
            return Client(address, timeout=_TO_CONNECT, set_as_default=False)
    except (OSError, ValueError, TypeError, RuntimeError) as fault:
        what = message(
            "No Dask scheduler can be used at {address}: {reason}",
            address=address,
            reason=" ".join(str(fault).split()) or type(fault).__name__,
        )
        remedy = message("Start it, or name its address as it prints it.")
        raise UsageError([Problem("", "", what, remedy, parameter="cluster")]) from fault


def _fit_workers(client: "Client", address: str) -> int:
    """Return how many jobs the workers do at a time, after each has shown its program."""
    threads: Mapping[str, int] = client.nthreads()
    if not threads:
        what = message("The cluster at {address} has no workers.", address=address)
        remedy = message("Start some: dask worker {address}", address=address)
        raise UsageError([Problem("", "", what, remedy, parameter="cluster")])
    ours = program_here()
    problems = []
    for worker, found in sorted(client.run(program_there, on_error="return").items()):
        if not isinstance(found, Mapping):
            problems.append(_unfit(worker, f"{type(found).__name__}: {found}"))
        elif others := differences(ours, found):
            problems.append(_stranger(worker, others))
    if problems:
        raise UsageError(problems)
    return sum(threads.values())


def _watch(client: "Client", address: str, opened: list[_OnCluster], stop: Event) -> None:
    """Give up what waits for a worker where all have been gone for long."""
    lonely = 0.0
    while not stop.wait(_LOOKS_EVERY):
        try:
            lonely = 0.0 if client.nthreads() else lonely + _LOOKS_EVERY
        except (OSError, CancelledError, RuntimeError, ValueError):
            lonely += _LOOKS_EVERY
        if lonely >= _PATIENCE:
            for one in opened:
                one.give_up(_gone(address))
            return


def _gone(address: str) -> Problem:
    what = message(
        "The cluster at {address} went away. What was done until then is kept.", address=address
    )
    remedy = message("Start it again and repeat the command, or grade without it: it goes on.")
    return Problem("", "", what, remedy, parameter="cluster")


def _stranger(worker: str, found: Mapping[str, tuple[str, str]]) -> Problem:
    said = [f"{name} {theirs or '—'} ≠ {ours or '—'}" for name, (ours, theirs) in found.items()]
    what = message(
        "This worker of the cluster has another program than this computer: {differences}.",
        differences=first_of(said, _MOST_SAID),
    )
    remedy = message("Install the same versions there, and start the worker again.")
    return Problem("", worker, what, remedy, parameter="cluster")


def _unfit(worker: str, reason: str) -> Problem:
    what = message("This worker of the cluster cannot do our jobs: {reason}.", reason=reason)
    remedy = message("Install gripcourse there with its extra 'cluster', and start it again.")
    return Problem("", worker, what, remedy, parameter="cluster")
