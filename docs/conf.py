"""How the documentation is built: ``sphinx-build -W -n -b html docs docs/_build/html``."""

import sys
from importlib.metadata import version as version_of
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "_ext"))

project = "Barchan"
author = "The Barchan developers"
copyright = author
version = release = version_of("barchan")

extensions = ["myst_parser", "sphinx.ext.autodoc", "generate", "tutorials", "references", "mathml"]
exclude_patterns = ["_build", "_generated/parts"]
source_suffix = {".md": "markdown"}

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3

autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
smartquotes_action = "q"
autodoc_typehints_format = "short"
maximum_signature_line_length = 80

nitpick_ignore_regex = [
    # Libraries whose own documentation is not linked, so that the build needs no network.
    (r"py:.*", r"(numpy|np|xarray|xr|matplotlib|pydantic|cyclopts)(\..*)?"),
    (r"py:.*", r"(collections|pathlib|typing|datetime)\..*|Path|Any|Callable|Iterator|Sequence|Mapping"),
    (r"py:.*", r"NDArray|ndarray|Figure|(int|float|bool_|u?int)\d*|integer"),
    # The kinds of wind are told with the keys of scenarios; the type of any of them is spelled out.
    (r"py:.*", r"types\.Annotated|NoneType|barchan\.wind\.(steady|regimes|mixed_axes|recorded|storms)\..*"),
    # Types that the documented ones return or hold, and that nobody makes by hand.
    (r"py:class", r"barchan\.wind\.(forcing|interval|records\.record)\..*"),
    (r"py:class", r"barchan\.analysis\.declared_measures\..*|Value|barchan\.export\.grid\.Grid"),
]

html_theme = "furo"
html_math_renderer = "mathml"
html_title = f"Barchan {version}"
html_static_path = ["_static"]
html_css_files = ["barchan.css"]
html_copy_source = False
html_show_sphinx = False
