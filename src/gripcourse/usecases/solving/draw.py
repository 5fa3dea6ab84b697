"""Drawing a solved variant: its general view as DXF and as SVG."""

from pathlib import Path

from gripcourse.drawing.paper.document import dxf_bytes
from gripcourse.drawing.paper.title_block import variant_block
from gripcourse.drawing.view.general_view import general_view, sheet_svg
from gripcourse.errors import Problem, UsageError
from gripcourse.machine.enclosed import file_below
from gripcourse.machine.files import write_bytes, write_text
from gripcourse.text.words import Words, message
from gripcourse.usecases.solving.solve import SolvedVariant


def write_general_view(solved: SolvedVariant, out: Path, student: str, words: Words) -> list[Path]:
    """Write the general view of a variant into a folder and return what was written.

    Args:
        solved: the variant.
        out: the folder.
        student: name for the title block; may be empty.
        words: language of the drawing.

    Raises:
        UsageError: the scheme declares no general view.
    """
    scheme = solved.plan.scheme
    if scheme.view is None:
        what = message("The scheme {scheme} declares no general view.", scheme=scheme.id)
        remedy = message("Write drawing.toml into its folder.")
        raise UsageError([Problem("", "", what, remedy)])
    block = variant_block(solved.plan, solved.variant.id, student, words)
    drawn = general_view(solved.plan, scheme.view, solved.values, block, words)
    stem = f"{solved.variant.id}-general-view"
    paths = [file_below(out, f"{stem}.dxf"), file_below(out, f"{stem}.svg")]
    write_bytes(paths[0], dxf_bytes(drawn.document))
    write_text(paths[1], sheet_svg(drawn, block)[0])
    return paths
