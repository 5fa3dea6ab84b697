import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.machine.doctor import Machine, MachineCheck, assess, checks, look
from gripcourse.machine.fonts import FONT_PACKAGES, fonts_used
from gripcourse.text.translations import Kind, TranslationFault

REPOSITORY = Path(__file__).parents[2]
# A browser has fonts of its own; nothing is laid out with these here.
FOR_BROWSERS = {"reference.css"}
GENERIC_FAMILIES = {"serif", "sans-serif", "monospace", "inherit"}

HEALTHY = Machine(
    python=(3, 11, 2),
    expat=(2, 5, 0),
    pango="",
    subsetting=True,
    fonts=tuple((family, family) for family in FONT_PACKAGES),
    translations=(("ru", ()), ("uk", ())),
    office="/usr/bin/soffice",
    folder=Path("results"),
    writable=True,
)


def failures(machine: Machine) -> list[MachineCheck]:
    return [check for check in assess(machine) if not check.ok]


def test_a_healthy_machine_passes_every_check() -> None:
    assert failures(HEALTHY) == []


@pytest.mark.parametrize(
    ("machine", "name", "found", "remedy"),
    [
        (replace(HEALTHY, python=(3, 10, 9)), "python", "3.10.9", "3.11"),
        (replace(HEALTHY, expat=(2, 3, 9)), "expat", "2.3.9", "2.4"),
        (replace(HEALTHY, pango="no such file"), "pango", "no such file", "libpango-1.0-0"),
        (
            replace(HEALTHY, subsetting=False),
            "harfbuzz-subset",
            "twice as long",
            "libharfbuzz-subset0",
        ),
        (
            replace(HEALTHY, fonts=(("PT Serif", "DejaVu Sans"),)),
            "font PT Serif",
            "DejaVu Sans is used",
            "fonts-paratype",
        ),
        (
            replace(
                HEALTHY, translations=(("ru", (TranslationFault("lost", 12, "file"),)), ("uk", ()))
            ),
            "translation ru",
            "ru.po: line 12 loses file",
            "names in braces",
        ),
        (replace(HEALTHY, office=None), "libreoffice", "missing", "libreoffice-calc-nogui"),
        (replace(HEALTHY, writable=False), "folder", "results", "folder"),
    ],
)
def test_what_is_missing_is_named_with_its_remedy(
    machine: Machine, name: str, found: str, remedy: str
) -> None:
    [check] = failures(machine)
    assert check.name == name
    assert found in str(check.message)
    assert remedy in str(check.remedy)


def test_only_libreoffice_can_be_done_without() -> None:
    optional = {check.name for check in assess(HEALTHY) if not check.required}
    assert optional == {"libreoffice"}


def test_this_machine_can_make_pdf_files_as_they_are_meant(tmp_path: Path) -> None:
    failed = {check.name: str(check.message) for check in checks(tmp_path) if not check.ok}
    assert failed == {}


def test_every_fault_of_a_translation_is_named() -> None:
    kinds: tuple[Kind, ...] = ("lost", "invented", "braces", "plural", "empty", "unreadable")
    faults = tuple(TranslationFault(kind, 7, f"<{kind}>") for kind in kinds)
    found = failures(replace(HEALTHY, translations=(("ru", faults),)))
    assert len({str(check.message) for check in found}) == len(kinds)
    for check, fault in zip(found, faults, strict=True):
        assert fault.detail in str(check.message) or fault.kind == "empty"


def test_a_font_that_is_not_there_is_seen_behind_the_one_that_stands_in() -> None:
    used = fonts_used(["PT Serif", "No Such Family"])
    assert used["PT Serif"] == "PT Serif"
    assert used["No Such Family"] != "No Such Family"


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="fontconfig elsewhere is another")
def test_a_machine_without_fonts_is_told_which_are_missing(tmp_path: Path) -> None:
    """Really: another process whose fontconfig knows an empty folder only."""
    settings = tmp_path / "fonts.conf"
    settings.write_text(
        f"<fontconfig><dir>{tmp_path}</dir><cachedir>{tmp_path}</cachedir></fontconfig>",
        encoding="utf-8",
    )
    asked = "from gripcourse.cli.main import main; main()"
    done = subprocess.run(  # noqa: S603 (our own interpreter)
        [sys.executable, "-c", asked, "doctor"],
        env={**os.environ, "FONTCONFIG_FILE": str(settings)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    for family, package in FONT_PACKAGES.items():
        assert f"✗ Font {family} is missing" in done.stdout
        assert package in done.stdout


def test_a_folder_that_does_not_exist_cannot_be_written(tmp_path: Path) -> None:
    assert not look(tmp_path / "nowhere").writable


def test_every_font_of_the_printed_documents_is_checked() -> None:
    sheets = [*(REPOSITORY / "templates").rglob("*.css")]
    printed = [path for path in sheets if path.name not in FOR_BROWSERS]
    text = "\n".join(path.read_text(encoding="utf-8") for path in printed)
    declared = re.findall(r"font-family:\s*([^;}]+)", text)
    named = {name.strip(" \n\"'") for names in declared for name in names.split(",")}
    families = {name for name in named if not name.startswith("var(")} - GENERIC_FAMILIES
    assert families <= set(FONT_PACKAGES)


def test_every_package_that_a_remedy_names_is_installed_by_make() -> None:
    script = (REPOSITORY / "scripts" / "system-packages").read_text(encoding="utf-8")
    broken = replace(
        HEALTHY,
        pango="gone",
        subsetting=False,
        fonts=tuple((family, "other") for family in FONT_PACKAGES),
        office=None,
    )
    remedies = [str(check.remedy) for check in failures(broken)]
    packages = {name for text in remedies for name in text.partition("install ")[2].split()}
    assert packages
    assert packages <= set(re.findall(r"[\w.+-]+", script))
