"""The package `brdflab` as a user of Python meets it."""

import contextlib
import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkObject, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData

os.environ.pop("DISPLAY", None)  # nothing here may need an X server

import brdflab  # noqa: E402


def source(material):
    made = brdflab.vtkBRDFSource()
    made.SetMaterial(material)
    made.Update()
    assert not made.GetErrorText(), made.GetErrorText()
    return made


@contextlib.contextmanager
def quiet():
    """VTK's errors are expected, and not printed."""
    vtkObject.GlobalWarningDisplayOff()
    try:
        yield
    finally:
        vtkObject.GlobalWarningDisplayOn()


def hemisphere(count, seed):
    """Unit vectors above the horizon."""
    vectors = np.random.default_rng(seed).normal(size=(count, 3))
    vectors[:, 2] = np.abs(vectors[:, 2])
    return vectors / np.linalg.norm(vectors, axis=1)[:, None]


def evaluate(brdf, wi, wo):
    values, valid = vtkDoubleArray(), vtkUnsignedCharArray()
    assert brdf.Evaluate(numpy_to_vtk(wi), numpy_to_vtk(wo), values, valid)
    return vtk_to_numpy(values), vtk_to_numpy(valid)


class Arrays(unittest.TestCase):
    """numpy to BRDF and back."""

    def test_a_table_goes_to_an_image_and_comes_back(self):
        made = source("(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.3)")
        there = brdflab.vtkBRDFTabulate()
        there.SetInputConnection(made.GetOutputPort())
        there.SetCells(24, 20, 30)
        back = brdflab.vtkBRDFFromTable()
        back.SetInputConnection(there.GetOutputPort())
        again = brdflab.vtkBRDFTabulate()
        again.SetInputConnection(back.GetOutputPort())
        again.SetCells(24, 20, 30)
        self.assertTrue(again.UpdateAndCheck(), again.GetPipelineErrorText())
        for name in ("value", "valid"):
            first, second = (vtk_to_numpy(f.GetOutput().GetPointData().GetArray(name)) for f in (there, again))
            np.testing.assert_allclose(first, second, rtol=1e-14)
        self.assertEqual(back.GetOutput().GetChannelKind(), "rgb")

    def test_a_spectral_table_keeps_its_wavelengths(self):
        wavelengths = [450.0, 500.0, 550.0, 600.0]
        flat = brdflab.from_function(lambda wi, wo: np.tile([0.1, 0.2, 0.3, 0.25], (len(wi), 1)), (4, 4, 4),
                                     wavelengths=wavelengths)
        there = brdflab.vtkBRDFTabulate()
        there.SetInputData(flat)
        there.SetCells(4, 4, 4)
        back = brdflab.vtkBRDFFromTable()
        back.SetInputConnection(there.GetOutputPort())
        self.assertTrue(back.UpdateAndCheck(), back.GetPipelineErrorText())
        self.assertEqual([back.GetOutput().GetWavelength(c) for c in range(4)], wavelengths)

    def test_a_function_is_what_its_table_gives(self):
        wi, wo = hemisphere(500, 1), hemisphere(500, 2)
        smooth = lambda wi, wo: np.stack([0.1 + 0.2 * wi[:, 2] * wo[:, 2], wi[:, 2] + wo[:, 2]], axis=1)[:, [0, 1, 1]]
        values, valid = brdflab.evaluate(brdflab.from_function(smooth, (90, 90, 90)), wi, wo)
        inside = valid & (np.minimum(wi[:, 2], wo[:, 2]) > 0.05)
        self.assertGreater(inside.sum(), 400)
        np.testing.assert_allclose(values[inside], smooth(wi, wo)[inside], atol=2e-3)

    def test_samples_come_back_at_their_own_directions(self):
        wi, wo = hemisphere(200, 3), hemisphere(200, 4)
        values = 0.2 + 0.1 * wi[:, 2] * wo[:, 2]
        values[7] = np.nan
        brdf = brdflab.from_samples(3 * wi, wo, values, uncertainty=0.01 * np.ones(200))
        self.assertEqual(brdf.GetNumberOfSamples(), 200)
        found, valid = brdflab.evaluate(brdf, wi, wo)
        self.assertTrue(valid.all())
        np.testing.assert_allclose(np.delete(found[:, 0], 7), np.delete(values, 7), rtol=1e-9)
        fit = brdflab.vtkBRDFFit()
        fit.SetInputData(brdf)
        fit.SetLobes("Lambertian")
        self.assertTrue(fit.UpdateAndCheck(), fit.GetPipelineErrorText())

    def test_what_is_no_table_and_no_samples_is_refused(self):
        image = vtkImageData()
        image.SetDimensions(8, 8, 8)
        image.AllocateScalars(11, 1)
        maker = brdflab.vtkBRDFFromTable()
        maker.SetInputData(image)
        with quiet():
            self.assertFalse(maker.UpdateAndCheck())
        self.assertIn("half/difference", maker.GetErrorText())
        wi, wo = hemisphere(5, 5), hemisphere(5, 6)
        with quiet():
            with self.assertRaisesRegex(ValueError, "wavelengths"):
                brdflab.from_samples(wi, wo, np.ones((5, 4)))
            with self.assertRaisesRegex(ValueError, "3 components"):
                brdflab.from_samples(wi[:, :2], wo, np.ones(5))
        with self.assertRaisesRegex(ValueError, "2 to 1024"):
            brdflab.from_function(lambda wi, wo: wi, cells=(1, 2, 3))


