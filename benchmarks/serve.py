"""A group hands in within a minute, undisturbed and while workers and the server are killed.

    python benchmarks/serve.py [--students 200] [--seconds 60]

Everybody opens the personal page, checks the workbook and hands it in; who gets no answer tries
again, as a person would. Then the receipts are counted against what the server has kept.
"""

import argparse
import hashlib
import io
import math
import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import zipfile
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from datetime import UTC, date, datetime, timedelta
from pathlib import Path

import httpx2

from gripcourse.cli.demo.students import correct
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.machine.content import NamedBytes
from gripcourse.policy.load import load_policy
from gripcourse.simulation.write import fill
from gripcourse.solver.plan import make_plan
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.init import init_course
from gripcourse.usecases.issuing.handout import Handout, IssuingContext
from gripcourse.usecases.issuing.issue import Order, issue_order
from gripcourse.usecases.serving.desk import DeskContext, open_context
from gripcourse.usecases.serving.hand_in import kept_path
from gripcourse.usecases.serving.links import token_of
from gripcourse.variants.model import Issued, Variant
from gripcourse.variants.table import write_table
from gripcourse.workbook.write import write_answer_workbook

SCHEME = "rack_parallelogram"
PATIENCE = 60.0  # seconds for one answer
TRIES = 120


@dataclass(slots=True)
class Seen:
    """What the students saw: seconds of requests by kind, failures, receipts; and how they ask."""

    seconds: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    failures: list[str] = field(default_factory=list)
    gave_up: int = 0
    receipts: list[tuple[str, int, str]] = field(default_factory=list)
    lock: threading.Lock = field(default_factory=threading.Lock)
    client: httpx2.Client = field(
        default_factory=lambda: httpx2.Client(
            timeout=PATIENCE, limits=httpx2.Limits(max_connections=None)
        )
    )


class Running:
    """The server of the command line, which can be killed and started again."""

    def __init__(self, root: Path) -> None:
        self.root = root
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.process = self._start()

    @property
    def address(self) -> str:
        """Where it listens."""
        return f"http://127.0.0.1:{self.port}"

    def _start(self) -> "subprocess.Popen[bytes]":
        command = [
            *(sys.executable, "-m", "gripcourse", "serve", "--course", str(self.root)),
            *("--port", str(self.port), "--workers", "2"),
        ]
        return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # noqa: S603 (ourselves)

    def wait(self) -> float:
        """Return after how many seconds it answers."""
        began = time.monotonic()
        while time.monotonic() - began < PATIENCE:
            try:
                httpx2.get(self.address, timeout=PATIENCE)
            except httpx2.HTTPError:
                time.sleep(0.1)
            else:
                return time.monotonic() - began
        raise TimeoutError

    def kill_worker(self) -> int:
        """Kill a process that reads uploads; return how many there were."""
        task = Path(f"/proc/{self.process.pid}/task")
        children = [
            int(one)
            for thread in task.iterdir()
            for one in (thread / "children").read_text(encoding="ascii").split()
        ]
        workers = [one for one in children if b"spawn_main" in _command(one)]
        if workers:
            os.kill(max(workers), signal.SIGKILL)
        return len(workers)

    def restart(self, sign: signal.Signals) -> None:
        """End it and start it again at the same address."""
        self.process.send_signal(sign)
        self.process.wait(PATIENCE)
        self.process = self._start()

    def end(self) -> None:
        """Let it end by itself."""
        self.process.terminate()
        self.process.wait(PATIENCE)


