"""What grades and prints, as one digest: course, policy, look, program, translations, libraries."""

import hashlib
import sysconfig
from collections.abc import Iterable
from pathlib import Path
from typing import Final

from gripcourse.course.digest import course_digest
from gripcourse.errors import CourseError
from gripcourse.machine.enclosed import strange_files
from gripcourse.machine.kept import digest_of
from gripcourse.machine.resources import COURSE_FOLDERS, TEMPLATES, template_folders
from gripcourse.text.conventions import is_english
from gripcourse.text.translations import catalogue_file
from gripcourse.text.words import LANGUAGES

EARLIER: Final = ".graded"
"""The folder among the results in which a run keeps what the next one can take over."""


def versions_of(root: Path) -> str:
    """Return a digest of all that grades and prints, but for people and files.

    That are the course, its policy, its look, this program, its translations and the libraries.

    Args:
        root: folder of the course.

    Raises:
        CourseError: something lies in the course that must not be read.
        OSError: a file cannot be read.
    """
    if strange := strange_files(root, COURSE_FOLDERS):
        raise CourseError(strange)
    folders = (root / "grader", *template_folders(root / TEMPLATES))
    files = (digest_of(one, (path for path in one.rglob("*") if path.is_file())) for one in folders)
    translated = (
        catalogue_file(language).read_text(encoding="utf-8")
        for language in LANGUAGES
        if not is_english(language)
    )
    return digest_of_texts([course_digest(root) or "", *files, *translated, *_libraries()])


def digest_of_texts(parts: Iterable[str]) -> str:
    """Return the digest of texts in their order."""
    whole = hashlib.sha256()
    for part in parts:
        # Lengths keep the end of one part apart from the beginning of the next.
        whole.update(f"{len(part)}\n{part}".encode())
    return whole.hexdigest()


def _libraries() -> list[str]:
    """Return the names, with versions, of the libraries beside this program."""
    folders = {sysconfig.get_path(name) for name in ("purelib", "platlib")}
    return sorted(path.name for one in folders for path in Path(one).glob("*.dist-info"))
