"""Jobs come to the same with any kind of workers, and none outlives who ordered it."""

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from multiprocessing import util
from multiprocessing.forkserver import _forkserver
from pathlib import Path
from time import sleep
from types import ModuleType
from typing import Any

import pytest

from gripcourse.machine.jobs.limits import Limits, memory_notice
from gripcourse.machine.jobs.lost import JobLostError, Lost
from gripcourse.machine.jobs.pools import (
    INLINE,
    PROCESSES,
    THREADS,
    Executing,
    Initializer,
    Pool,
    foresee_processes,
    pool_for,
)
from gripcourse.machine.jobs.warm import do_apart
from gripcourse.machine.jobs.workers import all_done, in_order, run_each
from support.processes import is_running, wait_for

if sys.platform != "win32":
    import resource

IMPATIENT = Pool(PROCESSES.open, apart=True, limits=Limits(grace=0.2))


@pytest.mark.parametrize("pool", [PROCESSES, THREADS, INLINE], ids=["processes", "threads", "here"])
def test_results_are_in_the_order_of_the_items(errands: ModuleType, pool: Pool | None) -> None:
    done: list[int] = []
    jobs = run_each(errands.double, range(5), 1, workers=2, seconds=60, pool=pool)
    assert in_order(jobs, done.append) == (1, 3, 5, 7, 9)
    assert sorted(done) == [0, 1, 2, 3, 4]


@pytest.mark.parametrize("pool", [PROCESSES, THREADS], ids=["processes", "threads"])
def test_so_they_are_where_several_travel_together(errands: ModuleType, pool: Pool) -> None:
    done: list[int] = []
    jobs = run_each(errands.double, range(100), 1, workers=2, seconds=60, pool=pool, together=8)
    assert in_order(jobs, done.append) == tuple(range(1, 200, 2))
    assert sorted(done) == list(range(100))


def test_an_item_is_asked_for_when_its_turn_comes(errands: ModuleType) -> None:
    asked: list[int] = []

    class Noting(Sequence[int]):
        def __len__(self) -> int:
            return 100

        def __getitem__(self, place: Any) -> Any:  # noqa: ANN401 (a slice is never asked for)
            asked.append(place)
            return place

    jobs = run_each(errands.double, Noting(), 1, workers=1, seconds=60, pool=THREADS)
    next(jobs)
    assert len(asked) < 10
    assert len(list(jobs)) == 99
    assert asked == list(range(100))


def _by_tens(item: int) -> int:
    return item // 10


def test_jobs_of_a_kind_are_for_the_same_worker(errands: ModuleType) -> None:
    items = [number * 10 % 100 + number // 10 for number in range(100)]
    jobs = run_each(
        errands.who_does, items, None, workers=2, seconds=60, together=4, kind_of=_by_tens
    )
    done_by = dict(zip(items, in_order(jobs), strict=True))
    # Those that were sent at once: later ones may go to whoever has nothing left.
    assert len({done_by[one] for one in (0, 1, 2, 3)}) == 1
    assert len({done_by[one] for one in (50, 51, 52, 53)}) == 1
    assert done_by[0] != done_by[50]


@pytest.mark.parametrize("kind_of", [None, _by_tens], ids=["alike", "of kinds"])
def test_of_jobs_that_travel_together_only_the_one_that_ends_its_worker_is_lost(
    errands: ModuleType, kind_of: Callable[[int], int] | None
) -> None:
    items = [*range(70), -1, *range(70, 100)]
    jobs = run_each(
        errands.end_at_negative,
        items,
        None,
        workers=2,
        seconds=60,
        pool=PROCESSES,
        together=8,
        kind_of=kind_of,
    )
    found = in_order(jobs)
    assert [place for place, one in enumerate(found) if isinstance(one, Lost)] == [70]
    assert [one for one in found if not isinstance(one, Lost)] == list(range(100))


def test_of_jobs_that_travel_together_each_has_its_own_time(errands: ModuleType) -> None:
    items = [0.0] * 40 + [9.0] + [0.0] * 40
    jobs = run_each(errands.rest, items, None, workers=1, seconds=0.5, pool=IMPATIENT, together=8)
    found = in_order(jobs)
    assert [place for place, one in enumerate(found) if isinstance(one, Lost)] == [40]


@pytest.mark.parametrize("pool", [THREADS, INLINE], ids=["threads", "here"])
def test_a_failure_is_that_of_its_job_alone(errands: ModuleType, pool: Pool | None) -> None:
    jobs = run_each(errands.stop_at_odd, range(3), None, workers=2, seconds=60, pool=pool)
    zero, one, two = in_order(jobs)
    assert (zero, two) == (0, 2)
    assert isinstance(one, Lost)
    assert one.reason == "ValueError: 1 is odd"
    assert "Traceback" in one.trace


def test_a_failure_is_raised_where_all_jobs_are_needed(errands: ModuleType) -> None:
    jobs = run_each(errands.stop_at_odd, range(3), None, workers=1, seconds=60, pool=INLINE)
    with pytest.raises(JobLostError, match="1 is odd"):
        in_order(all_done(jobs))


def test_one_worker_of_trusted_work_is_this_process() -> None:
    assert pool_for(1) is INLINE
    assert pool_for(2) is PROCESSES


def test_what_jobs_share_travels_once_to_each_worker(errands: ModuleType, tmp_path: Path) -> None:
    diary = tmp_path / "diary"
    luggage = errands.Luggage(diary)
    jobs = run_each(errands.carry, range(12), luggage, workers=2, seconds=60)
    assert in_order(jobs) == tuple(range(12))
    unpacked = diary.read_text(encoding="ascii").split()
    assert 1 <= len(unpacked) == len(set(unpacked)) <= 2


def test_threads_share_the_thing_itself(errands: ModuleType, tmp_path: Path) -> None:
    diary = tmp_path / "diary"
    luggage = errands.Luggage(diary)
    in_order(run_each(errands.carry, range(4), luggage, workers=2, seconds=60, pool=THREADS))
    assert not diary.exists()


def test_what_cannot_be_unpacked_is_said_by_each_job(errands: ModuleType) -> None:
    jobs = run_each(errands.carry, range(2), errands.Unwrappable(), workers=1, seconds=60)
    reasons = {one.reason for one in in_order(jobs) if isinstance(one, Lost)}
    assert reasons == {"RuntimeError: lost on the way"}


UNGUARDED = """
from gripcourse.machine.jobs.workers import in_order, run_each
import errands
if __name__ != "__main__":
    raise RuntimeError("this script is not for workers")
jobs = run_each(errands.carry, range(9), bytes(1_000_000), workers=2, seconds=60)
print(len(lost := in_order(jobs)), {one.reason for one in lost})
"""


def test_a_worker_that_cannot_start_is_said_by_each_job(tmp_path: Path) -> None:
    """A script is imported by the workers that it starts, and may end them before they begin."""
    script = tmp_path / "script.py"
    script.write_text(
        f"import sys\nsys.path[:0] = {[*sys.path, str(Path(__file__).parent)]}\n{UNGUARDED}",
        encoding="utf-8",
    )
    command = [sys.executable, str(script)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)  # noqa: S603
    assert done.stdout.startswith("9 {'No worker could start;")
    assert "not for workers" in done.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="workers are forks on Linux only")
