"""Drawing an atlas: each figure as SVG, all of it as PDF."""

from pathlib import Path

from gripcourse.course.check_atlas import load_atlas
from gripcourse.course.model import Course
from gripcourse.documents.report.atlas import atlas_pdf, plates
from gripcourse.errors import Problem, UsageError
from gripcourse.machine.files import write_bytes, write_text
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Words, message


def draw_atlas(course: Course, identifier: str, out: Path, words: Words) -> list[Path]:
    """Draw an atlas into a folder and return what was written.

    Raises:
        UsageError: the course has no such atlas.
        CourseError: its file cannot be used.
    """
    known = [
        path.stem.replace("_", "-") for path in (course.root / "variants/atlas").glob("*.toml")
    ]
    if identifier not in known:
        what = message("The course has no atlas '{atlas}'.", atlas=identifier)
        raise UsageError([Problem("", "", what, did_you_mean(identifier, known))])
    atlas = load_atlas(course, identifier)
    drawn = plates(atlas, course, words)
    written = []
    for plate in drawn:
        written.append(out / f"figure_{plate.number}.svg")
        write_text(written[-1], plate.svg())
    written.append(out / f"{identifier}.pdf")
    write_bytes(written[-1], atlas_pdf(atlas, drawn, course, words))
    return written