class ProgramSource(unittest.TestCase):
    def test_values_are_what_the_program_prints(self):
        made = brdflab.vtkBRDFProgramSource()
        script = "import sys\nnext(sys.stdin)\nfor line in sys.stdin: print(line.split(chr(44))[2], 2, 3)"
        made.SetCommand(f"'{sys.executable}' -c '{script}'")
        self.assertTrue(made.UpdateAndCheck(), made.GetErrorText())
        values, valid = brdflab.evaluate(made.GetOutput(), [[0.6, 0, 0.8], [0, 0, 1]], [[0, 0, 1], [0, 0, 1]])
        np.testing.assert_array_equal(values, [[0.8, 2, 3], [1, 2, 3]])
        self.assertTrue(valid.all())
        made.SetChannels("450,550,650")
        self.assertTrue(made.UpdateAndCheck(), made.GetErrorText())
        self.assertEqual(made.GetOutput().GetNumberOfChannels(), 3)

    def test_its_options_are_those_of_the_material(self):
        made = brdflab.vtkBRDFProgramSource()
        made.AddObserver("ErrorEvent", lambda *_: None)
        self.assertFalse(made.UpdateAndCheck())
        self.assertIn("no program given", made.GetErrorText())
        self.assertEqual((made.GetSymmetry(), made.GetTimeLimit(), made.GetProcesses()), ("anisotropic", 300, 0))
        made.SetCommand("false")
        self.assertFalse(made.UpdateAndCheck())
        self.assertIn("ended with exit code 1", made.GetErrorText())
        made.SetSymmetry("round")
        self.assertFalse(made.UpdateAndCheck())
        self.assertIn("isotropic, bilateral, anisotropic", made.GetErrorText())