def main() -> None:
    """Let a group hand in twice: in peace, and while things are killed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--students", type=int, default=200)
    parser.add_argument("--seconds", type=float, default=60.0)
    wanted = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder) / "course"
        context, workbook = make_group(root, wanted.students)
        print(f"{wanted.students} students within {wanted.seconds:.0f} s, {os.cpu_count()} cores:")
        for name, disturb in (
            ("undisturbed", None),
            (
                "a worker killed twice, the server killed (SIGKILL) and restarted (SIGTERM)",
                disturb_it,
            ),
        ):
            server = Running(root)
            server.wait()
            began = time.monotonic()
            disturbing = threading.Thread(
                target=disturb or (lambda *_: None), args=(server, wanted.seconds)
            )
            disturbing.start()
            seen = let_hand_in(context, workbook, server.address, wanted.seconds, name[:3])
            disturbing.join()
            took = time.monotonic() - began
            server.end()
            tell(name, seen, context, took)


def make_group(root: Path, students: int) -> tuple[DeskContext, bytes]:
    """Issue a variant to everybody; return the desk, and a workbook that is filled in."""
    init_course(root, os.urandom(32), Words("en"))
    course = load_course(root)
    names = [f"s{number:03d}" for number in range(1, students + 1)]
    roster = "student,name,group\n" + "".join(f"{one},Student {one},A\n" for one in names)
    table = root / "variants" / "tables" / "load.csv"
    write_table(table, variants_of(course, students), course)
    order = Order(
        NamedBytes("roster.csv", roster.encode()),
        table,
        root.parent / "out",
        date(2026, 9, 1),
        None,
    )
    policy = load_policy(course)
    issue_order(course, policy, order, 0, lambda _: None, issue_one=issue_nothing)
    context = open_context(root)
    issued = context.register()[names[0]]
    plan = make_plan(course, issued.variant.scheme, issued.variant.options)
    file = root.parent / "filled.xlsx"
    write_answer_workbook(file, plan, issued, course, Words("en"))
    fill(file, correct(plan, issued), file)
    return context, file.read_bytes()


def variants_of(course: Course, count: int) -> list[Variant]:
    """Return variants that differ in one number."""
    scheme = course.schemes[SCHEME]
    if scheme.example is None:
        raise ValueError(SCHEME)
    plan = make_plan(course, scheme.id, scheme.example.options)
    given = {one.id: float(scheme.example.given[one.id]) for one in plan.givens}
    return [
        Variant(f"{n:03d}", scheme.id, dict(plan.options), {**given, "mass": 60.0 - n / 10})
        for n in range(count)
    ]


def issue_nothing(_: IssuingContext, entry: Issued) -> Handout:
    """Write no documents: nobody prints them."""
    return Handout(entry.student.id, (), ())


def let_hand_in(
    context: DeskContext, workbook: bytes, address: str, seconds: float, run: str
) -> Seen:
    """Let everybody come at a time of their own, evenly spread, and return what they saw."""
    seen, register = Seen(), context.register()
    expires = datetime.now(UTC).replace(microsecond=0) + timedelta(days=1)
    began = time.monotonic()

    def student(place: int, name: str) -> None:
        time.sleep(max(0.0, began + place * seconds / len(register) - time.monotonic()))
        token = token_of(context, name, expires)
        file = {"file": (f"{name}.xlsx", marked(workbook, f"{run} {name}"))}
        head = {"Authorization": f"Bearer {token}"}
        ask(seen, "page", "GET", f"{address}/s/{token}/")
        ask(seen, "check", "POST", f"{address}/api/v1/checks", headers=head, files=file)
        made = ask(seen, "hand-in", "POST", f"{address}/api/v1/hand-ins", headers=head, files=file)
        if made is not None:
            told = made.json()
            with seen.lock:
                seen.receipts.append((name, told["number"], told["digest"]))

    with ThreadPoolExecutor(len(register)) as threads:
        for one in [threads.submit(student, *pair) for pair in enumerate(register)]:
            one.result()
    return seen


def ask(seen: Seen, kind: str, method: str, url: str, **sent: object) -> httpx2.Response | None:
    """Ask until there is an answer; each failure is kept."""
    for _ in range(TRIES):
        began = time.monotonic()
        try:
            answer = seen.client.request(method, url, **sent)  # type: ignore[arg-type]
            fault = "" if answer.is_success else f"{kind}: status {answer.status_code}"
        except httpx2.HTTPError as error:
            fault = f"{kind}: {type(error).__name__}"
        with seen.lock:
            if fault:
                seen.failures.append(fault)
            else:
                seen.seconds[kind].append(time.monotonic() - began)
        if not fault:
            return answer
        time.sleep(1.0)
    seen.gave_up += 1
    return None


def disturb_it(server: Running, seconds: float) -> None:
    """Kill a worker twice, then the server, then let it end by itself; start it anew each time."""
    quarter = seconds / 5
    for act in (
        server.kill_worker,
        server.kill_worker,
        lambda: server.restart(signal.SIGKILL),
        lambda: server.restart(signal.SIGTERM),
    ):
        time.sleep(quarter)
        act()
    print(f"  the server answers {server.wait():.1f} s after it was started again")


def tell(name: str, seen: Seen, context: DeskContext, took: float) -> None:
    """Print what was seen, and hold every receipt against what is kept."""
    kept = {(one.student, one.number, one.digest) for one in context.desk.hand_ins()}
    lost = [
        one
        for one in seen.receipts
        if one not in kept
        or hashlib.sha256(kept_path(context, one[2]).read_bytes()).hexdigest() != one[2]
    ]
    print(f"{name}: {took:.0f} s in all")
    for kind, seconds in seen.seconds.items():
        ordered = sorted(seconds)
        half, most = (ordered[math.ceil(part * len(ordered)) - 1] for part in (0.5, 0.95))
        print(
            f"  {kind:8s} {len(ordered):4d} answered, p50 {half:5.2f} s, p95 {most:5.2f} s,"
            f" slowest {ordered[-1]:5.2f} s"
        )
    counted = {fault: seen.failures.count(fault) for fault in sorted(set(seen.failures))}
    print(f"  failures that were tried again: {counted or 'none'}; gave up: {seen.gave_up}")
    print(
        f"  receipts {len(seen.receipts)}, of them lost {len(lost)}; files kept in all {len(kept)}"
    )


def marked(workbook: bytes, name: str) -> bytes:
    """Return a workbook whose bytes are nobody else's."""
    data = io.BytesIO(workbook)
    with zipfile.ZipFile(data, "a") as archive:
        archive.comment = name.encode()
    return data.getvalue()


def _command(process: int) -> bytes:
    try:
        return Path(f"/proc/{process}/cmdline").read_bytes()
    except OSError:
        return b""


if __name__ == "__main__":
    main()
