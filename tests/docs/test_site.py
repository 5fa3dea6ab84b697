"""The pages are put together as strictly as for the site; only what takes minutes is left out."""

import subprocess
from pathlib import Path

from documentation import DEAR, gather_pages, sphinx_command


def put_together(pages: Path, site: Path) -> subprocess.CompletedProcess[str]:
    """Read all pages and follow all their links; nothing is written."""
    command = sphinx_command("dummy", pages, site)
    return subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603 (ours)


def test_the_pages_are_put_together_without_a_warning(tmp_path: Path) -> None:
    pages = gather_pages(tmp_path)
    (tmp_path / "extra").mkdir()
    for name in DEAR:
        (pages / name).parent.mkdir(exist_ok=True)
        (pages / name).write_text("Made\n====\n", encoding="utf-8")
    done = put_together(pages, tmp_path / "site")
    assert (done.returncode, done.stderr) == (0, "")


def test_a_link_that_leads_nowhere_is_noticed(tmp_path: Path) -> None:
    conf = "extensions = ['myst_parser']"
    (tmp_path / "conf.py").write_text(conf, encoding="utf-8")
    (tmp_path / "index.md").write_text("# Page\n\n[text](gone.md#there)\n", encoding="utf-8")
    done = put_together(tmp_path, tmp_path / "site")
    assert done.returncode != 0
    assert "gone.md" in done.stderr