class Slices(unittest.TestCase):
    def test_a_curve_of_a_lambertian_is_a_table_of_one_value(self):
        material = source("0.5*Lambertian")
        curve = brdflab.vtkBRDFCurve()
        curve.SetInputConnection(material.GetOutputPort())
        curve.SetQuantity("f_cos")
        curve.Update()
        table = curve.GetOutput()
        angles, values = (vtk_to_numpy(table.GetColumnByName(name)) for name in ("angle", "value"))
        self.assertEqual((angles[0], angles[-1]), (-90, 90))
        np.testing.assert_allclose(values[1:-1], 0.5 / math.pi * np.cos(np.radians(angles[1:-1])), atol=1e-14)

    def test_a_slice_is_an_image_and_a_plot_a_file_of_vectors(self):
        material = source("(0.5,0.25,0.1)*Lambertian")
        image = brdflab.vtkBRDFSlice()
        image.SetInputConnection(material.GetOutputPort())
        image.SetChannel("rgb")
        image.SetCells(8, 4)
        image.Update()
        self.assertEqual(image.GetOutput().GetDimensions(), (8, 4, 1))
        values = vtk_to_numpy(image.GetOutput().GetPointData().GetArray("value"))
        np.testing.assert_allclose(values, np.tile(np.array([0.5, 0.25, 0.1]) / math.pi, (32, 1)), rtol=1e-14)
        curve = brdflab.vtkBRDFCurve()
        curve.SetInputConnection(material.GetOutputPort())
        plot = brdflab.vtkBRDFPlotView()
        plot.AddInputConnection(curve.GetOutputPort(), "paint")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "plot.svg")
            self.assertTrue(plot.WriteVectors(path), plot.GetErrorText())
            with open(path, encoding="utf-8") as file:
                self.assertIn(">paint</text>", file.read())


class Evaluation(unittest.TestCase):
    def test_lambertian_is_albedo_over_pi(self):
        brdf = source("0.5*Lambertian").GetOutput()
        self.assertAlmostEqual(brdf.Evaluate((0, 0, 1), (0.6, 0, 0.8)), 0.5 / math.pi, places=15)

    def test_arrays_equal_single_pairs(self):
        brdf = source("(0.3,0.2,0.1)*Lambertian + GGX(alpha=0.3)").GetOutput()
        wi, wo = hemisphere(50, 1), hemisphere(50, 2)
        values, valid = evaluate(brdf, wi, wo)
        self.assertEqual(values.shape, (50, 3))
        self.assertTrue(valid.all())
        for i in range(50):
            for channel in range(3):
                # Block and single evaluation may round differently in the last places.
                single = brdf.Evaluate(wi[i], wo[i], channel)
                self.assertLess(abs(values[i, channel] - single), 1e-14 * (1 + single))

    def test_ggx_equals_its_paper(self):
        """Walter et al. 2007, equations 20, 22, 33 and 34 (height-correlated or not, G(wi = wo = n) is 1)."""
        alpha, ior = 0.3, 1.5
        expected = ((ior - 1) / (ior + 1)) ** 2 / (math.pi * alpha**2) / 4
        value = source(f"GGX(alpha={alpha}, ior={ior})").GetOutput().Evaluate((0, 0, 1), (0, 0, 1))
        self.assertLess(abs(value / expected - 1), 1e-12)

    def test_below_the_horizon_is_zero_and_valid(self):
        brdf = source("Lambertian").GetOutput()
        down = np.array([[0, 0, -1.0], [0.6, 0, -0.8]])
        values, valid = evaluate(brdf, down, hemisphere(2, 3))
        self.assertFalse(values.any())
        self.assertTrue(valid.all())


