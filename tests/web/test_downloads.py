"""An instructor takes everything home, published or not; a student takes nothing of it."""

import io
import zipfile
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

import pytest

from gripcourse.machine.content import NamedBytes
from gripcourse.usecases.grading.batch_tables import FILES_CSV, GRADES_CSV
from gripcourse.usecases.grading.grade import COHORT_PDF, REPORTS
from gripcourse.usecases.publishing.downloads import hand_ins_to_pack
from gripcourse.usecases.serving.hand_in import hand_in, kept_path

if TYPE_CHECKING:
    from starlette.testclient import TestClient

    from web.conftest import Server

NAMES = ("../../private/key", "C:\\Windows\\x.xlsx", "con:<1>|?.xlsx", "..", "Звіт.xlsx", "вид.svg")
GRADED = (GRADES_CSV, FILES_CSV, COHORT_PDF)
BASES = ("/desk", "/api/v1/desk")


@pytest.fixture
def graded(server: "Server") -> Iterator[Path]:
    """What a batch left, beside a link to what is no report."""
    folder = server.graded / REPORTS
    folder.mkdir(parents=True, exist_ok=True)
    secret = server.classroom.course.root / "private" / "key"
    made = [server.graded / name for name in GRADED] + [folder / "s02.pdf", folder / "link.pdf"]
    before = {one: one.read_bytes() for one in made if one.is_file()}
    for one in made[:-1]:
        one.write_bytes(one.name.encode())
    made[-1].symlink_to(secret)
    yield server.graded
    for one in made:
        one.unlink()
    for one, data in before.items():
        one.write_bytes(data)


@pytest.fixture
def instructor(signed_in: "TestClient") -> "TestClient":
    """A browser of the desk, whose session is a program's token as well."""
    signed_in.headers["Authorization"] = f"Bearer {signed_in.cookies['gripcourse-desk']}"
    return signed_in


@pytest.mark.parametrize("base", BASES)
def test_every_file_is_in_one_zip_and_its_names_lead_nowhere(
    server: "Server", instructor: "TestClient", base: str
) -> None:
    issued, now = server.classroom.register["s03"], server.clock.now
    for number, name in enumerate(NAMES):
        hand_in(server.context, issued, NamedBytes(name, f"PK {base} {number}".encode()), now)
    kept = server.context.desk.hand_ins()
    answer = instructor.get(f"{base}/hand-ins.zip")
    assert answer.headers["content-type"] == "application/zip"
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        assert archive.testzip() is None
        packed = {one: archive.read(one) for one in archive.namelist()}
    assert len(packed) == len(kept)
    assert sorted(packed.values()) == sorted(
        kept_path(server.context, one.digest).read_bytes() for one in kept
    )
    assert packed["s03.xlsx"] == f"PK {base} 4".encode()
    for name in packed:
        parts = PurePosixPath(name).parts
        assert len(parts) <= 2
        assert not {".", "..", "/"} & set(parts)
        assert not set('\\:<>"|?*') & set(name)


@pytest.mark.parametrize("base", BASES)
def test_what_was_graded_is_there_before_students_see_it(
    graded: Path, instructor: "TestClient", base: str
) -> None:
    for name in GRADED:
        answer = instructor.get(f"{base}/graded/{name}")
        assert (answer.status_code, answer.content) == (200, name.encode())
    reports = instructor.get(f"{base}/graded/reports.zip").content
    with zipfile.ZipFile(io.BytesIO(reports)) as archive:
        expected = {one.name for one in (graded / REPORTS).glob("*.pdf")} - {"link.pdf"}
        assert set(archive.namelist()) == expected
        assert archive.read("s02.pdf") == b"s02.pdf"
    for other in ("grades.json", "..%2f..%2fprivate%2fkey", "%2e%2e/grades.csv", "link.pdf"):
        assert instructor.get(f"{base}/graded/{other}").status_code == 404
    if base == "/desk":
        page = instructor.get("/desk/grading").text
        assert all(f"graded/{name}" in page for name in (*GRADED, "reports.zip"))


@pytest.mark.usefixtures("graded")
def test_a_students_link_downloads_nothing_of_the_desk(server: "Server") -> None:
    client, home = server.client(), server.home("s02")
    token = home.split("/")[2]
    paths = ("hand-ins.zip", "graded/reports.zip", *(f"graded/{name}" for name in GRADED))
    headers = {"Authorization": f"Bearer {token}", "Cookie": f"gripcourse-desk={token}"}
    for path in paths:
        assert client.get(f"/desk/{path}", headers=headers).status_code == 403
        assert client.get(f"/api/v1/desk/{path}", headers=headers).status_code == 401
        assert client.get(f"{home}{path}").status_code == 404


def test_a_lost_file_is_said_and_no_half_a_zip_is_sent(
    server: "Server", instructor: "TestClient"
) -> None:
    issued, now = server.classroom.register["s03"], server.clock.now
    hand_in(server.context, issued, NamedBytes("lost.xlsx", b"to be lost"), now)
    path = hand_ins_to_pack(server.context)[-1].path
    elsewhere = path.rename(path.with_name("elsewhere"))
    answer = instructor.get("/desk/hand-ins.zip")
    elsewhere.rename(path)
    assert answer.status_code == 503
