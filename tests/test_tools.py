"""What is said in several places about how the program is built, checked and packed agrees.

Neither an image nor a commit is made for it.
"""

import fnmatch
import re
import tomllib
from pathlib import Path
from typing import Any

REPOSITORY = Path(__file__).parents[1]
DEBIAN = {"bookworm": 12, "trixie": 13}


def text_of(name: str) -> str:
    return (REPOSITORY / name).read_text(encoding="utf-8")


def project() -> dict[str, Any]:
    return tomllib.loads(text_of("pyproject.toml"))


def copied() -> list[str]:
    """What the image takes from the repository, by name."""
    lines = re.findall(r"^COPY (?!--from)(.*)$", text_of("Dockerfile"), re.MULTILINE)
    return [name for line in lines for name in line.split()[:-1]]


def let_in(path: str) -> bool:
    """Tell whether .dockerignore lets a path into the image: the last line that fits decides."""
    found = True
    for line in text_of(".dockerignore").splitlines():
        if line and not line.startswith("#"):
            pattern = line.removeprefix("!")
            parts = path.split("/")
            whole = ["/".join(parts[: n + 1]) for n in range(len(parts))]
            if any(fnmatch.fnmatch(one, pattern) for one in whole):
                found = line.startswith("!")
    return found


def test_the_image_copies_what_is_there_and_let_in() -> None:
    assert copied()
    assert [name for name in copied() if not (REPOSITORY / name).exists()] == []
    assert [name for name in copied() if name != "." and not let_in(name)] == []


def test_everything_that_a_wheel_is_made_of_is_let_into_the_image() -> None:
    hatch = project()["tool"]["hatch"]["build"]["targets"]["wheel"]
    needed = [*hatch["packages"], *hatch["force-include"], "pyproject.toml", "README.md", "LICENSE"]
    assert [name for name in needed if not let_in(name)] == []
    assert not let_in("examples")
    assert not let_in("variants/private/key")


def test_the_image_serves_every_extra() -> None:
    (extras,) = re.findall(r"\$wheel\[([\w,]+)\]", text_of("Dockerfile"))
    assert set(extras.split(",")) == set(project()["project"]["optional-dependencies"])


def test_the_image_has_the_packages_of_the_one_list() -> None:
    said = text_of("Dockerfile")
    assert "system-packages run" in said
    assert not re.search(r"apt(-get)? install", said)


def test_python_and_debian_are_those_that_are_promised() -> None:
    least = str(project()["project"]["requires-python"]).removeprefix(">=")
    images = re.findall(r"^FROM python:([\d.]+)-slim-(\w+)", text_of("Dockerfile"), re.MULTILINE)
    made = {(version, DEBIAN[release]) for version, release in images}
    assert made == {(least, 12)}
    promised = f"Debian 12 (or newer) with Python {least} (or newer)"
    assert promised in text_of("Makefile")
    assert str(tuple(map(int, least.split("."))))[1:-1] in text_of("Makefile")


def test_before_a_commit_runs_what_make_lint_runs() -> None:
    hooks = re.findall(r"entry: \.venv/bin/(.*)", text_of(".pre-commit-config.yaml"))
    typed = {hook.replace(" --force-exclude", "").removesuffix(" --check") for hook in hooks}
    lint = text_of("Makefile").partition("\nLINT = ")[2].partition("\n\n")[0]
    called = set(re.findall(r"\$\(BIN\)/(mypy|\w+ \w+)", lint))
    assert typed == called == {"ruff check", "ruff format", "mypy"}
