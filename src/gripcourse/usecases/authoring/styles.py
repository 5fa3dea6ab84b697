"""Style sheets of a course judged on this machine: they are there, and so are their fonts."""

import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Final

from gripcourse.errors import Problem
from gripcourse.machine.fonts import font_remedy, fonts_used, missing_font, without_greek
from gripcourse.machine.resources import template_file
from gripcourse.text.words import Message, message
from gripcourse.usecases.authoring.judged_before import found_before

_GENERIC: Final = frozenset(
    {"serif", "sans-serif", "monospace", "cursive", "fantasy", "system-ui", "math", "inherit"}
)
_COMMENT: Final = re.compile(r"/\*.*?\*/", re.DOTALL)
_DECLARED: Final = re.compile(r"\bfont(-family)?\s*:\s*([^;{}]+)")
_FORMULA: Final = re.compile(r"\.formula\b[^{}]*\{[^}]*\}")
_BROUGHT: Final = re.compile(r"@font-face\s*\{[^}]*\}")
# The shorthand has the size, and perhaps the height of a line, before the families.
_SIZE: Final = re.compile(r"^.*?[\d.]+(?:pt|px|mm|cm|in|em|rem|%)(?:/[\d.]+\w*)?\s+")


def style_problems(templates: Path) -> list[Problem]:
    """Return the style sheets of printed documents that are missing, or whose fonts are.

    Only the first family of each list is asked for: who lists others says what may stand in where
    the first has no letter, not what the documents are meant to look like.
    """
    problems: list[Problem] = []
    for name in _printed():
        path, shown = template_file(templates, f"style/{name}"), f"{templates.name}/style/{name}"
        if not path.is_file():
            what = message("The style sheet is missing.")
            problems.append(Problem(shown, "", what, message("Copy it from the reference course.")))
            continue
        style = path.read_text(encoding="utf-8")
        problems += [*_missing_fonts(style, shown), *_without_greek(style, shown)]
    return problems


def missing_fonts(templates: Path, styles: Iterable[str]) -> tuple[Message, ...]:
    """Say of each font that style sheets ask for first and this machine lacks what stands in.

    Args:
        templates: folder of the course.
        styles: names of the sheets; one that is missing is another's to say.
    """
    paths = (template_file(templates, f"style/{name}") for name in styles)
    written = (path.read_text(encoding="utf-8") for path in paths if path.is_file())
    wanted = dict.fromkeys(family for style in written for family in first_families(style))
    return tuple(
        message("{fault}.", fault=missing_font(family, used))
        for family, used in fonts_used(wanted).items()
        if used != family
    )


def first_families(style: str) -> dict[str, int]:
    """Return the first font family of each declaration of a style sheet, with its first line."""
    # Lines stay where they are.
    plain = _COMMENT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), style)
    brought = {name for rule in _BROUGHT.findall(plain) for name, _ in _families(rule)}
    first: dict[str, int] = {}
    for name, line in _families(plain):
        if name not in brought and name.lower() not in _GENERIC:
            first.setdefault(name, line)
    return first


def _families(style: str) -> Iterator[tuple[str, int]]:
    for found in _DECLARED.finditer(style):
        listed = found[2] if found[1] else _SIZE.sub("", found[2])
        name = listed.split(",")[0].strip().strip("\"'")
        if name and not name.startswith("var("):
            yield name, style.count("\n", 0, found.start()) + 1


def _missing_fonts(style: str, shown: str) -> Iterator[Problem]:
    wanted = first_families(style)
    for family, used in fonts_used(wanted).items():
        if used != family:
            what = message("{fault}.", fault=missing_font(family, used))
            yield Problem(shown, f"line {wanted[family]}", what, font_remedy(family))


def _without_greek(style: str, shown: str) -> Iterator[Problem]:
    """Yield the fonts of formulas that have no Greek letters: those would look like another's."""
    wanted: dict[str, int] = {}
    for rule in _FORMULA.finditer(style):
        before = style.count("\n", 0, rule.start())
        for family, line in first_families(rule[0]).items():
            wanted.setdefault(family, before + line)
    used = fonts_used(wanted)
    for family in without_greek(one for one in wanted if used.get(one) == one):
        what = message("The font {family} of formulas has no Greek letters.", family=family)
        remedy = message("Name one first that has them, for example Liberation Serif.")
        yield Problem(shown, f"line {wanted[family]}", what, remedy)


def _printed() -> list[str]:
    # The program alone says so: all kinds of documents cost 0.2 s to import.
    return found_before("style sheets of printed documents", (), _listed, bool)


def _listed() -> list[str]:
    from gripcourse.documents.registry import document_kinds  # noqa: PLC0415 (as said)

    # A browser, which shows the other kinds, has fonts of its own.
    printed = (kind for kind in document_kinds() if kind.printed)
    return sorted({name for kind in printed for name in kind.styles})
