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

# What the theme writes, and what stands in its place: captions of the menu have no level, and a
# keyboard does not reach what is wider than a telephone and moves inside of a frame of its own.
_READ_BY_ALL = {
    'role="heading"': 'role="heading" aria-level="2"',
    "<pre>": '<pre tabindex="0">',
    '<div class="table-wrapper': '<div tabindex="0" class="table-wrapper',
}

# A table that is wider than a telephone is moved inside of its frame: its columns need not be as
# narrow as a word. The index breaks its long names instead.
_STYLE = (
    "<style>@media (max-width: 46em) {"
    " td:nth-child(2), td:last-child { min-width: 9em } }"
    " .indextable { table-layout: fixed; overflow-wrap: anywhere }</style>"
)


def setup(app: Sphinx) -> None:
    """Take every page into our hands after the theme's."""
    app.connect("html-page-context", let_all_read, priority=900)


def let_all_read(
    _app: Sphinx, _page: str, _template: str, context: dict[str, Any], _tree: object
) -> None:
    """Change what the theme wrote."""
    for name in ("body", "furo_navigation_tree"):
        for written, better in _READ_BY_ALL.items():
            context[name] = context.get(name, "").replace(written, better)
    context["metatags"] = context.get("metatags", "") + _STYLE