class Shorthands(unittest.TestCase):
    def test_evaluate_takes_and_gives_numpy_arrays(self):
        paint = brdflab.material("(0.3,0.2,0.1)*Lambertian")
        wi, wo = hemisphere(7, 4), hemisphere(7, 5)
        values, valid = brdflab.evaluate(paint, wi, wo)
        np.testing.assert_allclose(values, np.tile(np.array([0.3, 0.2, 0.1]) / math.pi, (7, 1)), rtol=1e-15)
        self.assertTrue(valid.all())
        np.testing.assert_array_equal(brdflab.evaluate(paint, wi.astype("f4").tolist(), wo)[0], values)
        self.assertEqual(brdflab.evaluate(paint, wi[:0], wo[:0])[0].shape[0], 0)
        with self.assertRaisesRegex(ValueError, "must be as many"):
            brdflab.evaluate(paint, wi, wo[:3])
        with self.assertRaisesRegex(ValueError, r"must be \(n, 3\)"):
            brdflab.evaluate(paint, wi[:, :2], wo)

    def test_a_material_that_is_none_is_an_exception_with_the_reason(self):
        with self.assertRaisesRegex(ValueError, "Nonsense"):
            brdflab.material("Nonsense")

    def test_names_are_those_of_the_registries(self):
        self.assertIn("GGX", brdflab.names("lobes"))
        self.assertIn("merl", brdflab.names("formats"))
        self.assertIn("rms", brdflab.names("metrics"))
        self.assertEqual(brdflab.names("optimizers")[0], "lm")
        self.assertIn("mitsuba", brdflab.names("exporters"))
        self.assertIn("bagher-sgd-gold-metallic-paint", brdflab.names("presets"))
        self.assertEqual(brdflab.names("failures"), [])
        with self.assertRaises(ValueError):
            brdflab.names("nonsense")

    def test_lobes_of_the_users_folder_are_there(self):
        folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../docs/examples/lobes")
        script = "import brdflab; print(brdflab.names('failures'), 'SatinPaint' in brdflab.names('lobes'))"
        for path, found in ((folder, "[] True"), ("", "[] False")):
            environment = dict(os.environ, BRDFLAB_MODEL_PATH=path)
            done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True)
            self.assertEqual(done.stdout.strip(), found, done.stderr)

    def test_pixels_run_from_the_top(self):
        render = brdflab.vtkBRDFRender()
        white = source("Lambertian")
        render.SetInputConnection(white.GetOutputPort())
        render.AddDirectionalLight(0, 0, math.pi, math.pi, math.pi)  # from above
        render.SetSize(24, 16)
        self.assertTrue(render.UpdateAndCheck(), render.GetPipelineErrorText())
        picture = brdflab.pixels(render.GetOutput())
        self.assertEqual(picture.shape, (16, 24, 3))
        self.assertGreater(picture[3].max(), 0.5)
        self.assertEqual(picture[12].max(), 0)

    def test_what_notebooks_show_is_a_png(self):
        class Formatter:
            def __init__(self):
                self.types = {}

            def for_type(self, kind, function):
                self.types[kind] = function

        class Shell:
            pass

        shell, formatter = Shell(), Formatter()
        shell.display_formatter = Shell()
        shell.display_formatter.formatters = {"image/png": formatter}
        brdflab.notebook.show_in_notebooks(shell)
        paint = brdflab.material("0.3*Lambertian")
        view, render = brdflab.vtkBRDFLobeView(), brdflab.vtkBRDFRender()
        view.AddInputData(paint)
        render.SetInputData(paint)
        render.AddDirectionalLight(45, 0, 3, 3, 3)
        render.SetSize(32, 32)
        for kind, thing in ((brdflab.vtkBRDF, paint), (brdflab.vtkBRDFView, view), (brdflab.vtkBRDFRender, render)):
            shown = formatter.types[kind](thing)
            self.assertEqual(shown[:8], b"\x89PNG\r\n\x1a\n", kind)
            self.assertGreater(len(shown), 300)


