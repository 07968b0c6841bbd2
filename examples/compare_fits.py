"""Two fits of one measured material and a map of each one's errors: compare_fits.py [MEASURED [LOBES_A [LOBES_B]]]"""

import sys

import brdflab

arguments = sys.argv[1:] + ["preset:bagher-sgd-gold-metallic-paint", "Lambertian + GGX", "Lambertian + Ward"][len(sys.argv) - 1 :]
measured = brdflab.vtkBRDFSource()
measured.SetMaterial(arguments[0])

for lobes, picture in zip(arguments[1:], ("errors-a.png", "errors-b.png")):
    fit = brdflab.vtkBRDFFit()
    fit.SetInputConnection(measured.GetOutputPort())
    fit.SetLobes(lobes)
    fit.SetMaximumTheta(80)

    view = brdflab.vtkBRDFErrorMapView()
    view.SetInputConnection(0, fit.GetOutputPort())
    view.SetInputConnection(1, measured.GetOutputPort())
    view.GetErrorMap().SetMeasure("cuberoot")
    view.SetNameA(lobes)
    view.SetNameB("measured")
    view.SetSize(450, 350)
    if not view.WritePNG(picture):
        sys.exit(view.GetErrorText())
    print(f"{lobes}: {fit.GetOutput().GetDescription()}")
