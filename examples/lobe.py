"""The lobe of a material for one incident direction, as a picture: lobe.py [MATERIAL [PICTURE.png]]"""

import sys

import brdflab

source = brdflab.vtkBRDFSource()
source.SetMaterial(sys.argv[1] if len(sys.argv) > 1 else "0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)")

view = brdflab.vtkBRDFLobeView()
view.AddInputConnection(source.GetOutputPort())
view.SetThetaI(45)
view.SetSize(450, 350)
if not view.WritePNG(sys.argv[2] if len(sys.argv) > 2 else "lobe.png"):
    sys.exit(view.GetErrorText())