def test_where_what_workers_are_forks_of_is_killed_another_takes_its_place(
    errands: ModuleType,
) -> None:
    for _ in range(2):
        jobs = run_each(errands.double, range(3), 1, workers=2, seconds=60)
        assert in_order(jobs) == (1, 3, 5)
        origin = _forkserver._forkserver_pid  # type: ignore[attr-defined]  # noqa: SLF001
        os.kill(origin, signal.SIGKILL)
        os.waitid(os.P_PID, origin, os.WEXITED | os.WNOWAIT)


@pytest.mark.skipif(sys.platform != "linux", reason="workers are forks on Linux only")
def test_an_interrupt_ends_no_preparation_and_workers_hear_it(errands: ModuleType) -> None:
    """Ctrl-C comes to all processes of a terminal; the one that was called answers for it."""
    _forkserver._stop()  # type: ignore[attr-defined]  # noqa: SLF001 (made for tests)
    foresee_processes("gripcourse.batch.run")
    origin = _forkserver._forkserver_pid  # type: ignore[attr-defined]  # noqa: SLF001
    os.kill(origin, signal.SIGINT)
    jobs = run_each(errands.hears_interrupts, [1], None, workers=1, seconds=60)
    assert in_order(jobs) == (True,)
    assert _forkserver._forkserver_pid == origin  # type: ignore[attr-defined]  # noqa: SLF001


@pytest.mark.skipif(sys.platform != "linux", reason="workers are forks on Linux only")
def test_an_interrupt_finds_nothing_to_end_in_a_worker_that_waits(
    errands: ModuleType, capfd: pytest.CaptureFixture[str]
) -> None:
    _forkserver._stop()  # type: ignore[attr-defined]  # noqa: SLF001 (so that it writes where we read)
    jobs = run_each(errands.who_does, range(5), None, workers=1, seconds=60)
    _, worker = next(jobs)
    sleep(0.3)
    os.kill(worker, signal.SIGINT)
    assert [process for _, process in jobs] == [worker] * 4
    assert capfd.readouterr().err == ""


def test_a_place_for_temporary_files_may_have_a_long_path(tmp_path: Path) -> None:
    """Too long for the address at which forks are asked for."""
    place = tmp_path.joinpath(*("a_folder_with_a_long_name",) * 5)
    place.mkdir(parents=True)
    asked = (
        "from gripcourse.machine.jobs.workers import in_order, run_each\n"
        "from operator import add\n"
        "print(in_order(run_each(add, [1, 2], 3, workers=1, seconds=60)))\n"
    )
    done = subprocess.run(  # noqa: S603 (ours)
        [sys.executable, "-c", asked],
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
        env={**os.environ, "TMPDIR": str(place)},
    )
    assert done.stdout == "(4, 5)\n"


