"""Whether the pictures that the documentation shows of the examples are those that they draw, on this device, too:
on average within 2 of 255 levels.

usage: compare_pictures.py SHOWN_FOLDER DRAWN_FOLDER      with the package brdflab on PYTHONPATH
"""

import pathlib
import sys

import numpy as np

import brdflab
from vtkmodules.vtkIOImage import vtkPNGReader


def picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return brdflab.pixels(reader.GetOutput())[..., :3].astype(float)


shown, drawn = (pathlib.Path(folder) for folder in sys.argv[1:3])
names = sorted(path.name for path in shown.glob("*.png"))
assert names, f"{shown}: no pictures"
for name in names:
    a, b = picture(shown / name), picture(drawn / name)
    if a.shape != b.shape or np.abs(a - b).mean() > 2:
        sys.exit(f"{shown / name} is no longer what the example draws: {drawn / name}")
