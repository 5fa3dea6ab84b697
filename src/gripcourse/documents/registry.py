"""Every kind of document that the program makes: each module in `kinds` brings one."""

from importlib import import_module
from pkgutil import iter_modules

from gripcourse.documents import kinds
from gripcourse.documents.kind import DocumentKind


def document_kinds() -> tuple[DocumentKind, ...]:
    """Return all kinds, by the names of their modules.

    Raises:
        TypeError: a module in `kinds` has no `KIND`.
    """
    return tuple(_kind(module.name) for module in iter_modules(kinds.__path__))


def _kind(name: str) -> DocumentKind:
    found = getattr(import_module(f"{kinds.__name__}.{name}"), "KIND", None)
    if not isinstance(found, DocumentKind):
        what = f"{kinds.__name__}.{name} has no KIND"
        raise TypeError(what)
    return found
