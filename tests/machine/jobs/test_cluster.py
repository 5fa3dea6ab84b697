"""On a Dask cluster jobs come to the same as in processes, whatever happens to the cluster.

One cluster lives one story: it grades, loses a worker, meets a strange one and loses its scheduler.
"""

import importlib
import shutil
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, date, datetime
from itertools import count
from pathlib import Path
from types import ModuleType
from zipfile import ZipFile

import pytest

from gripcourse.batch.graded import Graded
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.batch.run import grade_files
from gripcourse.cli.demo.students import correct
from gripcourse.errors import UsageError
from gripcourse.gradebook.store import open_gradebook
from gripcourse.machine.content import Readable
from gripcourse.machine.jobs import cluster as on_cluster
from gripcourse.machine.jobs.cluster import open_cluster, open_workers
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.pools import PROCESSES, Pool
from gripcourse.machine.jobs.program import differences, program_here
from gripcourse.machine.jobs.workers import in_order, run_each
from gripcourse.usecases.grading.collect import collect
from gripcourse.usecases.grading.grade import grade, write_results
from gripcourse.usecases.grading.student_reports import LayOut
from gripcourse.usecases.marks.gradebook import keep
from support.classroom import Classroom, forget_one_jaw
from support.dask_cluster import DaskCluster, dask_cluster

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="workers are bounded on Linux")

HERE = Path(__file__).parent
USE_CASES = HERE.parents[1] / "usecases" / "grading"
NOW = datetime(2026, 12, 9, 9, tzinfo=UTC)
NOBODY = "tcp://127.0.0.1:9"
OLDER = {"gripcourse": "0.0.9 (an older one)"}


@dataclass(frozen=True)
class Batch:
    """Works of three students and files that are none, and who grades them."""

    classroom: Classroom
    files: Sequence[Readable]
    folder: Path
    lay_out: LayOut

    def graded(self, name: str, pool: Pool, workers: int, on_done: Callable[[], None]) -> "Results":
        context, out = self.classroom.context, self.folder / name
        book = str(self.folder / f"{name}.sqlite")
        found = grade(self.files, context, workers, lambda _: on_done(), None, pool)
        found = keep(found, context, book, NOW)
        write_results(
            found,
            context,
            out,
            date(2026, 12, 2),
            workers,
            lambda _: None,
            lay_out=self.lay_out,
            pool=pool,
        )
        made = {
            str(one.relative_to(out)): one.read_bytes() for one in out.rglob("*") if one.is_file()
        }
        return Results(found, made, repr(open_gradebook(book).attempts()))


@dataclass(frozen=True)
class Results:
    graded: Sequence[Graded]
    made: dict[str, bytes]
    gradebook: str


@dataclass
class Story:
    """What happened, in this order."""

    hands: int
    doubled: Sequence[int | Lost]
    hostile: Sequence[object]
    alive: bool
    by_processes: Results
    by_cluster: Results
    lost_a_worker: bool
    stranger: str
    late_stranger: str
    gone: str
    resumed: Sequence[Graded]


@pytest.fixture(scope="module")
def errands() -> Iterator[ModuleType]:
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(HERE))
        patch.syspath_prepend(str(USE_CASES))
        yield importlib.import_module("errands")


@pytest.fixture(scope="module")
def batch(
    issued: Classroom, errands: ModuleType, tmp_path_factory: pytest.TempPathFactory
) -> Batch:
    folder = tmp_path_factory.mktemp("batch")
    works = folder / "works"
    works.mkdir()
    issued.hand_in("s01", correct, works / "s01.xlsx")
    issued.hand_in("s02", forget_one_jaw, works / "s02.xlsx")
    third = issued.hand_in("s03", correct, folder / "s03.xlsx")
    with ZipFile(works / "more.zip", "w") as more:
        more.write(third, "group/s03.xlsx")
    (works / "damaged.xlsx").write_bytes((works / "s01.xlsx").read_bytes()[:9000])
    shutil.copy(works / "s01.xlsx", works / "s03 again.xlsx")
    files = [*collect([works]).files, works / "gone.xlsx"]
    return Batch(issued.with_its_scheme(), files, folder, errands.page)


@pytest.fixture(scope="module")
def story(
    batch: Batch, errands: ModuleType, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Story]:
    fake = importlib.import_module("fake_documents")
    folder = tmp_path_factory.mktemp("cluster")
    with (
        pytest.MonkeyPatch.context() as patch,
        dask_cluster(folder, (HERE, USE_CASES), 2) as cluster,
    ):
        patch.setattr("gripcourse.usecases.grading.cohort_print.cohort_pdf", fake.cohort_page)
        yield happened(batch, errands, cluster, patch)


