"""Fits lobes to a material and renders a sphere of the fit: fit_and_render.py [MEASURED [ENVIRONMENT.exr]]"""

import sys

import brdflab
from vtkmodules.vtkIOImage import vtkPNGWriter

measured = brdflab.vtkBRDFSource()
measured.SetMaterial(sys.argv[1] if len(sys.argv) > 1 else "preset:bagher-sgd-gold-metallic-paint")
fit = brdflab.vtkBRDFFit()
fit.SetInputConnection(measured.GetOutputPort())
fit.SetLobes("Lambertian + GGX")

environment = brdflab.vtkBRDFEnvironment()  # radiance 1 from everywhere, unless a file is given
if len(sys.argv) > 2 and not environment.ReadFile(sys.argv[2]):
    sys.exit(environment.GetErrorText())
render = brdflab.vtkBRDFRender()
render.SetInputConnection(fit.GetOutputPort())
render.SetEnvironment(environment)
render.SetSize(128, 128)
if not render.UpdateAndCheck():
    sys.exit(render.GetPipelineErrorText())
print(fit.GetOutput().GetDescription())

exr = brdflab.vtkBRDFEXRWriter()  # linear radiance
exr.SetInputConnection(render.GetOutputPort())
exr.SetFileName("sphere.exr")
exr.Write()

tone_map = brdflab.vtkBRDFToneMap()  # sRGB
tone_map.SetInputConnection(render.GetOutputPort())
png = vtkPNGWriter()
png.SetInputConnection(tone_map.GetOutputPort())
png.SetFileName("sphere.png")
png.Write()
