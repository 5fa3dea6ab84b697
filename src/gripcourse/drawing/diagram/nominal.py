"""The type of a mechanism rather than a variant of it: a diagram that gives no answer away.

A diagram to a variant's own sizes can be measured: every angle that a student is asked for stands
in its lines. An assignment shows the proportions that the scheme's author declared, one and the
same picture for every variant with the same options.
"""

from collections.abc import Mapping

from gripcourse.solver.plan import Plan, usual_values


def nominal_values(plan: Plan) -> Mapping[str, float]:
    """Return the values, in declared units, to which an assignment's diagram is drawn.

    Args:
        plan: of the scheme with the variant's options; nothing else of the variant is known here.
    """
    diagram = plan.scheme.diagram
    return usual_values(plan) | dict(diagram.nominal if diagram is not None else {})
