"""What a how-to tells to write, so that a test can follow it literally."""

import re
from pathlib import Path

HOWTO = Path(__file__).parents[2] / "docs" / "howto"
_BLOCK = re.compile(r"```(\w+)\n(.*?)```", re.DOTALL)


def blocks(name: str, language: str) -> list[str]:
    """Return the texts of one language that a how-to shows, in order."""
    text = (HOWTO / name).read_text(encoding="utf-8")
    return [shown for kind, shown in _BLOCK.findall(text) if kind == language]
