"""A folded report says what it said, in a fraction of the room."""

import pickle

from gripcourse.course.model import Course
from gripcourse.grading.folded import Folded, folded
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.in_memory import judge_one
from gripcourse.simulation.mix import load_mix


def test_nothing_is_lost_and_little_is_kept(course: Course, policy: Policy) -> None:
    room = make_classroom(course, policy, load_mix(course), 1, 3, "rack_parallelogram")
    report = judge_one(next(iter(room.behaviours)), room).report
    small = folded(report)
    assert isinstance(small.findings, Folded)
    assert small == report
    assert repr(small) == repr(report)
    assert len(small.findings) == len(report.findings)
    assert all(one in small.findings for one in tuple(report.findings)[:2])
    assert folded(small) is small
    assert pickle.loads(pickle.dumps(small)) == report  # noqa: S301 (ours)
    assert len(small.findings.packed) < 10_000
