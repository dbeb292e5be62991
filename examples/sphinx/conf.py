project = "Parking"
extensions = ["myst_parser"]
html_theme = "furo"
html_static_path = ["_static"]
# `dist/` of the repository, copied to `_static/parkade/`.
html_js_files = [("parkade/parkade-playground.js", {"type": "module"})]
html_css_files = ["parkade.css"]
exclude_patterns = ["_build", "README.md"]
