"""Pictures in Jupyter. VTK's classes take no new methods, so IPython is told how to show them."""

import sys

from . import vtkBRDFFilters as _classes
from .shorthands import png


def show_in_notebooks(shell=None):
    """Registers the pictures with the running IPython, or with `shell`; does nothing elsewhere."""
    if shell is None:
        ipython = sys.modules.get("IPython")
        shell = ipython.get_ipython() if ipython else None
    if shell is None:
        return
    formatter = shell.display_formatter.formatters["image/png"]
    for kind in (_classes.vtkBRDF, _classes.vtkBRDFView, _classes.vtkBRDFRender):
        formatter.for_type(kind, png)
