"""What somebody learns who knows a few computed answers and asks the self-check for the others.

    python benchmarks/self_check.py [scheme] [--known 7] [--questions 12000]

For each level of the policy: answers that are right in the end, questions, different replies.
"""

import argparse
import math
from pathlib import Path

from gripcourse.course.load import load_course
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Tells
from gripcourse.simulation.asking import ask_for_answers
from gripcourse.solver.plan import default_options, make_plan, usual_values

ROOT = Path(__file__).parents[1]


def main() -> None:
    """Ask at each level as often as wanted, then as often as the policy's server answers."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scheme", nargs="?", default="link_lever_2")
    parser.add_argument("--known", type=int, default=7)
    parser.add_argument("--questions", type=int, default=12_000)
    wanted = parser.parse_args()
    course = load_course(ROOT)
    policy = load_policy(course)
    plan = make_plan(course, wanted.scheme, default_options(course.schemes[wanted.scheme]))
    given = {one.id: usual_values(plan)[one.id] for one in plan.givens}
    levels = [(tells, wanted.questions) for tells in Tells]
    for tells, most in (*levels, (policy.check.tells, policy.check.times)):
        done = ask_for_answers(plan, policy, given, wanted.known, most, tells)
        print(
            f"{tells.value:9s} {done.questions:6d} questions: {done.known} computed answers grew to"
            f" {done.found} of {done.answers}; {done.replies} different replies,"
            f" at most {math.log2(done.replies):.1f} bits a question"
        )


if __name__ == "__main__":
    main()
