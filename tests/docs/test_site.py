"""The pages are put together as strictly as for the site; only what takes minutes is left out."""

import subprocess
from pathlib import Path

from documentation import DEAR, REPOSITORY, gather_pages, sphinx_command


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


def test_what_scrolls_is_reached_by_keyboard_and_the_menu_has_levels(tmp_path: Path) -> None:
    """As WCAG 2.1.1 and 4.1.2 want it; the theme alone does neither."""
    pages, site = tmp_path / "pages", tmp_path / "site"
    pages.mkdir()
    (tmp_path / "extra").mkdir()
    (pages / "conf.py").write_bytes((REPOSITORY / "docs" / "conf.py").read_bytes())
    (pages / "next.md").write_text("# Next\n", encoding="utf-8")
    (pages / "index.md").write_text(
        "# Page\n\n```{toctree}\n:caption: Begin\nnext\n```\n\n```toml\na = 1\n```\n\n"
        "| a |\n|---|\n| b |\n",
        encoding="utf-8",
    )
    done = subprocess.run(  # noqa: S603 (ours)
        sphinx_command("html", pages, site), capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    page = (site / "index.html").read_text(encoding="utf-8")
    assert page.count('role="heading"') == page.count('role="heading" aria-level="2"') > 0
    assert page.count("<pre") == page.count('<pre tabindex="0"') == 1
    assert page.count("table-wrapper") == page.count('<div tabindex="0" class="table-wrapper') == 1
