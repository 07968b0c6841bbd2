"""vtkBRDFWaveSource: exact values and Mueller matrices in Python."""

import math
import os
import unittest

os.environ.pop("DISPLAY", None)

import brdflab  # noqa: E402
import numpy as np  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import vtkDoubleArray  # noqa: E402


def directions(*angles):
    theta, phi = np.radians(np.array(angles, dtype=float)).T
    return np.column_stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])


def mueller(source, wi, wo, channel=0):
    matrices = vtkDoubleArray()
    assert source.EvaluateMueller(numpy_to_vtk(wi), numpy_to_vtk(wo), matrices, channel), source.GetErrorText()
    return vtk_to_numpy(matrices).reshape(-1, 4, 4)


class WaveSource(unittest.TestCase):
    def test_mueller_matrices_hold_the_value_and_the_law_of_fresnel(self):
        source = brdflab.vtkBRDFWaveSource()
        source.SetModel("Facet(eta=1.5, slopes=gaussian(s=0.3))")
        source.Update()
        brewster = math.degrees(math.atan(1.5))
        wi, wo = directions((brewster, 180), (20, 180)), directions((brewster, 0), (40, 30))
        matrices = mueller(source, wi, wo)
        values, valid = brdflab.evaluate(source.GetOutput(), wi, wo)
        self.assertTrue(valid.all())
        np.testing.assert_allclose(matrices[:, 0, 0], values[:, 0], rtol=1e-13)
        # At Brewster's angle only s is reflected: I = Q.
        np.testing.assert_allclose(matrices[0, :2, :2], matrices[0, 0, 0] * np.ones((2, 2)), rtol=1e-12)

    def test_material_expressions_mean_the_same(self):
        model = "RayleighRice(wavelength=(0.45, 0.55), spectrum=abc(a=0.01, b=5, c=3))"
        source = brdflab.vtkBRDFWaveSource()
        source.SetModel(model)
        source.Update()
        wi, wo = directions((30, 180)), directions((45, 20))
        values, _ = brdflab.evaluate(source.GetOutput(), wi, wo)
        same, _ = brdflab.evaluate(brdflab.material("wave:" + model), wi, wo)
        self.assertEqual(values.tolist(), same.tolist())
        self.assertEqual(source.GetOutput().GetWavelength(1), 550)
        self.assertEqual(mueller(source, wi, wo, 1)[0, 0, 0], values[0, 1])

    def test_every_model_makes_a_brdf(self):
        names = brdflab.vtkBRDFWaveSource.GetModelNames()
        self.assertGreaterEqual(names.GetNumberOfValues(), 10)
        for k in range(names.GetNumberOfValues()):
            source = brdflab.vtkBRDFWaveSource()
            source.SetModel(names.GetValue(k))
            self.assertTrue(source.UpdateAndCheck(), names.GetValue(k))

    def test_errors_are_told(self):
        source = brdflab.vtkBRDFWaveSource()
        source.SetModel("RayleighRice(wavelenght=1)")
        source.GetExecutive()
        brdflab.vtkBRDFWaveSource.GlobalWarningDisplayOff()
        self.assertFalse(source.UpdateAndCheck())
        self.assertIn("did you mean wavelength?", source.GetErrorText())


if __name__ == "__main__":
    unittest.main()
