"""No two bodies of a variant go through one another, and no outline crosses itself."""

from collections.abc import Iterator, Mapping

from gripcourse.course.catalogue import columns_of
from gripcourse.course.model import Course, Scheme
from gripcourse.drawing.view.interference import (
    Overlaps,
    crossed_outlines,
    interference,
    together,
)
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import Array, Column
from gripcourse.proofs.calculations import PrintedCalculation
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, concluded
from gripcourse.proofs.samples import Trial
from gripcourse.proofs.tried import in_sets
from gripcourse.solver.solve import evaluate, to_si
from gripcourse.text.words import message

_IN_ORDER = message("Write its corners in order, all the way round.")
_A_PICTURE = message("The general view does not say that its parts are bodies.")


def prove_interference(course: Course, scheme: Scheme, trials: tuple[Trial, ...]) -> ProofResult:
    """Test the bodies of a scheme's general view in all sets of numbers.

    Args:
        course: of the scheme.
        scheme: with a general view.
        trials: numbers of it, with different options.
    """
    view = scheme.view
    file = scheme.file if view is None else view.file
    proof = Proof(ProofKind.INTERFERENCE, scheme.id, file, "")
    if view is None or not view.bodies:
        return ProofResult(proof, Verdict.OPEN, 0, (), _A_PICTURE)
    values = together(scheme, [(one.values, len(one.variants)) for one in trials])
    names = [variant.id for one in trials for variant in one.variants]
    columns = columns_of(course.catalogues)
    problems = (
        *_crossed(scheme, columns, values),
        *_overlapping(scheme, interference(scheme, columns, values), file, names),
    )
    return concluded(proof, len(names), problems)


def crossed_in_example(one: PrintedCalculation) -> Iterator[Problem]:
    """Yield which outlines of a general view cross themselves with the numbers of an example."""
    values = evaluate(one.plan, to_si(one.plan, one.known)).values
    for file, key in crossed_outlines(one.plan.scheme, one.plan.columns, values):
        what = message("The outline crosses itself with the numbers of {file}.", file=one.file)
        yield Problem(file, key, what, _IN_ORDER)


def _crossed(
    scheme: Scheme, columns: Mapping[str, Column], values: Mapping[str, Array]
) -> Iterator[Problem]:
    for (file, key), wrong in crossed_outlines(scheme, columns, values).items():
        what = message(
            "The outline crosses itself {tried}.", tried=in_sets(int(wrong.sum()), len(wrong))
        )
        yield Problem(file, key, what, _IN_ORDER)


def _overlapping(scheme: Scheme, found: Overlaps, file: str, names: list[str]) -> Iterator[Problem]:
    keys = {part.id: (part.file, part.key) for part in scheme.view.parts} if scheme.view else {}
    for pair, depth in found.pairs.items():
        worst = int(depth.argmax())
        what = message(
            "{first} and {second} overlap at {position} by up to {depth} mm, {tried}, for example"
            " in {variant}.",
            first=pair.first,
            second=pair.second,
            position=pair.position,
            depth=round(float(depth[worst]), 2),
            tried=in_sets(int((depth > 0).sum()), found.count),
            variant=names[worst],
        )
        remedy = message(
            "Change the general view, or refuse such numbers by a constraint in `variants/spaces`;"
            " what may overlap says so by `meets`, what lies apart by `depth`."
        )
        place = keys.get(pair.second, (file, ""))
        yield Problem(*place, what, remedy)
