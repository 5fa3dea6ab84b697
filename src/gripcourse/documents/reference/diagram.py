"""The kinematic diagram of a scheme, to the sizes of its worked example."""

from gripcourse.documents.reference.occurrence import Content
from gripcourse.drawing.diagram.kinematic_diagram import kinematic_diagram
from gripcourse.solver.plan import make_plan
from gripcourse.text.words import Words


def diagram_of(content: Content, words: Words) -> str | None:
    """Draw the diagram of a scheme as an SVG element for a page.

    Returns:
        None where the scheme declares no diagram, or no worked example that gives it sizes.
    """
    scheme = content.scheme
    if scheme.example is None:
        return None
    plan = make_plan(content.course, scheme.id, scheme.example.options)
    drawn = kinematic_diagram(plan, scheme.example.given, words.language)
    return None if drawn is None else drawn.svg()
