"""Where a course keeps its database: one file in its private folder, or where a line says."""

from pathlib import Path


def gradebook_path(root: Path) -> Path:
    """Return the file that holds gradebook and register of a course."""
    return root / "private" / "gradebook.sqlite"


def address_path(root: Path) -> Path:
    """Return the file that may name another database in its first line, by URL."""
    return root / "private" / "database"


def home_of(root: Path) -> str:
    """Return the place of a course's database: a path, or a database URL.

    Raises:
        OSError: the line cannot be read.
    """
    address = address_path(root)
    if not address.is_file():
        return str(gradebook_path(root))
    first = address.read_text(encoding="utf-8").strip().partition("\n")[0]
    return first or str(gradebook_path(root))


def exists(place: str) -> bool:
    """Tell whether there may be a database: a file is looked for, a URL is believed."""
    return "://" in place or Path(place).is_file()
