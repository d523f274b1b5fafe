"""How the pages of this folder become a site: `make docs-site`."""

project = "fieldspec"
author = "The fieldspec authors"
extensions = ["myst_parser"]
exclude_patterns = ["images/README.md"]
myst_heading_anchors = 4
myst_enable_extensions = ["attrs_inline"]
html_theme = "furo"
html_title = "fieldspec"
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
html_last_updated_fmt = None
# What is not printed is unknown: `text` blocks are output, which no highlighter knows.
highlight_language = "none"
