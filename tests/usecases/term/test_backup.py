"""A term in one file: whole, the same from and into either database, refused where damaged."""

import hashlib
import json
import shutil
import stat
import threading
import zipfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import pytest

from gripcourse.access.desk.store import open_desk
from gripcourse.cli.demo.students import correct
from gripcourse.errors import (
    CourseError,
    GradebookError,
    GripcourseError,
    RegisterError,
    UsageError,
)
from gripcourse.gradebook.checks import CheckLedger, take_one
from gripcourse.gradebook.store import open_gradebook
from gripcourse.issuing.store import read_register
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.database.home import home_of
from gripcourse.usecases.grading.grade import grade
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import hand_in, kept_path
from gripcourse.usecases.term.backup import MANIFEST, back_up
from gripcourse.usecases.term.restore import restore
from support.classroom import KEY

if TYPE_CHECKING:
    from support.classroom import Classroom
    from support.postgres import Server

NOW: Final = datetime(2026, 12, 9, 9, 0, 0, 1, UTC)
Members = dict[str, bytes]


@dataclass(frozen=True, slots=True)
class Term:
    """A course in the middle of its term, and a backup of it."""

    root: Path
    backup: Path

    @property
    def members(self) -> Members:
        with zipfile.ZipFile(self.backup) as archive:
            return {name: archive.read(name) for name in archive.namelist()}


