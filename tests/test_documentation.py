"""The examples of the documentation are run, in their order, each page in a folder of its own."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[1] / "docs"
BLOCK = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)


def examples(page: str) -> Iterator[tuple[int, str]]:
    """Blocks of a page with the lines that they begin on."""
    for found in BLOCK.finditer(page):
        yield page[: found.start(1)].count("\n"), found[1]


PAGES = [path for path in sorted(DOCS.glob("*.md")) if any(examples(path.read_text("utf-8")))]


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.name)
def test_the_examples_of_a_page_do_what_they_say(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for line, block in examples(path.read_text(encoding="utf-8")):
        # As many lines above as in the page, so that a failure names the line of the page.
        code = compile("\n" * line + block, str(path), "exec")
        exec(code, names)  # noqa: S102 (our own documentation)


def test_some_page_has_examples() -> None:
    assert "api.md" in {path.name for path in PAGES}
