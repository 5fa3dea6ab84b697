"""Templates of a course judged before anybody gets a document: read, compared, and filled once."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from gripcourse.documents.kind import SampleDocument
from gripcourse.documents.pdf import Document, render_html, template_environment
from gripcourse.documents.registry import document_kinds
from gripcourse.documents.template_faults import or_without_it, template_problem
from gripcourse.errors import GripcourseError, Problem
from gripcourse.machine.resources import template_folders
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, Words, message

# Jinja2 costs 40 ms to import: only who prints or judges a template pays.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from jinja2 import Environment, nodes

SUFFIX = ".j2"
_Node = TypeVar("_Node", bound="nodes.Node")


@dataclass(frozen=True, slots=True)
class Read:
    """A template that could be read.

    Attributes:
        name: in its folder.
        used: all templates that it names.
        continued: those of them that see the same values: extended and included ones.
        assigned: names that it makes itself, for example in a loop.
        asked: names that it takes from outside, each with its first line.
    """

    name: str
    used: frozenset[str]
    continued: frozenset[str]
    assigned: frozenset[str]
    asked: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class Templates:
    """All templates of a course, read and compiled for one language.

    Attributes:
        read: those that could be read, by name.
        problems: what is wrong with the others.
        compiled: their code, for whoever fills them with the same program.
    """

    read: Mapping[str, Read]
    problems: tuple[Problem, ...]
    compiled: Mapping[tuple[str, str], bytes]

    def tell(self, templates: Path, language: str) -> None:
        """Spare who fills them in this process the time to compile them again."""
        from gripcourse.documents.compiled import tell_compiled

        tell_compiled(template_environment(templates, language, with_charts=False), self.compiled)


@dataclass(frozen=True, slots=True)
class _Within:
    """All nodes of a template, outer ones first: its tree is gone through once."""

    nodes: "tuple[nodes.Node, ...]"

    def all_of(self, *kinds: type[_Node]) -> Iterator[_Node]:
        """Yield the nodes of some kinds, in their order."""
        return (one for one in self.nodes if isinstance(one, kinds))


def read_templates(templates: Path, language: str = "en") -> tuple[dict[str, Read], list[Problem]]:
    """Read every template of a course, whether a document uses it or not.

    Those that the course's folder lacks are the engine's. What is read is compiled, too, for who
    fills documents in this language without charts.

    Returns:
        The templates that could be read by their names, and what is wrong with the others.
    """
    from jinja2 import TemplateSyntaxError
    from jinja2.nodes import Node

    from gripcourse.documents.compiled import compile_template

    environment = template_environment(templates, language, with_charts=False)
    read: dict[str, Read] = {}
    problems: list[Problem] = []
    files = _files(templates)
    known = files.keys()
    for name, path in files.items():
        try:
            source = path.read_text(encoding="utf-8")
            tree = environment.parse(source, name, str(path))
            within = _Within(tuple(tree.find_all(Node)))
            unknown = [*_unknown_filters(within, name, environment)]
            wrong = (*unknown, *_unknown_parts(within, name, known))
            problems += [or_without_it(one, templates) for one in wrong]
            if not unknown:
                asked = compile_template(environment, tree, source, name, str(path))
                read[name] = _read(tree, within, name, asked)
        except TemplateSyntaxError as error:
            problems.append(template_problem(error, name, templates))
        except UnicodeDecodeError:
            what = message("The file is not text in UTF-8.")
            problems.append(Problem(f"templates/{name}", "", what, message("Save it as UTF-8.")))
    return read, problems


def all_templates(templates: Path, language: str) -> Templates:
    """Read every template of a course as `read_templates` does, to be kept with its code."""
    from gripcourse.documents.compiled import compiled_for

    read, problems = read_templates(templates, language)
    environment = template_environment(templates, language, with_charts=False)
    return Templates(read, tuple(problems), compiled_for(environment))


def _files(templates: Path) -> dict[str, Path]:
    """Return the file of every template by its name: the course's, else the engine's."""
    found: dict[str, Path] = {}
    for folder in template_folders(templates):
        for path in sorted(folder.rglob(f"*{SUFFIX}")):
            if path.is_file():
                found.setdefault(path.relative_to(folder).as_posix(), path)
    return found


def sample_documents(sample: SampleDocument) -> tuple[list[Document], list[Problem]]:
    """Return a document of every kind, and what keeps the others from being made."""
    documents: list[Document] = []
    problems: list[Problem] = []
    for kind in document_kinds():
        try:
            documents += [make() for make in kind.samples(sample).values()]
        except GripcourseError as error:
            problems += error.problems
    return documents, problems


def filling_problems(
    documents: Iterable[Document], templates: Path, words: Words, read: Mapping[str, Read]
) -> list[Problem]:
    """Return what is wrong with templates when documents are made with them.

    What can be read is compared with what its documents give it, and every document is filled, so
    that names inside of values are tried too.

    Args:
        documents: of every kind.
        templates: the folder.
        words: the language of the documents.
        read: its templates.
    """
    everywhere = frozenset(template_environment(templates, words.language).globals)
    problems: list[Problem] = []
    for document in documents:
        found = [or_without_it(one, templates) for one in _unknown(document, everywhere, read)]
        if not found and _whole(document.template, read):
            found = _failures(document, templates, words)
        problems += found
    # A part belongs to several documents; what is wrong with it is said once.
    return list({(one.file, str(one.key), str(one.what)): one for one in problems}.values())


def _failures(document: Document, templates: Path, words: Words) -> list[Problem]:
    try:
        # Charts fill no template: matplotlib, two seconds, would be paid for eight of them.
        render_html(document, templates, words, with_charts=False)
    except GripcourseError as error:
        return list(error.problems)
    except Exception as error:  # noqa: BLE001 (whatever an expression of a template comes to)
        return [template_problem(error, document.template, templates)]
    return []


def _read(tree: "nodes.Template", within: _Within, name: str, from_outside: set[str]) -> Read:
    from jinja2 import nodes

    undeclared = from_outside - _own(tree, within)
    asked: dict[str, int] = {}
    for one in within.all_of(nodes.Name):
        if one.ctx == "load" and one.name in undeclared:
            asked.setdefault(one.name, one.lineno)
    for test in within.all_of(nodes.Test):
        if test.name in {"defined", "undefined"} and isinstance(test.node, nodes.Name):
            asked.pop(test.node.name, None)
    continued = (nodes.Extends, nodes.Include)
    return Read(
        name=name,
        used=frozenset(target for target, _ in _named(within, *_links())),
        continued=frozenset(target for target, _ in _named(within, *continued)),
        assigned=frozenset(one.name for one in within.all_of(nodes.Name) if one.ctx == "store"),
        asked=asked,
    )


def _own(tree: "nodes.Template", within: _Within) -> set[str]:
    """Return what a template brings itself and its blocks see too: macros, imports, settings."""
    from jinja2 import nodes

    own = {macro.name for macro in within.all_of(nodes.Macro)}
    own |= {one.target for one in within.all_of(nodes.Import)}
    for line in within.all_of(nodes.FromImport):
        own |= {one if isinstance(one, str) else one[1] for one in line.names}
    for one in tree.body:
        if isinstance(one, nodes.Assign):
            own |= {name.name for name in one.target.find_all(nodes.Name)}
            own |= {one.target.name} if isinstance(one.target, nodes.Name) else set()
    return own


def _named(within: _Within, *kinds: type["nodes.Node"]) -> Iterator[tuple[str, int]]:
    """Yield the templates that are named and the lines; a computed name is none."""
    from jinja2 import nodes

    for link in within.all_of(*kinds):
        named = getattr(link, "template", None)
        if isinstance(named, nodes.Const) and isinstance(named.value, str):
            yield named.value, link.lineno


def _links() -> tuple[type["nodes.Node"], ...]:
    from jinja2 import nodes

    return (nodes.Extends, nodes.Include, nodes.Import, nodes.FromImport)


def _unknown_filters(within: _Within, name: str, environment: "Environment") -> Iterator[Problem]:
    from jinja2 import nodes

    for one in within.all_of(nodes.Filter):
        if one.name not in environment.filters:
            what = message("There is no filter '{name}'.", name=one.name)
            yield _problem(name, one.lineno, what, one.name, environment.filters)
    for test in within.all_of(nodes.Test):
        if test.name not in environment.tests:
            what = message("There is no test '{name}'.", name=test.name)
            yield _problem(name, test.lineno, what, test.name, environment.tests)


def _unknown_parts(within: _Within, name: str, known: Iterable[str]) -> Iterator[Problem]:
    for target, line in _named(within, *_links()):
        if target not in known:
            what = message("There is no template {name}.", name=target)
            yield _problem(name, line, what, target, known)


def _whole(start: str, read: Mapping[str, Read]) -> bool:
    """Whether a template and everything that it uses could be read."""
    waiting, seen = [start], set[str]()
    while waiting:
        name = waiting.pop()
        if name not in read:
            return False
        if name not in seen:
            seen.add(name)
            waiting += read[name].used
    return True


def _unknown(
    document: Document, everywhere: frozenset[str], read: Mapping[str, Read]
) -> Iterator[Problem]:
    """Name what a document's templates ask for and nobody gives.

    An included part sees the names of what includes it; an imported one only those that are
    everywhere.
    """
    from jinja2.defaults import DEFAULT_NAMESPACE

    waiting = [(document.template, everywhere | set(document.values))]
    seen: set[str] = set()
    while waiting:
        name, given = waiting.pop()
        if name in seen or name not in read:
            continue
        seen.add(name)
        template = read[name]
        for asked, line in template.asked.items():
            if asked not in given:
                what = message("The template does not get '{name}'.", name=asked)
                yield _problem(name, line, what, asked, given - set(DEFAULT_NAMESPACE))
        for used in sorted(template.used):
            inside = used in template.continued
            waiting.append((used, given | template.assigned if inside else everywhere))


def _problem(name: str, line: int, what: Message, wrong: str, known: Iterable[str]) -> Problem:
    return Problem(f"templates/{name}", f"line {line}", what, did_you_mean(wrong, known))
