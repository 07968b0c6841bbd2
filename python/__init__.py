"""BRDFLab's VTK classes: sources, filters, mappers and views for material reflection (BRDFs).

>>> import brdflab
>>> source = brdflab.vtkBRDFSource()
>>> source.SetMaterial("0.3*Lambertian + 0.04*GGX(alpha=0.2)")
>>> source.Update()
>>> source.GetOutput().Evaluate((0, 0, 1), (0, 0, 1))
"""

# VTK's wrapped classes that ours derive from have to be loaded first.
from vtkmodules import vtkCommonExecutionModel, vtkIOCore, vtkRenderingOpenGL2  # noqa: F401

from .vtkBRDFFilters import *  # noqa: F401,F403
