"""How Sphinx puts the pages together; scripts/documentation.py calls it."""

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
