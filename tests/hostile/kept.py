"""Where files are kept that once failed, by their readers."""

from pathlib import Path
from typing import Final

FAILED: Final = Path(__file__).parent / "once_failed"
