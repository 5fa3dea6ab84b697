"""A platform is declared at the command line; what cannot be trusted is refused in a sentence."""

import json
import shutil
import tomllib
from pathlib import Path

import pytest

from gripcourse.access.lti.platforms import load_platforms, platforms_path
from gripcourse.errors import CourseError
from gripcourse.machine.resources import course_root
from support.command_line import Run, call

ADDRESS = ("--address", "https://course.example.org")


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A course of which nobody needs more than its title."""
    folder = tmp_path_factory.mktemp("lti_cli")
    shutil.copytree(course_root() / "examples" / "belt_drive", folder / "course")
    return folder


def register(home: Path, name: str, *more: str) -> Run:
    required = (name, "--client-id", "tool-7", "--deployment", "1", "--course", "course")
    return call(home, "lti", "register", *required, *more)


def test_a_moodle_is_declared_by_its_address_and_the_key_is_made(home: Path) -> None:
    done = register(home, "moodle", "--moodle", "https://moodle.example.org/", "--context", "42")
    assert done.code == 0, done.err
    platform = load_platforms(home / "course")["moodle"]
    assert platform.issuer == "https://moodle.example.org"
    assert platform.jwks_url == "https://moodle.example.org/mod/lti/certs.php"
    assert (platform.contexts, platform.deployments) == (("42",), ("1",))
    for name in ("lti.toml", "lti_key.json"):
        assert (home / "course" / "private" / name).stat().st_mode & 0o077 == 0
    assert "There is a platform" in register(home, "moodle", "--moodle", "https://b.example").err


def test_what_is_declared_is_read_again_as_it_was_typed(home: Path) -> None:
    odd = 'tool \N{GRINNING FACE} "7" \\ ї \x7f'
    more = ("--client-id", odd, "--moodle", "https://odd.example.org")
    assert register(home, "odd", *more).code == 0
    assert load_platforms(home / "course")["odd"].client_id == odd


def test_all_of_canvas_signs_by_one_name_and_a_school_shows_the_page(home: Path) -> None:
    more = ("--canvas", "https://school.instructure.com/", "--known-by", "email")
    assert register(home, "canvas", *more).code == 0
    platform = load_platforms(home / "course")["canvas"]
    assert platform.issuer == "https://canvas.instructure.com"
    assert platform.frames == ("https://school.instructure.com",)
    # Whoever was let in by no course yet is let in by none.
    assert platform.contexts == ()


@pytest.mark.parametrize(
    "more",
    [
        ("--moodle", "http://moodle.example.org"),
        ("--moodle", "https://user:word@moodle.example.org"),
        ("--moodle", "moodle.example.org"),
        ("--moodle", "https://moodle.example.org:70000"),
        ("--endpoints", "x", "https://a.example", "https://a.example", "file:///etc/passwd"),
        ("--moodle", "https://a.example", "--canvas", "https://b.example"),
        (),
    ],
)
def test_what_cannot_be_trusted_is_not_declared(home: Path, more: tuple[str, ...]) -> None:
    before = platforms_path(home / "course").is_file() and load_platforms(home / "course")
    done = register(home, "other", *more)
    assert done.code == 2
    assert done.err.count(". ") >= 1
    assert (platforms_path(home / "course").is_file() and load_platforms(home / "course")) == before


def test_the_card_has_what_an_administrator_types_in(home: Path) -> None:
    said = call(home, "lti", "card", *ADDRESS, "--course", "course").out
    for path in ("login", "launch", "keys.json"):
        assert f"https://course.example.org/lti/{path}\n" in said
    plain = json.loads(call(home, "lti", "card", "--canvas", *ADDRESS, "--course", "course").out)
    assert plain["oidc_initiation_url"] == "https://course.example.org/lti/login"
    assert plain["public_jwk_url"] == "https://course.example.org/lti/keys.json"
    assert {one["windowTarget"] for one in plain["extensions"][0]["settings"]["placements"]} == {
        "_blank"
    }


def test_a_file_of_platforms_is_refused_with_all_its_faults(tmp_path: Path) -> None:
    path = platforms_path(tmp_path)
    path.parent.mkdir()
    path.write_text(
        """
[platform.Moodle]
issuer = "https://a.example"
client_id = "1"
authorization_url = "http://a.example"
token_url = "https://a.example/t"
jwks_url = "https://a.example/k"
deployments = []
known_by = ["name"]
frames = ["https://a.example; script-src *"]
kontexts = ["1"]
""",
        encoding="utf-8",
    )
    assert tomllib.loads(path.read_text(encoding="utf-8"))
    with pytest.raises(CourseError) as refused:
        load_platforms(tmp_path)
    said = str(refused.value)
    for one in ("Moodle", "http://a.example'", "empty", "'name'", "script-src", "kontexts"):
        assert one in said
