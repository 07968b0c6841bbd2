"""A regression test of one's own material: renders it and compares with the picture kept the first time.

    regression.py [MATERIAL [BASELINE.npy]]         exit code 1 when the picture is no longer the same

`brdf baseline` does this for whole lists of pictures, as float EXR: docs/baselines.md."""

import os
import sys

import numpy as np

import brdflab

arguments = sys.argv[1:] + ["0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)", "baseline.npy"][len(sys.argv) - 1 :]
material, baseline = arguments
source = brdflab.vtkBRDFSource()
source.SetMaterial(material)
render = brdflab.vtkBRDFRender()
render.SetInputConnection(source.GetOutputPort())
render.AddDirectionalLight(45, 30, 3, 3, 3)
render.SetSize(64, 64)
if not render.UpdateAndCheck():
    sys.exit(render.GetPipelineErrorText())
picture = brdflab.pixels(render.GetOutput())
if not os.path.exists(baseline):
    np.save(baseline, picture)
    print(f"{baseline} made")
    sys.exit()
kept = np.load(baseline)
beyond = np.any(np.abs(picture - kept) > 1e-4 + 0.001 * np.abs(kept), axis=2)
print(f"{np.count_nonzero(beyond)} pixels beyond the tolerance")
sys.exit(int(beyond.mean() > 0.002))
