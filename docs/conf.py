"""How Sphinx puts the pages together; scripts/documentation.py calls it."""

from typing import Any

from sphinx.application import Sphinx

project = "gripcourse"
author = "The gripcourse authors"
language = "en"

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}  # docstrings are not Markdown
myst_enable_extensions = ["deflist", "fieldlist"]
myst_heading_anchors = 4

# Docstrings name classes shortly; where two modules have one name the first is linked.
suppress_warnings = ["ref.python"]

autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented_params"
# Attributes that a docstring describes stand there; said twice they would be two of one name.
napoleon_use_ivar = True

html_theme = "furo"
html_title = "gripcourse"
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
# The formula reference has pages of its own.
html_extra_path = ["../extra"]

# What is wider than a telephone and moves inside of a frame of its own: a keyboard must reach it.
_SCROLLED = {
    "<pre>": '<pre tabindex="0">',
    '<div class="table-wrapper': '<div tabindex="0" class="table-wrapper',
}


def setup(app: Sphinx) -> None:
    """Take every page into our hands after the theme's."""
    app.connect("html-page-context", let_all_read, priority=900)


def let_all_read(
    _app: Sphinx, _page: str, _template: str, context: dict[str, Any], _: object
) -> None:
    """Let a keyboard move what scrolls, and give the captions of the menu a level."""
    menu = context.get("furo_navigation_tree", "")
    context["furo_navigation_tree"] = menu.replace(
        'role="heading"', 'role="heading" aria-level="2"'
    )
    body = context.get("body", "")
    for begin, reached in _SCROLLED.items():
        body = body.replace(begin, reached)
    context["body"] = body