class Pipeline(unittest.TestCase):
    def test_lobe_of_a_lambertian(self):
        lobe = brdflab.vtkBRDFLobe()
        lambertian = source("Lambertian")
        lobe.SetInputConnection(lambertian.GetOutputPort())
        lobe.SetTransform("cuberoot")
        lobe.Update()
        points = vtk_to_numpy(lobe.GetOutput().GetPoints().GetData())
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), math.pi ** (-1 / 3), rtol=1e-14)

    def test_spectra_are_seen_under_the_light_asked_for(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "red.xml")
            with open(path, "w") as file:
                file.write(
                    "<material version='1' channels='spectral' wavelengths='450 550 650'>"
                    "<lobe model='Lambertian'><scale>0.1 0.2 0.8</scale></lobe></material>"
                )
            red = source(path)
        lobe = brdflab.vtkBRDFLobe()
        lobe.SetInputConnection(red.GetOutputPort())
        lobe.SetChannel("rgb")
        lobe.Update()
        daylight = np.array(lobe.GetOutput().GetPointData().GetArray("value").GetTuple(0))
        lobe.SetIlluminant("A")
        lobe.SetObserver("10")
        lobe.SetAdaptation("bradford")
        lobe.Update()
        self.assertEqual(lobe.GetErrorText(), "")
        lamp = np.array(lobe.GetOutput().GetPointData().GetArray("value").GetTuple(0))
        self.assertGreater(lamp[0], 1.05 * daylight[0])

    def test_table_is_a_numpy_volume(self):
        table = brdflab.vtkBRDFTabulate()
        lambertian = source("Lambertian")
        table.SetInputConnection(lambertian.GetOutputPort())
        table.SetCells(18, 9, 9)
        table.Update()
        image = table.GetOutput()
        value = vtk_to_numpy(image.GetPointData().GetArray("value"))
        valid = vtk_to_numpy(image.GetPointData().GetArray("valid"))
        self.assertEqual(image.GetDimensions(), (18, 9, 9))
        np.testing.assert_allclose(value[valid == 1], 1 / math.pi, rtol=1e-14)
        self.assertFalse(value[valid == 0].any())
        self.assertTrue(0 < valid.mean() < 1)

    def test_holes_are_told_apart_and_filled(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "holes.binary")
            cells = np.full((3, 90, 90, 180), 0.25 / math.pi) * 1500 / np.array([1, 1.15, 1.66])[:, None, None, None]
            cells[:, 10:14, 20:30, 40:60] = -1
            with open(file, "wb") as out:
                out.write(np.array([90, 90, 180], "<i4").tobytes() + cells.astype("<f8").tobytes())
            reader = brdflab.vtkBRDFReader()
            reader.SetFileName(file)
            fill = brdflab.vtkBRDFFillHoles()
            fill.SetInputConnection(reader.GetOutputPort())
            shown = brdflab.vtkBRDFCells()
            states = {}
            for method in ("none", "nearest"):
                fill.SetMethod(method)
                shown.SetInputConnection(fill.GetOutputPort())
                shown.Update()
                self.assertEqual(shown.GetErrorText(), "")
                points = shown.GetOutput().GetPointData()
                states[method] = vtk_to_numpy(points.GetArray("state")).reshape(90, 90, 180)
            self.assertEqual((states["none"][10:14, 20:30, 40:60] == 0).mean(), 1)
            self.assertEqual((states["nearest"][10:14, 20:30, 40:60] == 2).mean(), 1)
            self.assertEqual(fill.GetNumberOfFilledCells(), 4 * 10 * 20)
            value = vtk_to_numpy(points.GetArray("value"))[:, 1].reshape(90, 90, 180)
            self.assertAlmostEqual(value[12, 25, 50], 0.25 / math.pi, places=12)

    def test_files_are_written_recognised_and_read(self):
        paint = source("(0.3,0.2,0.1)*Lambertian + 0.04*GGX(alpha=0.3)")
        writer = brdflab.vtkBRDFWriter()
        writer.SetInputConnection(paint.GetOutputPort())
        reader = brdflab.vtkBRDFReader()
        with tempfile.TemporaryDirectory() as folder:
            for name, exact in (("paint.vtkhdf", True), ("paint.xml", True), ("paint.binary", False)):
                path = os.path.join(folder, name)
                writer.SetFileName(path)
                self.assertTrue(writer.Write(), writer.GetPipelineErrorText())
                self.assertTrue(reader.CanReadFile(path))
                reader.SetFileName(path)
                self.assertTrue(reader.UpdateAndCheck(), reader.GetErrorText())
                self.assertEqual(reader.GetOutput().GetDescription() == paint.GetOutput().GetDescription(), exact)
                self.assertEqual(reader.GetOutput().GetNumberOfChannels(), 3)
                os.remove(path)
                self.assertTrue(writer.Write() and os.path.exists(path))  # though nothing has changed
            self.assertIn("resampled", writer.GetLosses())

            reader.SetEntry("1")
            reader.AddObserver("ErrorEvent", lambda *_: None)
            writer.AddObserver("ErrorEvent", lambda *_: None)
            self.assertFalse(reader.UpdateAndCheck())
            self.assertIn("holds one BRDF", reader.GetErrorText())
            writer.SetFormat("nonsense")
            self.assertFalse(writer.Write())
            self.assertIn("vtkhdf", writer.GetPipelineErrorText())
            for content in (b"", b"nothing of the kind\n"):
                with open(os.path.join(folder, "other.txt"), "wb") as file:
                    file.write(content)
                self.assertFalse(reader.CanReadFile(file.name))
            self.assertFalse(reader.CanReadFile(os.path.join(folder, "missing.binary")))
            reader.SetFileName(os.path.join(folder, "missing.binary"))
            self.assertFalse(reader.UpdateAndCheck())
            self.assertIn("no such file", reader.GetErrorText())

    def test_a_container_takes_entries_by_name(self):
        writer, reader = brdflab.vtkBRDFWriter(), brdflab.vtkBRDFReader()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "several.vtkhdf")
            writer.SetFileName(path)
            reader.SetFileName(path)
            paints = {"a wall": source("0.5*Lambertian"), "gloss": source("GGX(alpha=0.3)")}
            for name, paint in paints.items():
                writer.SetInputConnection(paint.GetOutputPort())
                writer.SetEntry(name)
                self.assertTrue(writer.Write(), writer.GetPipelineErrorText())
            for name, paint in paints.items():
                reader.SetEntry(name)
                self.assertTrue(reader.UpdateAndCheck(), reader.GetErrorText())
                self.assertEqual(reader.GetOutput().GetDescription(), paint.GetOutput().GetDescription())
            writer.AddObserver("ErrorEvent", lambda *_: None)
            with open(path, "rb") as file:
                before = file.read()
            self.assertFalse(writer.Write())
            self.assertIn("not taken", writer.GetPipelineErrorText())
            writer.SetEntry("third")
            writer.SetFormat("merl")
            self.assertFalse(writer.Write())
            self.assertIn("container", writer.GetPipelineErrorText())
            with open(path, "rb") as file:
                self.assertEqual(file.read(), before)
            writer.SetFormat("")
            writer.SetEntry("")
            self.assertTrue(writer.Write())
            reader.SetEntry("1")
            reader.AddObserver("ErrorEvent", lambda *_: None)
            self.assertFalse(reader.UpdateAndCheck())

    def test_fit_of_a_formula(self):
        truth = source("0.3*Lambertian + 0.5*GGX(alpha=0.3, ior=1.5)")
        fit = brdflab.vtkBRDFFit()
        fit.SetInputConnection(truth.GetOutputPort())
        fit.SetSampling("hemisphere")
        fit.SetNumberOfSamples(2000)
        fit.SetMetric("formula:cbrt(f*cos_i)")
        fit.SetConstraints("ior=1.5")
        fit.Update()
        self.assertEqual(fit.GetErrorText(), "")
        fields = fit.GetOutput().GetFieldData()
        self.assertLess(fields.GetArray("error").GetValue(0), 1e-6)
        self.assertEqual(fit.GetRegions().GetNumberOfRows(), 4)

    def test_fit_of_measured_data(self):
        path = os.path.join(os.environ.get("BRDF_SHARED_DIR", ""), "data/measured/garnet_red.brdf")
        if not os.path.exists(path):
            self.skipTest("no measured data at " + path)
        reader = brdflab.vtkBRDFReader()
        reader.SetFileName(path)
        fit = brdflab.vtkBRDFFit()
        fit.SetInputConnection(reader.GetOutputPort())
        fit.SetChannels("luminance")
        fit.SetLobes("Lambertian + GGX")
        fit.Update()
        fields = fit.GetOutput().GetFieldData()
        self.assertLess(fields.GetArray("error").GetValue(0), 0.0209)  # 1/sr; a global search found 0.0208
        self.assertLess(fields.GetArray("error").GetValue(0), fields.GetArray("zeroModelError").GetValue(0))
        self.assertGreater(fit.GetParameters().GetNumberOfRows(), 2)


    def test_error_map_has_tables(self):
        a, b = source("0.9*Lambertian"), source("0.4*Lambertian")
        errors = brdflab.vtkBRDFErrorMap()
        errors.SetInputConnection(0, a.GetOutputPort())
        errors.SetInputConnection(1, b.GetOutputPort())
        errors.SetAxes("hemisphere")
        errors.SetMeasure("difference")
        errors.SetIntervals(20)
        errors.SetNumberOfWorst(3)
        errors.Update()
        self.assertEqual(errors.GetErrorText(), "")
        self.assertAlmostEqual(errors.GetQuantile(0.5), 0.5 / math.pi, places=14)
        counts = vtk_to_numpy(errors.GetHistogram().GetColumnByName("count"))
        self.assertEqual(counts.sum(), errors.GetNumberOfPairs())
        worst = errors.GetWorst()
        self.assertEqual(worst.GetNumberOfRows(), 3)
        self.assertAlmostEqual(worst.GetValueByName(0, "theta_i").ToDouble(), 45, places=10)

    def test_direction_widget_has_angles(self):
        widget = brdflab.vtkBRDFDirectionWidget()
        widget.SetTheta(120)
        widget.SetPhi(-30)
        self.assertEqual((widget.GetTheta(), widget.GetPhi()), (89, -30))  # never at the horizon


