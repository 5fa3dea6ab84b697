"""What an administrator copies: units, the web server before ours, containers."""

import re
import shutil
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from starlette.testclient import TestClient
from uvicorn.middleware.proxy_headers import ProxyHeadersMiddleware

from gripcourse.usecases.serving.living import LivingCourse
from gripcourse.web.app import make_app
from gripcourse.web.checking import make_checkers
from gripcourse.web.guard import LARGEST_BODY
from gripcourse.web.rates import REFUSED_LINKS
from gripcourse.web.serve import Serving, look_into
from gripcourse.web.site import Site

if TYPE_CHECKING:
    from web.conftest import Server

DEPLOY = Path(__file__).parents[2] / "deploy"
UNITS = ("gripcourse.service", "gripcourse-backup.service", "gripcourse-backup.timer")


def test_units_are_as_systemd_wants_them_and_give_few_rights(tmp_path: Path) -> None:
    analyze = shutil.which("systemd-analyze")
    if analyze is None:
        pytest.skip("systemd is not installed")
    for name in UNITS:
        # Nobody has our program there on this machine.
        text = (DEPLOY / name).read_text(encoding="utf-8")
        (tmp_path / name).write_text(text.replace("/srv/venv/bin/gripcourse", "/bin/true"))
    units = [str(tmp_path / name) for name in UNITS]
    found = subprocess.run([analyze, "verify", *units], capture_output=True, text=True, check=False)  # noqa: S603 (of this machine)
    assert (found.returncode, found.stderr) == (0, "")
    rated = [analyze, "security", "--offline=true", "--threshold=25", units[0]]
    assert subprocess.run(rated, capture_output=True, check=False).returncode == 0  # noqa: S603 (of this machine)


def test_a_service_names_only_options_that_there_are() -> None:
    from gripcourse.cli.desk import serve  # noqa: PLC0415 (the command line is read here alone)

    for name in ("gripcourse.service", "compose.yaml"):
        text = (DEPLOY / name).read_text(encoding="utf-8")
        command = re.search(r"serve (.*?)(\n\S|\n {4}\w|\n$)", text, re.DOTALL)
        assert command is not None
        options = re.findall(r"--([a-z-]+)", command[1])
        assert len(options) >= 4
        assert set(options) <= set(serve.__annotations__)


def test_nginx_starts_with_its_buffers() -> None:
    """Two buffers may be busy; all but one must be more than that, or nginx ends at once."""
    text = (DEPLOY / "nginx.conf").read_text(encoding="utf-8")
    first = re.search(r"proxy_buffer_size (\d+)k;", text)
    others = re.search(r"proxy_buffers (\d+) (\d+)k;", text)
    assert first is not None
    assert others is not None
    number, size = int(others[1]), int(others[2])
    assert 2 * max(int(first[1]), size) < (number - 1) * size


def test_a_server_may_start_before_anything_was_graded(tmp_path: Path) -> None:
    graded = tmp_path / "graded"
    look_into(Serving("127.0.0.1", 0, "", None, graded, 0))
    assert list(graded.iterdir()) == []
    assert graded.stat().st_mode & 0o077 == 0
    with pytest.raises(FileNotFoundError):
        look_into(Serving("127.0.0.1", 0, "", tmp_path / "issued", graded, 0))


def test_the_web_server_before_ours_writes_no_path_and_lets_us_refuse() -> None:
    text = (DEPLOY / "nginx.conf").read_text(encoding="utf-8")
    assert "access_log off;" in text
    assert re.search(r"error_log \S+ emerg;", text)
    most = re.search(r"client_max_body_size (\d+)m;", text)
    assert most is not None
    assert int(most[1]) * 1_000_000 > LARGEST_BODY


def test_behind_a_proxy_a_visitor_is_whom_the_proxy_names_and_nobody_of_his_choice(
    server: "Server",
) -> None:
    site = Site(
        LivingCourse(server.context),
        make_checkers(server.context, 1, None),
        server.clock,
        secure=True,
    )
    app = ProxyHeadersMiddleware(make_app(site), trusted_hosts=["testclient"])  # type: ignore[arg-type]
    client = TestClient(app, "http://inner", follow_redirects=False)  # type: ignore[arg-type]

    def tried(address: str, times: int) -> int:
        head = {"x-forwarded-for": address, "x-forwarded-proto": "https"}
        return [client.get("/s/forged/", headers=head).status_code for _ in range(times)].count(429)

    assert tried("203.0.113.7", REFUSED_LINKS.times + 1) == 1
    assert tried("203.0.113.8", 1) == 0
    stranger = TestClient(app, "http://inner", client=("198.51.100.1", 1))  # type: ignore[arg-type]
    answers = [
        stranger.get("/s/forged/", headers={"x-forwarded-for": f"10.0.0.{n}"}).status_code
        for n in range(REFUSED_LINKS.times + 1)
    ]
    assert answers.count(429) == 1
    assert stranger.get("/").headers["strict-transport-security"]
