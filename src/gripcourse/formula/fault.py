"""What is wrong with a formula, and where."""

from gripcourse.formula.tree import Span
from gripcourse.text.words import Message


class FormulaFault(Exception):  # noqa: N818 - the glossary's word for an author's slip in a formula
    """A formula that cannot be read or does not fit its units.

    Attributes:
        what: the fault, in words.
        span: its place in the formula's text.
    """

    def __init__(self, what: Message, span: Span) -> None:
        self.what = what
        self.span = span
        super().__init__(f"{what} (characters {span[0]} to {span[1]})")


def caret(text: str, span: Span) -> str:
    """Show a place of a formula: its line, indented by two spaces, and carets under the place."""
    start, end = span
    first = text.rfind("\n", 0, start) + 1
    last = text.find("\n", start)
    line = text[first:] if last < 0 else text[first:last]
    width = max(1, min(end - first, len(line)) - (start - first))
    shown = line.replace("\t", " ").rstrip()
    return f"  {shown}\n  {' ' * (start - first)}{'^' * width}"
