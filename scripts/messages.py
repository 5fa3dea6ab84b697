"""The sentences of the program and their translations.

    scripts/messages.py update     bring src/gripcourse/locale/*.po up to date with the sources
    scripts/messages.py missing    list what still has no translation

A sentence is what stands first in `message("...")` or `translate("...")` in Python and in
`_("...")` in a template; the two forms of `counted("...", "...")`, one and many; and what the help
of the command line shows: what a command is documented with, and the texts of its options.
Catalogues are sorted and carry no places and no dates, so that a change shows nothing but itself. A
sentence that changed has lost its translation: nothing is guessed.
"""

import argparse
import ast
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any, BinaryIO

from babel.messages.catalog import Catalog
from babel.messages.extract import extract
from babel.messages.pofile import read_po, write_po

REPOSITORY = Path(__file__).parents[1]
LOCALE = Path("src") / "gripcourse" / "locale"
LANGUAGES = ("ru", "uk")
LINE_WIDTH = 100


# Line, function, sentence, comments: as Babel wants it from a way to read a file.
Found = tuple[int, None, str, list[str]]


def help_texts(
    stream: BinaryIO,
    keywords: Iterable[str],
    _tags: object,
    options: Mapping[str, str],  # noqa: ARG001 (Babel names it)
) -> Iterator[Found]:
    """Read what the help of commands shows.

    Args:
        stream: Python that declares commands.
        keywords: names of the arguments that are shown, in any call; and of the functions whose
            first argument is.
        options: of the way to read; there are none.
    """
    shown = set(keywords)
    for node in ast.walk(ast.parse(stream.read())):
        texts: list[ast.expr] = []
        if isinstance(node, ast.Call):
            texts = [one.value for one in node.keywords if one.arg in shown]
            if isinstance(node.func, ast.Name) and node.func.id in shown:
                texts += node.args[:1]
        elif isinstance(node, ast.FunctionDef) and any(map(_makes_command, node.decorator_list)):
            yield node.lineno, None, ast.get_docstring(node) or "", []
        for text in texts:
            if isinstance(text, ast.Constant) and isinstance(text.value, str):
                yield text.lineno, None, text.value, []


def _makes_command(decorator: ast.expr) -> bool:
    made = decorator.func if isinstance(decorator, ast.Call) else decorator
    return isinstance(made, ast.Attribute) and made.attr == "command"


@dataclass(frozen=True, slots=True)
class Source:
    """A kind of file with sentences.

    Attributes:
        folder: below which the files are.
        pattern: of their names.
        method: Babel's name of the way to read them, or the way itself.
        functions: names of the functions whose first argument is a sentence.
        options: of the method.
        counts: whether there are sentences of two forms, as well.
    """

    folder: str
    pattern: str
    method: str | Callable[..., Any]
    functions: tuple[str, ...]
    options: Mapping[str, str]
    counts: bool = True


SOURCES = (
    Source("src", "*.py", "python", ("message", "translate"), {}),
    Source(
        "src/gripcourse/cli",
        "*.py",
        help_texts,
        ("help", "metavar", "show_default", "command_group"),
        {},
        counts=False,
    ),
    # Not silent: a template that does not parse would count as one without sentences.
    Source("templates", "*.j2", "jinja2.ext:babel_extract", ("_",), {"silent": "false"}),
)


# A sentence, or its forms for one and for many.
Sentence = str | tuple[str, str]


def extracted(root: Path) -> Iterator[Sentence]:
    """Read every sentence below `root`, as often as it occurs.

    Raises:
        jinja2.TemplateSyntaxError: a template does not parse.
    """
    for source in SOURCES:
        for path in sorted((root / source.folder).rglob(source.pattern)):
            with path.open("rb") as stream:
                yield from _sentences(stream, source)


def _sentences(stream: BinaryIO, source: Source) -> Iterator[Sentence]:
    keywords: dict[str, Any] = dict.fromkeys(source.functions)
    if source.counts:
        keywords["counted"] = (1, 2)
    options = dict(source.options)
    for _, text, _, _ in extract(source.method, stream, keywords=keywords, options=options):
        yield text if isinstance(text, str) else (text[0], text[1])


def read_catalogue(root: Path, language: str) -> Catalog:
    """Read the catalogue of a language; an empty one when there is none yet."""
    path = root / LOCALE / f"{language}.po"
    if not path.exists():
        return Catalog(locale=language)
    with path.open("rb") as stream:
        return read_po(stream, locale=language, abort_invalid=True)


def merged(catalogue: Catalog, sentences: Iterable[Sentence]) -> Catalog:
    """Keep the translations of `sentences`, add what is new, drop what is gone."""
    result = Catalog(locale=catalogue.locale)
    for sentence in sentences:
        known = catalogue.get(sentence)
        result.add(sentence, known.string if known and not known.fuzzy else "")
    return result


def written(catalogue: Catalog) -> bytes:
    """Write a catalogue: a short fixed header, then the sentences in alphabetical order."""
    body = BytesIO()
    write_po(
        body, catalogue, width=LINE_WIDTH, no_location=True, omit_header=True, sort_output=True
    )
    header = (
        'msgid ""\n'
        'msgstr ""\n'
        f'"Language: {catalogue.locale}\\n"\n'
        '"Content-Type: text/plain; charset=utf-8\\n"\n'
        '"Content-Transfer-Encoding: 8bit\\n"\n'
        f'"Plural-Forms: {catalogue.plural_forms}\\n"\n'
        "\n"
    )
    return header.encode() + body.getvalue()


def untranslated(catalogue: Catalog, sentences: Iterable[Sentence]) -> list[str]:
    """List the sentences without a translation that a person has looked at."""
    entries = {sentence: catalogue.get(sentence) for sentence in sentences}
    return sorted(
        sentence if isinstance(sentence, str) else sentence[0]
        for sentence, entry in entries.items()
        if entry is None or not all(_forms(entry.string)) or entry.fuzzy
    )


def _forms(string: str | Sequence[str] | None) -> Sequence[str]:
    return (string or "",) if string is None or isinstance(string, str) else string


def update(root: Path) -> None:
    """Write the catalogues anew."""
    for language in LANGUAGES:
        catalogue = merged(read_catalogue(root, language), extracted(root))
        (root / LOCALE / f"{language}.po").write_bytes(written(catalogue))


def report(root: Path) -> int:
    """Print what has no translation; return how many that are."""
    count = 0
    for language in LANGUAGES:
        for sentence in untranslated(read_catalogue(root, language), extracted(root)):
            print(f"{language}: {sentence!r}")
            count += 1
    return count


def main(arguments: list[str]) -> int:
    """Run one of the two commands; 1 when something is missing."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("command", choices=("update", "missing"))
    parser.add_argument("--root", type=Path, default=REPOSITORY, help="the repository")
    options = parser.parse_args(arguments)
    if options.command == "update":
        update(options.root)
    return 1 if report(options.root) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
