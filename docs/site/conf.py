"""The site: Markdown alone, read offline."""

project = "geodesic"
extensions = ["myst_parser"]
myst_heading_anchors = 4
html_theme = "alabaster"
html_theme_options = {"page_width": "72em", "fixed_sidebar": True,
                      "show_powered_by": False}
html_show_sourcelink = False
html_copy_source = False