def test_a_job_that_ends_the_program_ends_only_itself(errands: ModuleType) -> None:
    jobs = run_each(errands.leave, range(3), None, workers=1, seconds=60, pool=INLINE)
    zero, one, two = in_order(jobs)
    assert (zero, two) == (0, 2)
    assert isinstance(one, Lost)


@pytest.mark.skipif(sys.platform != "linux", reason="sleeps in a library of the system")
def test_who_hangs_in_a_library_is_ended_and_the_others_are_done(errands: ModuleType) -> None:
    items = ["one", "deaf", "two"]
    opened = []

    def open_counted(workers: int, first: Initializer, arguments: tuple[Any, ...]) -> Executing:
        opened.append(workers)
        return IMPATIENT.open(workers, first, arguments)

    pool = replace(IMPATIENT, open=open_counted)
    jobs = run_each(errands.deaf, items, None, workers=1, seconds=2, pool=pool)
    one, hung, two = in_order(jobs)
    assert (one, two) == ("one", "two")
    assert isinstance(hung, Lost)
    assert "did not end in time" in hung.reason
    # The first, and one for each whom it took along; none to see whether workers can start.
    assert opened == [1, 1, 1]


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_no_worker_outlives_a_program_that_is_killed(errands: ModuleType, tmp_path: Path) -> None:
    script = str(errands.__file__)
    with subprocess.Popen([sys.executable, script, str(tmp_path)]) as program:  # noqa: S603 (ours)
        wait_for(lambda: len(list(tmp_path.iterdir())) == 2)
        program.send_signal(signal.SIGKILL)
    workers = [int(one.name) for one in tmp_path.iterdir()]
    wait_for(lambda: not any(is_running(one) for one in workers))


def test_a_worker_has_the_environment_of_the_moment(
    errands: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    for value in ("one", "two"):
        monkeypatch.setenv("GRIPCOURSE_ERRAND", value)
        jobs = run_each(errands.environment, ["GRIPCOURSE_ERRAND"], None, workers=1, seconds=60)
        assert in_order(jobs) == (value,)


@pytest.mark.skipif(sys.platform != "linux", reason="other systems bound no memory")
class TestMemory:
    def test_a_worker_has_its_limit(self, errands: ModuleType) -> None:
        (found,) = in_order(run_each(errands.memory, [0], None, workers=1, seconds=60))
        assert isinstance(found, tuple)
        assert found[0] == Limits().memory

    def test_a_lower_limit_of_the_system_is_taken_and_said(
        self, errands: ModuleType, bounded: int
    ) -> None:
        (found,) = in_order(run_each(errands.memory, [0], None, workers=1, seconds=60))
        assert found == (bounded, bounded)
        said = str(memory_notice(Limits()))
        assert str(bounded // 1024**2) in said

    def test_a_limit_that_was_lowered_since_the_first_workers_is_taken(
        self, errands: ModuleType
    ) -> None:
        large, lower = 8 * 1024**3, 6 * 1024**3  # more than this process has
        limits = Limits(memory=large)

        def found() -> tuple[int, int]:
            pool = Pool(PROCESSES.open, apart=True, limits=limits)
            jobs = run_each(errands.memory, [0], None, workers=1, seconds=60, pool=pool)
            ((_, of_pool),) = jobs
            apart = do_apart(errands.memory, None, None, limits=limits, seconds=60)
            assert isinstance(of_pool, tuple)
            assert isinstance(apart, tuple)
            return of_pool[0], apart[0]

        before = resource.getrlimit(resource.RLIMIT_AS)
        assert found() == (large, large)
        resource.setrlimit(resource.RLIMIT_AS, (lower, before[1]))
        try:
            assert found() == (lower, lower)
        finally:
            resource.setrlimit(resource.RLIMIT_AS, before)
        assert found() == (large, large)

    @pytest.fixture
    def bounded(self, monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
        """Start workers as under `ulimit -v`; this process goes on without."""
        limit = 2 * 1024**3
        start = util.spawnv_passfds

        def start_bounded(path: bytes, arguments: Sequence[str], handles: Sequence[int]) -> int:
            pid = start(path, arguments, handles)
            resource.prlimit(pid, resource.RLIMIT_AS, (limit, limit))
            return pid

        monkeypatch.setattr(util, "spawnv_passfds", start_bounded)
        monkeypatch.setattr("gripcourse.machine.jobs.limits.system_memory_limit", lambda: limit)
        # What workers are forks of is bounded, too, and must not be the one of other tests.
        _forkserver._stop()  # type: ignore[attr-defined]  # noqa: SLF001 (made for tests)
        yield limit
        _forkserver._stop()  # type: ignore[attr-defined]  # noqa: SLF001


def test_without_a_limit_of_the_system_there_is_nothing_to_say() -> None:
    assert memory_notice(Limits(memory=1)) is None


@pytest.mark.parametrize("system", ["win32", "darwin"])
def test_a_system_that_bounds_no_memory_is_named(system: str) -> None:
    assert "does not bound" in str(memory_notice(Limits(), system))