def happened(
    batch: Batch, errands: ModuleType, cluster: DaskCluster, patch: pytest.MonkeyPatch
) -> Story:
    first, second = cluster.workers
    with open_cluster(cluster.address) as found:
        pool, hands = found.pool, found.workers
        doubled = in_order(
            run_each(errands.double, range(5), 1, workers=hands, seconds=60, pool=pool)
        )
        hostile = in_order(
            run_each(errands.obey, ORDERS, None, workers=hands, seconds=2, pool=pool)
        )
        alive = first.poll() is second.poll() is None
        by_processes = batch.graded("processes", PROCESSES, 1, lambda: None)
        by_cluster = batch.graded("cluster", pool, hands, first.kill)
        # Before the scheduler goes, too: a worker without one ends by itself, sooner or later.
        lost_a_worker = first.poll() is not None and second.poll() is None
        with patch.context() as other:
            other.setattr(on_cluster, "program_here", lambda: {**program_here(), **OLDER})
            late_stranger = refusal(
                lambda: in_order(run_each(errands.double, [1], 1, workers=1, seconds=60, pool=pool))
            )
    with patch.context() as other:
        other.setattr(on_cluster, "program_here", lambda: {**program_here(), **OLDER})
        stranger = refusal(lambda: open_cluster(cluster.address).__enter__())
    context = batch.classroom.context
    kept = KeptReports(batch.folder / "kept", {})

    def graded_with(pool: Pool, on_done: Callable[[], None]) -> Sequence[Graded]:
        return grade_files(
            batch.files,
            context,
            1,
            lambda _: on_done(),
            grade_one=errands.slowly,
            kept=kept,
            pool=pool,
        )

    done = count(1)

    def kill_at_the_third() -> None:
        if next(done) == 3:
            cluster.scheduler.kill()

    def lose_the_scheduler() -> None:
        with open_cluster(cluster.address) as found:
            graded_with(found.pool, kill_at_the_third)

    gone = refusal(lose_the_scheduler)
    return Story(
        hands=hands,
        doubled=doubled,
        hostile=hostile,
        alive=alive,
        by_processes=by_processes,
        by_cluster=by_cluster,
        lost_a_worker=lost_a_worker,
        stranger=stranger,
        late_stranger=late_stranger,
        gone=gone,
        resumed=graded_with(PROCESSES, lambda: None),
    )


ORDERS = ("hang", "well", "vanish", "grow")


def refusal(call: Callable[[], object]) -> str:
    with pytest.raises(UsageError) as refused:
        call()
    return str(refused.value)


def test_all_threads_of_all_workers_get_jobs(story: Story) -> None:
    assert story.hands == 2
    assert story.doubled == (1, 3, 5, 7, 9)


def test_a_hostile_job_ends_its_own_child_and_no_worker(story: Story) -> None:
    lost = [isinstance(one, Lost) for one in story.hostile]
    assert lost == [True, False, True, True]
    reasons = [one.reason for one in story.hostile if isinstance(one, Lost)]
    assert "TookTooLong" in reasons[0]
    assert "worker that did this died" in reasons[1]
    assert "MemoryError" in reasons[2]
    assert story.alive


def test_results_are_those_of_processes_byte_for_byte(story: Story) -> None:
    assert story.lost_a_worker
    assert story.by_cluster.graded == story.by_processes.graded
    assert sorted(story.by_cluster.made) == sorted(story.by_processes.made)
    assert {"grades.csv", "grades.json", "files.csv"} < story.by_processes.made.keys()
    assert any(name.endswith("s02.pdf") for name in story.by_processes.made)
    for name, content in story.by_processes.made.items():
        assert story.by_cluster.made[name] == content, name
    assert story.by_cluster.gradebook == story.by_processes.gradebook
    assert "student='s02'" in story.by_processes.gradebook


def test_a_worker_with_another_program_is_refused_by_name(story: Story) -> None:
    for said in (story.stranger, story.late_stranger):
        assert "another program" in said
        assert "0.0.9 (an older one)" in said
    assert "tcp://127.0.0.1" in story.stranger


def test_when_the_scheduler_goes_the_batch_can_be_resumed(story: Story) -> None:
    assert "went away" in story.gone
    assert "is kept" in story.gone
    assert any(one.taken_over for one in story.resumed)
    assert not all(one.taken_over for one in story.resumed)
    reports = [one.report for one in story.by_processes.graded]
    assert [one.report.earned for one in story.resumed] == [one.earned for one in reports]


@pytest.mark.parametrize(
    ("address", "said"),
    [
        ("127.0.0.1:8786", "is no address"),
        (NOBODY, "No Dask scheduler"),
        ("tcp://[", "No Dask"),
        ("tls://127.0.0.1:1", "write tcp:// instead of tls://"),
    ],
)
def test_what_is_no_scheduler_is_said(
    address: str, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(on_cluster, "_TO_CONNECT", 0.3)
    assert said in refusal(lambda: open_cluster(address).__enter__())


def test_this_process_alone_has_no_cluster() -> None:
    assert "no cluster either" in refusal(lambda: open_workers(0, NOBODY).__enter__())


def test_without_a_cluster_there_are_processes() -> None:
    with open_workers(3, None) as opened:
        assert opened == (3, PROCESSES)


def test_what_differs_is_named_with_both_versions() -> None:
    ours, theirs = {"a": "1", "b": "2"}, {"a": "1", "b": "3", "c": "4"}
    assert differences(ours, theirs) == {"b": ("2", "3"), "c": ("", "4")}
