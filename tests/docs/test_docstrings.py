"""What stands in docstrings can be put on the site.

The site itself takes minutes for it. Here docstrings are read by the same reader, and of thousands
one of each shape is enough: no docstring is wrong by the words that it is made of.
"""

import ast
import inspect
import re
from collections.abc import Iterator
from functools import cache
from optparse import Values
from pathlib import Path

import pytest
from docutils.frontend import get_default_settings
from docutils.nodes import substitution_reference, system_message
from docutils.parsers.rst import Parser
from docutils.utils import Reporter, new_document
from sphinx.ext.napoleon import Config, GoogleDocstring

ENGINE = Path(__file__).parents[2] / "src" / "gripcourse"

NAMED = re.compile(
    r"^\s*\.\. |::|:\w+:`|^\s*\(?(?:\d+|[a-z]|[ivxlcdm]+)[.)]\s", re.MULTILINE | re.IGNORECASE
)
"""A directive, a role, a number of a list: which one it is does matter."""
FOLDED = [
    (re.compile(r"[^\W_]+(?:(?:'|[-_.]|[,;.]? )[^\W_]+)*"), "word"),
    (re.compile(r"^( *)word[,;.:]?(?:\n\1word[,;.:]?(?=\n|$))+", re.MULTILINE), r"\1word"),
    (re.compile(r"^(:word: word)[,;.:]?\n +word[.;,:]?(?=\n\S|\n*$)", re.MULTILINE), r"\1"),
    (re.compile(r"^(:word: word)[,;.:]?(?:\n:word: word[,;.:]?(?=\n|$))+", re.MULTILINE), r"\1"),
]
"""Words, lines of words, a field that goes on in a line of words, fields that are alike."""


def shown(node: ast.Module | ast.ClassDef, place: str) -> Iterator[tuple[str, str]]:
    """Yield what the site shows of a module or a class: where it stands, and what Sphinx reads."""
    yield place, for_sphinx(ast.get_docstring(node), "class")
    for before, one in zip([node, *node.body], node.body, strict=False):
        match one:
            case ast.ClassDef() if not one.name.startswith("_"):
                yield from shown(one, f"{place}: {one.name}")
            case ast.FunctionDef() if not one.name.startswith("_"):
                yield f"{place}: {one.name}", for_sphinx(ast.get_docstring(one), "function")
            case ast.Expr(ast.Constant(str(text))) if isinstance(
                before, ast.Assign | ast.AnnAssign
            ):
                yield f"{place}: line {one.lineno}", for_sphinx(inspect.cleandoc(text), "data")
            case _:
                pass


def for_sphinx(text: str | None, sort: str) -> str:
    if text is None or "\n" not in text:
        return text or ""
    return str(GoogleDocstring(text, Config(napoleon_use_ivar=True), what=sort))


def shape(text: str) -> str:
    """Write one word for words, and one line and one field for those that are alike."""
    if NAMED.search(text):
        return text
    for one, folded in FOLDED:
        text = one.sub(folded, text)
    return text


@cache
def settings() -> Values:
    """How the reader reads; it prints nothing."""
    made = get_default_settings(Parser)
    made.report_level = made.halt_level = Reporter.SEVERE_LEVEL + 1
    return made


def refused(text: str) -> list[str]:
    """What the reader of docstrings says of one."""
    document = new_document("docstring", settings())
    told: list[system_message] = []
    document.reporter.attach_observer(told.append)
    Parser().parse(text, document)
    said = [one.astext() for one in told if one["level"] >= Reporter.WARNING_LEVEL]
    named = [one.astext() for one in document.findall(substitution_reference)]
    return [*said, *document.refnames, *named]


def test_the_site_can_show_every_docstring() -> None:
    shapes: dict[str, tuple[str, str]] = {}
    for path in sorted(ENGINE.rglob("*.py")):
        module = ast.parse(path.read_text(encoding="utf-8"))
        for place, text in shown(module, path.relative_to(ENGINE).as_posix()):
            shapes.setdefault(shape(text), (place, text))
    assert len(shapes) > 100
    assert {place: said for place, text in shapes.values() if (said := refused(text))} == {}


@pytest.mark.parametrize(
    "wrong",
    [
        "Take the numbers away, as `1. ` does.",
        "Raise a number to a power of 2, as **kwargs do.",
        "Say who_ does.",
        "Say |what| is done.",
        "Do this.\n\nFirst:\n- one\n  - two\nand go on.",
        "Do this.\n\n    It stands\n  in no line.",
        "Do this.\n\nArgs:\n    what: is done:\n        - one\n          two\n      three",
        ".. nothing:: of this name",
    ],
)
def test_what_the_site_cannot_show_is_refused_and_is_no_shape_of_another(wrong: str) -> None:
    text = for_sphinx(wrong, "function")
    assert refused(text)
    assert refused(shape(text))
