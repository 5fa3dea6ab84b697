"""Every file under a folder is graded or named with the reason why it is not."""

import errno
import os
from pathlib import Path
from zipfile import ZIP_LZMA, ZIP_STORED, ZipFile

import pytest

from gripcourse.errors import UsageError
from gripcourse.machine.content import shown_name
from gripcourse.usecases.grading.collect import REASONS, WhyNot, collect
from hostile.small_workbook import PARTS, archive


def made(folder: Path, *names: str) -> Path:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"")
    return folder


def test_workbooks_are_graded_whatever_folder_they_are_in(tmp_path: Path) -> None:
    made(tmp_path, "b.XLSX", "a.ods", "каталог.xlsx/c.xls")
    found = collect([tmp_path])
    assert [path.name for path in found.files] == ["a.ods", "b.XLSX", "c.xls"]
    assert found.passed_over == ()


@pytest.mark.parametrize(
    ("name", "why", "needs_person"),
    [
        ("work.zip", WhyNot.ARCHIVE, True),
        ("work.RAR", WhyNot.ARCHIVE, True),
        ("note.docx", WhyNot.TEXT_DOCUMENT, True),
        ("answers", WhyNot.NO_EXTENSION, True),
        ("~$a.xlsx", WhyNot.LOCK_FILE, False),
        (".~lock.a.xlsx#", WhyNot.LOCK_FILE, False),
        (".DS_Store", WhyNot.HIDDEN, False),
        ("drawing.pdf", WhyNot.OTHER, False),
    ],
)
def test_every_other_file_is_named_with_the_reason(
    tmp_path: Path,
    name: str,
    why: WhyNot,
    needs_person: bool,  # noqa: FBT001 (a parameter of the test)
) -> None:
    made(tmp_path, "a.xlsx", f"s01/{name}")
    (one,) = collect([tmp_path]).passed_over
    assert (Path(one.file).name, one.why, one.needs_person) == (name, why, needs_person)


def test_no_link_in_a_folder_is_followed_and_each_is_named(tmp_path: Path) -> None:
    work, other = tmp_path / "work", tmp_path / "other"
    made(other, "theirs.xlsx")
    made(work, "a.xlsx")
    targets = {"b.xlsx": other / "gone.xlsx", "c.xlsx": other / "theirs.xlsx", "d": other}
    for name, target in targets.items():
        (work / name).symlink_to(target)
    found = collect([work])
    assert found.files == (work / "a.xlsx",)
    named = {Path(one.file).name: (one.why, one.needs_person) for one in found.passed_over}
    assert named == dict.fromkeys(targets, (WhyNot.LINK, True))


def test_a_folder_that_may_not_be_looked_into_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made(tmp_path, "a.xlsx", "s01/b.xlsx", "s02/c.xlsx", "s03/d.xlsx")
    scan, access = os.scandir, os.access

    def refused(path: str) -> object:
        if str(path).endswith("s01"):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), path)
        return scan(path)

    def allowed(path: str, what: int) -> bool:
        return not (str(path).endswith("s02") and what == os.X_OK) and access(path, what)

    monkeypatch.setattr(os, "scandir", refused)
    monkeypatch.setattr(os, "access", allowed)
    found = collect([tmp_path])
    assert [path.name for path in found.files] == ["a.xlsx", "d.xlsx"]
    assert [(Path(one.file).name, one.why, one.needs_person) for one in found.passed_over] == [
        ("s01", WhyNot.CLOSED, True),
        ("s02", WhyNot.CLOSED, True),
    ]


def test_a_link_that_a_person_names_is_followed(tmp_path: Path) -> None:
    made(tmp_path, "a.xlsx")
    link = tmp_path / "link.xlsx"
    link.symlink_to(tmp_path / "a.xlsx")
    assert collect([link]).files == (link,)


def test_every_reason_has_its_sentence() -> None:
    assert set(REASONS) == set(WhyNot)


def test_a_file_named_twice_is_graded_once(tmp_path: Path) -> None:
    made(tmp_path, "a.xlsx", "b.xlsx")
    assert len(collect([tmp_path / "a.xlsx", tmp_path, tmp_path / "a.xlsx"]).files) == 2


def test_a_file_that_is_named_is_graded_whatever_its_suffix(tmp_path: Path) -> None:
    made(tmp_path, "work.docx", "a.xlsx")
    found = collect([tmp_path, tmp_path / "work.docx"])
    assert {path.name for path in found.files} == {"work.docx", "a.xlsx"}
    assert found.passed_over == ()


@pytest.mark.parametrize("content", [b"", b"<html>Sign in</html>", b"PK\x03\x04 broken off"])
def test_a_zip_that_broke_off_is_nobodys_work(content: bytes, tmp_path: Path) -> None:
    made(tmp_path, "a.xlsx")
    (tmp_path / "RGR.zip").write_bytes(content)
    with pytest.raises(UsageError, match=r"RGR\.zip.*no zip that can be read"):
        collect([tmp_path / "RGR.zip", tmp_path / "a.xlsx"])