class Simulation(unittest.TestCase):
    def test_a_microsurface_becomes_a_table_and_a_balance(self):
        surface = brdflab.vtkBRDFMicrosurfaceSource()
        surface.SetSurface("gaussian(rms=0.5, correlation=2, period=32)")
        meter = brdflab.vtkBRDFGonioreflectometer()
        meter.SetInputConnection(surface.GetOutputPort())
        meter.AddFacet("lambertian(albedo=0.5)")
        meter.SetThetaI("0,60")
        meter.SetTolerance(0.2)
        self.assertTrue(meter.UpdateAndCheck(), meter.GetPipelineErrorText())
        self.assertTrue(meter.GetOutput().GetDescription().startswith("simulated: gaussian"))
        balance = meter.GetBalance()
        self.assertEqual(balance.GetNumberOfRows(), 2)
        parts = {name: vtk_to_numpy(balance.GetColumnByName(name)) for name in ("reflected", "absorbed", "sum", "lost")}
        np.testing.assert_allclose(parts["reflected"] + parts["absorbed"] + parts["lost"], parts["sum"], atol=1e-9)
        self.assertTrue(np.all(parts["reflected"] < 0.5))  # what goes from facet to facet is absorbed more


class Pictures(unittest.TestCase):
    def test_a_view_writes_a_png(self):
        view = brdflab.vtkBRDFLobeView()
        view.SetSize(300, 240)
        matte = source("Lambertian")  # a port does not keep its source alive
        view.AddInputConnection(matte.GetOutputPort(), "matte")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "lobe.png")
            self.assertTrue(view.WritePNG(path), view.GetErrorText())
            with open(path, "rb") as file:
                self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
        image = vtkImageData()
        self.assertTrue(view.Capture(image))
        self.assertEqual(image.GetDimensions(), (300, 240, 1))
        pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(240, 300, 3).astype(int)
        blue = (pixels[..., 2] > pixels[..., 0] + 40) & (pixels[..., 2] > pixels[..., 1] + 20)
        self.assertGreater(blue.mean(), 0.1)

    def test_without_egl_there_is_one_line_of_reason(self):
        script = (
            "import brdflab\n"
            "window = brdflab.vtkBRDFHeadlessRenderWindow()\n"
            "print(window.IsAvailable(), window.GetErrorText())\n"
            "source = brdflab.vtkBRDFSource()\n"
            "view = brdflab.vtkBRDFLobeView()\n"
            "view.AddInputConnection(source.GetOutputPort())\n"
            "print(view.WritePNG('never.png'), view.GetErrorText())\n"
        )
        environment = dict(os.environ, __EGL_VENDOR_LIBRARY_FILENAMES="/dev/null")
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [sys.executable, "-c", script], env=environment, cwd=folder, capture_output=True, text=True, timeout=120
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(os.listdir(folder), [])
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 2)
        self.assertTrue(lines[0].startswith("False no EGL"), lines)
        self.assertTrue(lines[1].startswith("False") and "no EGL" in lines[1], lines)


if __name__ == "__main__":
    unittest.main(verbosity=2)
