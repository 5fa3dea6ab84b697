"""A batch of which all is as an earlier run left it: nothing is done, the same is said again.

Whatever decides over grades, reports or words is compared by its content: the files, the course and
this program, what the gradebook and the register say, every option, and all results. Where one of
them differs, the batch is graded, and what is known of single files is taken over.
"""

import json
import os
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from itertools import chain
from pathlib import Path
from typing import Final

from gripcourse.gradebook.state import DatabaseState, state_of
from gripcourse.issuing.register_file import old_register_path
from gripcourse.issuing.signature import key_path
from gripcourse.machine.content import Readable, digest_of_content, shown_name
from gripcourse.machine.database.home import home_of
from gripcourse.machine.files import write_text
from gripcourse.machine.resources import deadlines_path
from gripcourse.usecases.grading.collect import Collected
from gripcourse.usecases.grading.versions import EARLIER, digest_of_texts, versions_of

_SAID: Final = "said.json"
_REPORTS: Final = "reports"


@dataclass(frozen=True, slots=True)
class GradingAsked:
    """What a run is asked for.

    Attributes:
        root: folder of the course.
        place: of the gradebook.
        out: folder of the results.
        found: files of the batch.
        options: all else that decides over what is done or said.
    """

    root: Path
    place: str
    out: Path
    found: Collected
    options: tuple[object, ...]


@dataclass(frozen=True, slots=True)
class SaidAtEnd:
    """What a run said at its end.

    Attributes:
        course: id.
        whole: all of it.
        problems: what must be said even where nothing else is.
        needs_person: whether something waits for a person.
    """

    course: str
    whole: str
    problems: str
    needs_person: bool


@dataclass(frozen=True, slots=True)
class Beginning:
    """How everything stood before a run did anything.

    Attributes:
        asked: for what.
        versions: of the course; see `versions_of`.
        around: digest of options, times of files and what else a person may have changed.
        states: of the databases.
    """

    asked: GradingAsked
    versions: str
    around: str
    states: tuple[DatabaseState, ...]

    def said_before(self) -> SaidAtEnd | None:
        """Return what an earlier run said, where all is as it left it; None where it is not."""
        try:
            kept = json.loads(_said_path(self.asked.out).read_text(encoding="utf-8"))
            said = SaidAtEnd(**kept["said"])
            # What takes longest to read comes last: mostly something else differs already.
            same = (
                kept["key"] == self._key(self.states)
                and kept["files"] == digest_of_texts(_digests(self.asked))
                and kept["results"] == _results(self.asked.out)
            )
        except (OSError, ValueError, TypeError, KeyError):  # none yet, or damaged
            return None
        return said if same else None

    def keep(self, said: SaidAtEnd, digests: Iterable[str], moment: datetime) -> None:
        """Keep what this run says, unless somebody else changed the gradebook meanwhile.

        Args:
            said: at the end.
            digests: of the files, of the very bytes that were graded.
            moment: of the attempts that this run added.
        """
        states = _states(self.asked, moment)
        if [one.others for one in states] != [one.whole for one in self.states]:
            return
        kept = {
            "key": self._key(states),
            "files": digest_of_texts(digests),
            "results": _results(self.asked.out),
            "said": asdict(said),
        }
        # Whoever may not write there grades again.
        with suppress(OSError):
            write_text(_said_path(self.asked.out), json.dumps(kept), private=True)

    def _key(self, states: Iterable[DatabaseState]) -> str:
        return digest_of_texts([self.versions, self.around, *(one.whole for one in states)])


def beginning(asked: GradingAsked) -> Beginning:
    """Look at everything before a run.

    Raises:
        GradebookError: the database cannot be used.
        OSError: a file of the course cannot be read.
    """
    people = (deadlines_path, key_path, old_register_path)
    around = chain(
        [repr((asked.place, asked.options, asked.found.passed_over))],
        map(_named_with_time, asked.found.files),
        (digest_of_content(path_of(asked.root)) for path_of in people),
        map(str, sorted((asked.root / "private").glob("declarations/*.zip"))),
    )
    now = datetime.now(UTC)
    return Beginning(asked, versions_of(asked.root), digest_of_texts(around), _states(asked, now))


def _states(asked: GradingAsked, moment: datetime) -> tuple[DatabaseState, ...]:
    places = dict.fromkeys((asked.place, home_of(asked.root)))
    return tuple(state_of(place, moment) for place in places)


def _named_with_time(file: Readable) -> str:
    """Tell a file's name and time, which is when it was handed in where nobody says otherwise."""
    time = file.stat().st_mtime_ns if isinstance(file, Path) and file.exists() else 0
    return repr((shown_name(file), time))


def _digests(asked: GradingAsked) -> Iterable[str]:
    return map(digest_of_content, asked.found.files)


def _results(out: Path) -> str:
    """Digest all files of the results: those of the folder itself and the students' reports."""
    # Names alone: a path of each of ten thousand reports takes ten times the room.
    told = (
        repr((str(folder.relative_to(out)), name, digest_of_content(folder / name)))
        for folder in (out, out / _REPORTS)
        for name in _files_in(folder)
    )
    return digest_of_texts(told)


def _files_in(folder: Path) -> Sequence[str]:
    if not folder.is_dir():
        return ()
    with os.scandir(folder) as found:
        return sorted(one.name for one in found if one.is_file())


def _said_path(out: Path) -> Path:
    return out / EARLIER / _SAID
