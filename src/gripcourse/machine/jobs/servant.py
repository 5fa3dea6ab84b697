"""The worker's side of `warm`: a program that does jobs until nobody sends any."""

import os
import pickle
import sys
import traceback
from typing import Any

from gripcourse.machine.jobs.limits import bind_worker, peak_memory
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.work import do


def serve() -> None:
    """Read jobs from standard input and answer to standard output, until the input ends.

    What a library prints goes nowhere: it would be taken for an answer.
    """
    jobs, answers = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    bind_worker(pickle.load(jobs))  # noqa: S301 (our own program)
    while True:
        try:
            outcome = _next(jobs)
        except EOFError:
            return
        pickle.dump((outcome, peak_memory()), answers)
        answers.flush()


def _next(jobs: Any) -> Any | Lost:  # noqa: ANN401 (a stream of bytes; whatever the work returns)
    try:
        task, item = pickle.load(jobs)  # noqa: S301 (our own program)
    except EOFError:
        raise
    except Exception:  # noqa: BLE001 (work that is not found here)
        return Lost(traceback.format_exc())
    return do(task, item)
