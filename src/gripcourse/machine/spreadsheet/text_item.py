"""A text of a long part while it is parsed: its pieces, and how each of them looks."""

from collections.abc import Mapping

from gripcourse.machine.spreadsheet.cell_value import UnreadableContentError
from gripcourse.machine.spreadsheet.sheet_cells import TextPiece, is_struck, joined_text

_PIECE, _TEXT, _LOOK = "r", "t", "rPr"


class TextItem:
    """What was read of a text so far; it changes, because a parser calls back.

    Levels are counted from the text's own element: what stands directly in it is at level 1.
    """

    def __init__(self) -> None:
        self._plain: list[str] = []
        self._pieces: list[TextPiece] = []
        self._of_piece: list[str] = []
        self._outer = self._inner = self._place = ""
        self._is_struck = self._is_text = False

    def begin(self) -> None:
        """Begin with another text."""
        self._plain.clear()
        self._pieces.clear()

    def enter(self, level: int, name: str, attributes: Mapping[str, str]) -> None:
        """Take notice of an element that begins.

        Args:
            level: of the element.
            name: without its namespace; empty in another namespace than the part's.
            attributes: of the element.

        Raises:
            UnreadableContentError: it stands in the midst of a text.
        """
        if self._is_text:
            raise UnreadableContentError
        self._is_text = name == _TEXT
        if level == 1:
            self._outer = name
            if name == _PIECE:
                self._of_piece.clear()
                self._place, self._is_struck = "", False
        elif self._outer != _PIECE:  # how a text is pronounced is not part of it
            return
        elif level == 2:  # noqa: PLR2004 (as documented)
            self._inner = name
        elif self._inner == _LOOK and name == "strike":
            self._is_struck = is_struck(attributes.get("val", "1"))
        elif self._inner == _LOOK and name == "vertAlign":
            self._place = attributes.get("val", "")

    def leave(self, level: int, name: str, written: str) -> None:
        """Take notice of the end of an element.

        Args:
            level: of the element.
            name: as above.
            written: what stands in it, where it is a text.
        """
        if name == _TEXT:
            self._is_text = False
            if level == 1:
                self._plain.append(written)
            elif level == 2 and self._outer == _PIECE:  # noqa: PLR2004 (as above)
                self._of_piece.append(written)
        elif level == 1 and name == _PIECE:
            text = "".join(self._of_piece)
            self._pieces.append(TextPiece(text, self._place, self._is_struck))

    def whole(self) -> str:
        """Return the text."""
        return joined_text("".join(self._plain), self._pieces)