@pytest.fixture(scope="module")
def term(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> Term:
    """A work was checked, handed in and graded; somebody may sign in."""
    folder = tmp_path_factory.mktemp("term")
    root = folder / "course"
    shutil.copytree(issued.course.root, root)
    work = issued.hand_in("s01", correct, folder / "s01.xlsx")
    desk = open_desk(home_of(root), issued.course.id)
    course = desk_context(issued, root)
    hand_in(course, issued.register["s01"], NamedBytes("Звіт.xlsx", work.read_bytes()), NOW)
    desk.add_sign_in("token", "Петров", NOW)
    keep(grade([work], issued.context, 0, lambda _: None), issued.context, home_of(root), NOW)
    take_one(CheckLedger(root / "private" / "checks.sqlite", "s01"), 3)
    back_up(root, folder / "term.zip", NOW)
    return Term(root, folder / "term.zip")


def desk_context(issued: "Classroom", root: Path) -> DeskContext:
    course = replace(issued.course, root=root)
    return DeskContext(course, issued.policy, KEY, open_desk(home_of(root), course.id))


@pytest.fixture
def empty(postgresql: "Server") -> Iterator[str]:
    with postgresql.database("TEMPLATE template0") as place:
        yield place


def said_of(backup: Path) -> Mapping[str, Any]:
    with zipfile.ZipFile(backup) as archive:
        found: Mapping[str, Any] = json.loads(archive.read(MANIFEST))["members"]
    return found


def refused(backup: Path, root: Path, place: str | None = None) -> str:
    with pytest.raises(GripcourseError) as caught:
        restore(backup, root, place)
    assert not root.exists()
    assert [one for one in root.parent.iterdir() if one.name.startswith(".")] == []
    return str(caught.value)


class TestTheWholeTerm:
    def test_it_moves_from_a_file_to_a_server_and_back_unchanged(
        self, term: Term, empty: str, tmp_path: Path
    ) -> None:
        restore(term.backup, tmp_path / "served", empty)
        assert home_of(tmp_path / "served") == empty
        back_up(tmp_path / "served", tmp_path / "second.zip", NOW)
        restore(tmp_path / "second.zip", tmp_path / "filed")
        back_up(tmp_path / "filed", tmp_path / "third.zip", NOW)
        assert said_of(term.backup) == said_of(tmp_path / "second.zip")
        assert term.backup.read_bytes() == (tmp_path / "third.zip").read_bytes()

    def test_everything_stands_as_it_did(
        self, term: Term, issued: "Classroom", tmp_path: Path
    ) -> None:
        root = tmp_path / "restored" / "course"
        restore(term.backup, root)
        id_ = issued.course.id
        assert read_register(root, id_) == read_register(term.root, id_)
        assert open_gradebook(home_of(root)).attempts()
        context = desk_context(issued, root)
        (kept,) = context.desk.hand_ins()
        content = kept_path(context, kept.digest).read_bytes()
        assert hashlib.sha256(content).hexdigest() == kept.digest
        assert take_one(CheckLedger(root / "private" / "checks.sqlite", "s01"), 3) == 1
        for one in (root / "private").rglob("*"):
            assert stat.S_IMODE(one.stat().st_mode) & 0o077 == 0

    def test_it_is_made_while_somebody_is_amid_a_change_of_the_course(
        self, term: Term, tmp_path: Path
    ) -> None:
        root = tmp_path / "course"
        shutil.copytree(term.root, root)
        policy, catalogue = root / "grader" / "policy.toml", next(root.rglob("catalogues/*.csv"))
        policy.write_text("[half a li", encoding="utf-8")
        catalogue.unlink()
        back_up(root, tmp_path / "amid.zip", NOW)
        restore(tmp_path / "amid.zip", tmp_path / "restored")
        assert (tmp_path / "restored" / "grader" / "policy.toml").read_text() == "[half a li"
        assert not (tmp_path / "restored" / catalogue.relative_to(root)).exists()

    def test_a_course_without_an_id_is_refused(self, term: Term, tmp_path: Path) -> None:
        root = tmp_path / "course"
        shutil.copytree(term.root, root)
        main = root / "variants" / "course.toml"
        main.write_text("[half a li", encoding="utf-8")
        with pytest.raises(CourseError, match=r"course\.toml"):
            back_up(root, tmp_path / "amid.zip", NOW)
        assert not (tmp_path / "amid.zip").exists()

    def test_nobody_is_signed_in_by_it(self, term: Term) -> None:
        assert not {"tables/desk_sign_in.jsonl", "tables/desk_session.jsonl"} & set(term.members)

    def test_missing_folders_above_it_are_made(self, term: Term, tmp_path: Path) -> None:
        out = tmp_path / "nights" / "term.zip"
        back_up(term.root, out, NOW)
        assert zipfile.is_zipfile(out)

    def test_only_its_owner_reads_it(self, term: Term) -> None:
        assert stat.S_IMODE(term.backup.stat().st_mode) == 0o600

    def test_an_earlier_programs_is_brought_up(
        self, term: Term, issued: "Classroom", tmp_path: Path
    ) -> None:
        later = {"version", "either_version", "declarations", "issued_by", "why"}
        later |= {"results_digest"}
        made = changed(term, tmp_path, lambda members: _without(members, later), revision="4")
        restore(made, tmp_path / "course")
        found = read_register(tmp_path / "course", issued.course.id)
        assert set(found.by_student()) == {"s01", "s02", "s03"}

    def test_what_is_handed_in_meanwhile_is_there_whole_or_not_at_all(
        self, term: Term, issued: "Classroom", tmp_path: Path
    ) -> None:
        root, over = tmp_path / "course", threading.Event()
        shutil.copytree(term.root, root)
        context, number = desk_context(issued, root), 0

        def students() -> None:
            nonlocal number
            while not over.is_set():
                number += 1
                file = NamedBytes("a.xlsx", b"work %d" % number)
                hand_in(context, issued.register["s02"], file, NOW)

        writer = threading.Thread(target=students)
        writer.start()
        back_up(root, tmp_path / "term.zip", NOW)
        over.set()
        writer.join()
        restore(tmp_path / "term.zip", tmp_path / "restored")
        restored = desk_context(issued, tmp_path / "restored")
        kept = restored.desk.hand_ins()
        assert all(kept_path(restored, one.digest).is_file() for one in kept)
        assert [one.number for one in restored.desk.hand_ins("s02")] == list(range(1, len(kept)))
        assert number > 0


class TestNothingIsOverwritten:
    def test_a_backup(self, term: Term) -> None:
        before = term.backup.read_bytes()
        with pytest.raises(UsageError, match="exists already"):
            back_up(term.root, term.backup, NOW)
        assert term.backup.read_bytes() == before

    def test_a_folder_with_anything_in_it(self, term: Term, tmp_path: Path) -> None:
        (tmp_path / "mine").touch()
        with pytest.raises(UsageError, match="something already"):
            restore(term.backup, tmp_path)
        assert [one.name for one in tmp_path.iterdir()] == ["mine"]

    def test_a_database_with_anything_in_it(self, term: Term, empty: str, tmp_path: Path) -> None:
        restore(term.backup, tmp_path / "first", empty)
        before = open_gradebook(empty).attempts()
        assert "something already" in refused(term.backup, tmp_path / "second", empty)
        assert open_gradebook(empty).attempts() == before


def changed(
    term: Term,
    folder: Path,
    change: Callable[[Members], object],
    *,
    told: bool = True,
    **said: object,
) -> Path:
    """Write the backup anew with other members; where `told`, its manifest agrees with them."""
    members = term.members
    manifest = json.loads(members.pop(MANIFEST))
    change(members)
    if told:
        manifest["members"] = {
            name: {"size": len(data), "sha256": hashlib.sha256(data).hexdigest()}
            for name, data in members.items()
        }
    path = folder / "changed.zip"
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in members.items():
            archive.writestr(name, data)
        archive.writestr(MANIFEST, json.dumps({**manifest, **said}))
    return path


LATER_TABLES = (
    *("tables/lti_", "tables/desk_batch", "tables/register_withdrawal", "tables/gradebook_word"),
)


def _without(members: Members, columns: set[str]) -> None:
    """Take columns out of all tables, and tables out that came later still."""
    for name in [one for one in members if one.startswith(LATER_TABLES)]:
        del members[name]
    for name in [one for one in members if one.startswith("tables/")]:
        head, *rows = [json.loads(line) for line in members[name].splitlines()]
        # The register had versions, and waivers a reason, before revision 5.
        added = columns if name.endswith("attempt.jsonl") else columns - {"version"}
        added = added if name.endswith(("attempt.jsonl", "issued.jsonl")) else set()
        left = [place for place, column in enumerate(head) if column not in added]
        lines = [json.dumps([row[place] for place in left]) for row in (head, *rows)]
        members[name] = "\n".join(lines).encode()


class TestWhatIsDamagedOrStrange:
    @pytest.mark.parametrize("share", [0.0, 0.2, 0.5, 0.9])
    def test_a_byte_that_is_another(self, term: Term, tmp_path: Path, share: float) -> None:
        data = bytearray(term.backup.read_bytes())
        data[int(share * len(data))] ^= 0xFF
        (tmp_path / "damaged.zip").write_bytes(data)
        assert refused(tmp_path / "damaged.zip", tmp_path / "course")

    def test_an_end_that_is_missing(self, term: Term, tmp_path: Path) -> None:
        (tmp_path / "damaged.zip").write_bytes(term.backup.read_bytes()[:-1])
        assert refused(tmp_path / "damaged.zip", tmp_path / "course")

    @pytest.mark.parametrize("content", [b"", b"PK", b"a text"])
    def test_what_is_no_backup(self, tmp_path: Path, content: bytes) -> None:
        (tmp_path / "none.zip").write_bytes(content)
        assert "damaged, or is none" in refused(tmp_path / "none.zip", tmp_path / "course")

    @pytest.mark.parametrize(
        "name",
        [
            "course/../../escaped",
            "course/variants/../../escaped",
            "/tmp/escaped",  # noqa: S108 (must not be written)
            "escaped",
            "course/escaped",
            "course/private/database",
            "course/private/gradebook.sqlite",
            "course/private/.hidden",
            "course/variants\\..\\escaped",
            "course//variants/escaped",
            "tables/sqlite_master.jsonl",
            "tables/../escaped.jsonl",
            "tables/desk_session.jsonl",
        ],
    )
    def test_a_name_that_leads_elsewhere(self, term: Term, tmp_path: Path, name: str) -> None:
        made = changed(term, tmp_path, lambda members: members.update({name: b'["a"]\n'}))
        assert "damaged, or is none" in refused(made, tmp_path / "course")
        assert [one.name for one in tmp_path.iterdir()] == ["changed.zip"]

    @pytest.mark.parametrize("name", ["course/private/key", "tables/register_issued.jsonl"])
    def test_a_member_that_is_missing_or_not_what_it_was(
        self, term: Term, tmp_path: Path, name: str
    ) -> None:
        missing = changed(term, tmp_path, lambda members: members.pop(name), told=False)
        assert "damaged" in refused(missing, tmp_path / "course")
        other = changed(
            term, tmp_path, lambda members: members.update({name: members[name] + b" "}), told=False
        )
        assert name in refused(other, tmp_path / "course")

    def test_a_link_is_written_as_the_text_that_it_is(self, term: Term, tmp_path: Path) -> None:
        made = changed(term, tmp_path, lambda _: None)
        name = "course/variants/link.toml"
        with zipfile.ZipFile(made, "a") as archive:
            link = zipfile.ZipInfo(name)
            link.external_attr = (stat.S_IFLNK | 0o777) << 16
            archive.writestr(link, "/etc/passwd")
        assert "damaged" in refused(made, tmp_path / "course")

    def test_more_than_the_disk_holds(self, term: Term, tmp_path: Path) -> None:
        huge = {"course/private/handed_in/a": {"size": 1 << 62, "sha256": "0" * 64}}
        made = changed(
            term,
            tmp_path,
            lambda members: (members.clear(), members.update(dict.fromkeys(huge, b""))),
            told=False,
            members=huge,
        )
        assert "no room" in refused(made, tmp_path / "course")

    def test_one_of_a_later_program(self, term: Term, tmp_path: Path) -> None:
        for said in ({"format": 2}, {"revision": "99"}):
            made = changed(term, tmp_path, lambda _: None, **said)
            assert "later version" in refused(made, tmp_path / "course")

    def test_numbers_that_were_not_issued(self, term: Term, empty: str, tmp_path: Path) -> None:
        def forge(members: Members) -> None:
            name = "tables/register_issued.jsonl"
            members[name] = members[name].replace(b"60.0", b"6.0", 1)

        made = changed(term, tmp_path, forge)
        for place in (None, empty):
            with pytest.raises(RegisterError, match="was changed"):
                restore(made, tmp_path / "course", place)
            assert not (tmp_path / "course").exists()
        assert open_gradebook(empty).attempts() == ()

    @pytest.mark.parametrize("row", ["[1]", '{"a": 1}', "[", '["s01", 1e999]', "null"])
    def test_rows_that_are_none(self, term: Term, tmp_path: Path, row: str) -> None:
        def spoil(members: Members) -> None:
            members["tables/gradebook_attempt.jsonl"] += row.encode()

        assert "gradebook_attempt" in refused(changed(term, tmp_path, spoil), tmp_path / "course")

    def test_a_database_that_cannot_be_reached_leaves_nothing(
        self, term: Term, tmp_path: Path
    ) -> None:
        place = "postgresql://teacher:secret@127.0.0.1:1/course"
        with pytest.raises(GradebookError, match="cannot be reached") as caught:
            restore(term.backup, tmp_path / "course", place)
        assert "secret" not in str(caught.value)
        assert list(tmp_path.iterdir()) == []