def test_all_paths_that_are_not_there_are_named_at_once(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught:
        collect([tmp_path / "a.xlsx", tmp_path / "b"])
    assert [problem.file for problem in caught.value.problems] == [
        str(tmp_path / "a.xlsx"),
        str(tmp_path / "b"),
    ]


def test_a_folder_without_workbooks_is_refused_and_says_what_is_there(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="no workbook"):
        collect([tmp_path])
    with pytest.raises(UsageError, match=r"work\.zip"):
        collect([made(tmp_path, "work.zip")])


def zipped(path: Path, *names: str) -> Path:
    with ZipFile(path, "w") as archive:
        for name in names:
            archive.writestr(name, b"")
    return path


def test_a_zip_that_is_named_is_looked_into(tmp_path: Path) -> None:
    inside = "Иванова Анна_12_assignsubmission_file"
    path = zipped(tmp_path / "РГР.zip", f"{inside}/s01.xlsx", f"{inside}/own.zip", "../evil.xlsx")
    found = collect([path])
    assert [shown_name(one) for one in found.files] == [f"{path}/{inside}/s01.xlsx"]
    assert {(Path(one.file).name, one.why) for one in found.passed_over} == {
        ("own.zip", WhyNot.ARCHIVE),
        ("evil.xlsx", WhyNot.UNSAFE_PATH),
    }
    assert all(one.needs_person for one in found.passed_over)


WORKBOOK = archive(PARTS)
TEXT = archive({"[Content_Types].xml": b"<Types/>", "word/document.xml": b"<w/>"})
OPEN_DOCUMENT = archive(
    {"mimetype": b"application/vnd.oasis.opendocument.spreadsheet", "content.xml": b"<x/>"},
    ZIP_STORED,
)
NO_WORKBOOK_EITHER = {
    "a.docx": TEXT,
    "b.zip": archive({"answers.xlsx": WORKBOOK}),
    "c.zip": archive({"s01/[Content_Types].xml": b"", "s01/xl/workbook.xml": b""}),
    "d.zip": WORKBOOK[: len(WORKBOOK) // 2],
    "e": b"PK\x03\x04",
    "f.pdf": b"%PDF-1.7",
    "g.docx": b"",
    # Packed as they are, works have their lists of members inside; so has half of a download.
    "h.zip": archive({"s01.xlsx": WORKBOOK, "s02.xlsx": WORKBOOK}, ZIP_STORED),
    "i.zip": archive({"s01.xlsx": WORKBOOK, "s02.txt": b"?"}, ZIP_STORED).partition(b"s02.txt")[0],
}


@pytest.mark.parametrize(
    ("name", "content"),
    [
        *((name, WORKBOOK) for name in ("a.zip", "a.docx", "a.XLSX_", "a", "a.pdf", "a.7z")),
        ("a.zip", archive({name.replace("/", "\\"): data for name, data in PARTS.items()})),
        ("a.zip", archive({"[Content_Types].xml": b"", "xl/workbook.bin": b""})),
        ("a.zip", OPEN_DOCUMENT),
    ],
)
def test_a_workbook_is_graded_whatever_it_is_called(
    name: str, content: bytes, tmp_path: Path
) -> None:
    (tmp_path / "work").mkdir()
    (tmp_path / "work" / name).write_bytes(content)
    assert collect([tmp_path / "work"]).files == (tmp_path / "work" / name,)
    assert collect([tmp_path / "work" / name]).files == (tmp_path / "work" / name,)
    packed = tmp_path / "all.zip"
    packed.write_bytes(archive({f"s01/{name}": content}))
    assert [shown_name(one) for one in collect([packed]).files] == [f"{packed}/s01/{name}"]


def test_what_is_no_workbook_by_its_name_nor_by_its_content_is_named(tmp_path: Path) -> None:
    (tmp_path / "all.zip").write_bytes(archive({**NO_WORKBOOK_EITHER, "s01.xlsx": WORKBOOK}))
    found = collect([tmp_path / "all.zip"])
    assert [Path(shown_name(one)).name for one in found.files] == ["s01.xlsx"]
    assert [(Path(one.file).name, one.why.value) for one in found.passed_over] == [
        ("a.docx", "text_document"),
        ("b.zip", "archive"),
        ("c.zip", "archive"),
        ("d.zip", "archive"),
        ("e", "no_extension"),
        ("f.pdf", "other"),
        ("g.docx", "text_document"),
        ("h.zip", "archive"),
        ("i.zip", "archive"),
    ]


def test_a_workbook_in_a_hidden_file_waits_for_a_person(tmp_path: Path) -> None:
    made(tmp_path, "a.xlsx")
    (tmp_path / ".b.xlsx").write_bytes(WORKBOOK)
    assert [(one.why, one.needs_person) for one in collect([tmp_path]).passed_over] == [
        (WhyNot.HIDDEN_WORKBOOK, True)
    ]


def test_a_lock_file_is_none_whatever_is_in_it(tmp_path: Path) -> None:
    made(tmp_path, "a.xlsx")
    (tmp_path / "~$b.zip").write_bytes(WORKBOOK)
    assert [one.why for one in collect([tmp_path]).passed_over] == [WhyNot.LOCK_FILE]


def test_a_zip_of_works_that_cannot_be_unpacked_says_why(tmp_path: Path) -> None:
    packed = tmp_path / "all.zip"
    packed.write_bytes(archive({"s01.xlsx": WORKBOOK, "s02.xlsx": WORKBOOK}, ZIP_LZMA))
    with pytest.raises(
        UsageError, match=r"only 2 other files: s01\.xlsx, s02\.xlsx\. It is packed"
    ):
        collect([packed])
    mixed = archive({"s01.xlsx": WORKBOOK}, ZIP_LZMA)
    packed.unlink()
    made(tmp_path, "b.docx", "c.zip")
    (tmp_path / "c.zip").write_bytes(mixed)
    with pytest.raises(UsageError, match=r"b\.docx, c\.zip\. Name a workbook"):
        collect([tmp_path])
