"""A filter of one's own in Python, from a BRDF to a table: how wide the highlight is, by angle of incidence.

    highlight.py [MATERIAL]         prints the table"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkTable

import brdflab


class HighlightWidth(VTKPythonAlgorithmBase):
    """Full width at half maximum, degrees, of f_r in the plane of incidence about the mirror direction."""

    def __init__(self):
        super().__init__(nInputPorts=1, inputType="vtkBRDF", nOutputPorts=1, outputType="vtkTable")

    def RequestData(self, request, inputs, outputs):
        brdf = brdflab.vtkBRDF.GetData(inputs[0])
        incidence = np.arange(0, 80, 15)
        widths = []
        for theta_i in np.radians(incidence):
            theta_o = np.radians(np.linspace(-89.9, 89.9, 3597))
            wo = np.stack([-np.sin(theta_o), 0 * theta_o, np.cos(theta_o)], axis=1)
            wi = np.tile([np.sin(theta_i), 0, np.cos(theta_i)], (len(wo), 1))
            value = brdflab.evaluate(brdf, wi, wo)[0].mean(axis=1)
            peak = np.argmin(np.abs(theta_o - theta_i))
            below = np.flatnonzero(value < value[peak] / 2)
            left, right = below[below < peak], below[below > peak]
            closed = len(left) and len(right)
            widths.append(np.degrees(theta_o[right[0]] - theta_o[left[-1]]) if closed else np.nan)
        table = vtkTable.GetData(outputs)
        for name, column in (("theta_i", incidence.astype(float)), ("width", np.array(widths))):
            array = numpy_to_vtk(column, deep=True)
            array.SetName(name)
            table.AddColumn(array)
        return 1


source = brdflab.vtkBRDFSource()
source.SetMaterial(sys.argv[1] if len(sys.argv) > 1 else "GGX(alpha=0.1)")
width = HighlightWidth()
width.SetInputConnection(source.GetOutputPort())
width.Update()
table = width.GetOutputDataObject(0)
for theta, degrees in zip(*(vtk_to_numpy(table.GetColumnByName(name)) for name in ("theta_i", "width"))):
    print(f"{theta:4.0f} degrees: {degrees:.1f} degrees wide")
