"""What virtual students did, as a file that the grader never sees."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path

from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.machine.files import write_text
from gripcourse.simulation.arithmetic import DigitRounding
from gripcourse.simulation.model import (
    Action,
    ActionKind,
    Behaviour,
    Carrying,
    Conduct,
    SimulatedWork,
    Style,
)
from gripcourse.slips.model import SlipId
from gripcourse.text.words import Message, message

_FORMAT = 1


def write_truth(path: Path, works: Sequence[SimulatedWork]) -> None:
    """Write what was done, a line for each student."""
    lines = (
        json.dumps({"format": _FORMAT, **_fields(work)}, ensure_ascii=False, allow_nan=False)
        for work in works
    )
    write_text(path, "".join(f"{line}\n" for line in lines))


def _fields(work: SimulatedWork) -> dict[str, object]:
    actions = [
        {
            **asdict(action),
            "slip": "" if action.slip is None else str(action.slip),
            "twins": [str(slip) for slip in action.twins],
        }
        for action in work.actions
    ]
    return {**asdict(work), "actions": actions}


def read_truth(path: Path) -> tuple[SimulatedWork, ...]:
    """Read what was done.

    Raises:
        UsageError: there is no such file, or it is none of these.
    """
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except FileNotFoundError:
        raise _failure(path, message("There is no such file or folder.")) from None
    try:
        return tuple(_work(json.loads(line)) for line in lines)
    except (json.JSONDecodeError, KeyError, TypeError, ValueError) as fault:
        what = message("The file is damaged: {fault}.", fault=repr(fault))
        raise _failure(path, what) from fault


def _work(written: Mapping[str, object]) -> SimulatedWork:
    if written["format"] != _FORMAT:
        raise ValueError(written["format"])
    fields = {name: value for name, value in written.items() if name != "format"}
    actions = fields["actions"]
    if not isinstance(actions, list):
        raise TypeError(actions)
    read = {
        **fields,
        "behaviour": _behaviour(fields["behaviour"]),
        "actions": tuple(_action(one) for one in actions),
    }
    return SimulatedWork(**read)  # type: ignore[arg-type]  # a field that is missing raises


def _behaviour(written: object) -> Behaviour:
    if not isinstance(written, dict):
        raise TypeError(written)
    return Behaviour(
        **{
            **written,
            "conduct": Conduct(written["conduct"]),
            "rounding": DigitRounding(written["rounding"]),
            "carrying": Carrying(written["carrying"]),
            "style": Style(written["style"]),
        }
    )


def _action(written: object) -> Action:
    if not isinstance(written, dict):
        raise TypeError(written)
    slip = written["slip"]
    return Action(
        **{
            **written,
            "done": ActionKind(written["done"]),
            "slip": SlipId.parse(slip) if slip else None,
            "twins": tuple(SlipId.parse(one) for one in written["twins"]),
        }
    )


def _failure(path: Path, what: Message) -> UsageError:
    remedy = message("Make the cohort again.")
    return UsageError([Problem(str(path), "", what, remedy, step=NextStep.SIMULATE)])
