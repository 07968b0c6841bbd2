"""BRDFLab's VTK classes: sources, filters, mappers and views for material reflection (BRDFs), and a few shorthands.

>>> import brdflab
>>> paint = brdflab.material("0.3*Lambertian + 0.04*GGX(alpha=0.2)")
>>> values, valid = brdflab.evaluate(paint, wi, wo)     # numpy arrays of unit vectors, n x 3
>>> view = brdflab.vtkBRDFLobeView()
>>> view.AddInputData(paint)
>>> view.WritePNG("lobe.png")

In a notebook a view, a BRDF and a rendered picture show themselves.
"""

# VTK's wrapped classes that ours derive from have to be loaded first.
from vtkmodules import vtkCommonExecutionModel, vtkIOCore, vtkRenderingOpenGL2  # noqa: F401

from .vtkBRDFFilters import *  # noqa: F401,F403
from .shorthands import evaluate, from_function, from_samples, material, names, pixels, png  # noqa: F401
from .notebook import show_in_notebooks as _show_in_notebooks

_show_in_notebooks()
