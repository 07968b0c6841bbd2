"""The ParaView plugin in pvpython, pvbatch and against a pvserver, beside the package brdflab: the same numbers, the same
pictures, and states that open again.

usage: test_plugin.py FOLDER BRDF      FOLDER of scripts/build-paraview-plugin.sh; brdflab on PYTHONPATH

Exits with 77 where there is no plugin, or no X server to draw with.
"""

import glob
import json
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

import numpy as np

import brdflab
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
FOLDER, BRDF = (os.path.abspath(path) for path in sys.argv[1:3])
DISPLAY = os.path.join(ROOT, "scripts", "with-display.sh")
FIT = {"Lobes": "Lambertian + GGX", "MaximumTheta": 80.0}
SIZE = [300, 300]
SAMPLES = 128
# ParaView draws at pixel centres in a window, the renderer smooths silhouettes: the margin inside is compared. Both
# round to 8 bits; the rest is the rounding of the two cameras in float.
LEVELS = 1


def skip(reason):
    print("skipped:", reason)
    sys.exit(77)


PLUGINS = glob.glob(os.path.join(FOLDER, "build", "lib", "*", "plugins", "BRDFLab", "BRDFLab.so"))
if not PLUGINS:
    skip(f"no ParaView plugin in {FOLDER}: scripts/build-paraview-plugin.sh builds one")
LIBRARY = glob.glob(os.path.join(os.path.dirname(os.path.dirname(BRDF)), "lib", "libbrdf.so"))
if LIBRARY and os.path.getmtime(LIBRARY[0]) > os.path.getmtime(PLUGINS[0]):
    skip(f"{PLUGINS[0]} is older than {LIBRARY[0]}: scripts/build-paraview-plugin.sh builds it anew")
if not shutil.which("Xvfb"):
    skip("no Xvfb (package xvfb): ParaView draws in windows only")


def program(name):
    return os.path.join(FOLDER, "bin", name)


def environment():
    """Without the Python package that is made for another VTK, and without the user's settings and plugins."""
    kept = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "DISPLAY")}
    return kept | {"HOME": os.environ.get("TMPDIR", "/tmp"), "XDG_CONFIG_HOME": "/nonexistent"}


def picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return brdflab.pixels(reader.GetOutput())[..., :3].astype(int)


def names_in(file, group):
    """Names of the proxies of a group of one of the plugin's files."""
    groups = ElementTree.parse(os.path.join(ROOT, "paraview", "plugin", file)).getroot()
    return [proxy.get("name") for g in groups if g.get("name") == group for proxy in g]


class Plugin(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.target = os.path.join(cls.scratch.name, "gold.binary")
        subprocess.run(
            [BRDF, "convert", "preset:bagher-sgd-gold-metallic-paint", cls.target, "--quiet"], check=True, timeout=300
        )
        cls.environment_map = os.path.join(ROOT, "datasets", "environments", "venice.exr")
        cls.reader = brdflab.vtkBRDFReader()
        cls.reader.SetFileName(cls.target)
        cls.fit = brdflab.vtkBRDFFit()
        cls.fit.SetInputConnection(cls.reader.GetOutputPort())
        for name, value in FIT.items():
            getattr(cls.fit, "Set" + name)(value)
        assert cls.fit.UpdateAndCheck(), cls.fit.GetPipelineErrorText()
        cls.lobe = brdflab.vtkBRDFLobe()
        cls.lobe.SetInputConnection(cls.fit.GetOutputPort())
        cls.lobe.SetThetaI(30)
        cls.lobe.Update()
        cls.render()

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    @classmethod
    def render(cls):
        """The sphere of the fit by our own renderer, as ParaView is to draw it; and before surroundings that are turned."""
        light = brdflab.vtkBRDFEnvironment()
        assert light.ReadFile(cls.environment_map), light.GetErrorText()
        render = brdflab.vtkBRDFRender()
        render.SetInputConnection(cls.fit.GetOutputPort())
        render.SetEnvironment(light)
        render.SetBackground(1)
        render.SetSize(*SIZE)
        render.SetNumberOfSamples(SAMPLES)
        assert render.UpdateAndCheck(), render.GetPipelineErrorText()
        tone_map = brdflab.vtkBRDFToneMap()
        tone_map.SetInputData(render.GetOutput())
        tone_map.Update()
        cls.sphere = brdflab.pixels(tone_map.GetOutput()).astype(int)
        light.SetRotation(70)
        render.SetBackground(0)
        assert render.UpdateAndCheck(), render.GetPipelineErrorText()
        tone_map.SetInputData(render.GetOutput())
        tone_map.Update()
        cls.sky = brdflab.pixels(tone_map.GetOutput()).astype(int)
        camera = render.GetActiveCamera()
        cls.camera = {
            "position": camera.GetPosition(),
            "focal_point": camera.GetFocalPoint(),
            "view_up": camera.GetViewUp(),
            "view_angle": camera.GetViewAngle(),
        }

    def folder(self, **task):
        folder = tempfile.mkdtemp(dir=self.scratch.name)
        common = {
            "target": self.target,
            "environment": self.environment_map,
            "fit": FIT,
            "camera": self.camera,
            "size": SIZE,
            "samples": SAMPLES,
            "stride": 50,
        }
        with open(os.path.join(folder, "task.json"), "w") as file:
            json.dump(common | task, file)
        return folder

    def run_scene(self, interpreter, folder, *words, **variables):
        command = [DISPLAY, program(interpreter), os.path.join(HERE, "scene.py"), folder, *words]
        done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=environment() | variables)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("ERR|", done.stderr)
        with open(os.path.join(folder, "result.json")) as file:
            return json.load(file)

    def check_drawing(self, folder, result):
        """Numbers and pictures as the package brdflab gives them."""
        self.assertEqual(result["reader"], "BRDFReader")
        self.assertEqual(result["fit"], self.fit.GetOutput().GetDescription())
        self.assertEqual(result["error"], self.fit.GetOutput().GetFieldData().GetArray("error").GetValue(0))
        points = vtk_to_numpy(self.lobe.GetOutput().GetPoints().GetData())
        self.assertEqual(result["count"], len(points))
        np.testing.assert_array_equal(np.array(result["points"], points.dtype), points[::50])
        drawn = picture(os.path.join(folder, "sphere.png"))
        y, x = np.mgrid[: SIZE[1], : SIZE[0]] + 0.5
        inside = np.hypot(x - SIZE[0] / 2, y - SIZE[1] / 2) < 0.43 * SIZE[1]
        differences = np.abs(drawn - self.sphere)[inside]
        self.assertLessEqual(differences.max(), LEVELS, f"{(differences > LEVELS).mean():.3g} of the numbers differ")
        self.assertGreater(self.sphere[inside].std(), 20)
        behind = np.hypot(x - SIZE[0] / 2, y - SIZE[1] / 2) > 0.5 * SIZE[1]
        sky = picture(os.path.join(folder, "sky.png"))
        self.assertEqual(drawn[behind].max(), 0)
        self.assertGreater(self.sky[behind].std(), 10)
        # Both interpolate, each in a picture of its own.
        self.assertLess(np.abs(sky - self.sky)[behind].mean(), 1.5)
        self.assertLessEqual(np.abs(sky - self.sky)[inside].max(), LEVELS)
        lobe = picture(os.path.join(folder, "lobe.png"))
        self.assertGreater((lobe.sum(axis=2) > 60).mean(), 0.02)
        return drawn

    def test_pvpython_and_states_that_open_again(self):
        folder = self.folder()
        drawn = self.check_drawing(folder, self.run_scene("pvpython", folder, "draw"))
        for state in ("state.pvsm", "state.py"):
            again = self.run_scene("pvpython", folder, "reopen", state, "again.png")
            self.assertEqual(again["fit"], self.fit.GetOutput().GetDescription())
            np.testing.assert_array_equal(picture(os.path.join(folder, "again.png")), drawn)

    def test_pvbatch(self):
        folder = self.folder()
        self.check_drawing(folder, self.run_scene("pvbatch", folder, "draw"))

    def test_what_the_page_shows_runs(self):
        with open(os.path.join(ROOT, "docs", "paraview.md")) as file:
            snippets = re.findall(r"```python\n(.*?)```", file.read(), re.DOTALL)
        folder = tempfile.mkdtemp(dir=self.scratch.name)
        with open(os.path.join(folder, "page.py"), "w") as file:
            file.write("\n".join(snippets))
        os.symlink(self.target, os.path.join(folder, "gold.binary"))
        os.symlink(os.path.join(ROOT, "datasets"), os.path.join(folder, "datasets"))
        command = [DISPLAY, program("pvbatch"), "page.py"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=environment(), cwd=folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("ERR|", done.stderr)
        for name in ("lobe.png", "errors.png", "curve.png", "scene.png"):
            self.assertGreater(picture(os.path.join(folder, name)).std(), 5, name)

    def test_plugins_of_brdflab_are_there_with_nothing_built_again(self):
        workshop = os.path.join(os.path.dirname(os.path.dirname(BRDF)), "tests", "installed", "plugin-build")
        if not os.path.exists(os.path.join(workshop, "workshop.so")):
            self.skipTest("examples/plugin is built by the test package.APluginAddsToEveryRegistryOfTheInstalledProgram")
        result = self.run_scene("pvpython", self.folder(), "extended", BRDFLAB_PLUGIN_PATH=workshop)
        self.assertEqual(result["turned"], "turned:45,Ward(ax=0.1, ay=0.4)")
        n = float(re.search(r"WorkshopGloss\(n=([0-9.]+)\)", result["fit"]).group(1))
        self.assertAlmostEqual(n, 50, delta=0.1)
        self.assertIn("fourth_root", result["metrics"])
        self.assertIn("compass", result["optimizers"])

    def test_blocks_are_drawn_each_with_its_material(self):
        folder = self.folder(material="(0.6,0.3,0.1)*Lambertian")
        result = self.run_scene("pvpython", folder, "blocks")
        self.assertEqual(result["blocks"], 2)
        drawn = {name: picture(os.path.join(folder, name + ".png"))
                 for name in ("apart", "together", "first", "fewer", "hidden", "wireframe")}
        np.testing.assert_array_equal(drawn["together"], drawn["apart"])
        np.testing.assert_array_equal(drawn["fewer"], drawn["first"])
        self.assertEqual(drawn["hidden"].max(), 0)
        self.assertGreater(np.any(drawn["apart"] != drawn["first"], axis=2).mean(), 0.05)
        self.assertGreater(np.any(drawn["wireframe"] != drawn["first"], axis=2).mean(), 0.05)

    def test_the_arrow_follows_the_pointer(self):
        result = self.run_scene("pvpython", self.folder(), "drag")
        # To a pixel, of which one is 0.4 degrees on the circle of 149 pixels that the arrow's middle runs on.
        self.assertAlmostEqual(result["theta"], 20, delta=0.6)
        self.assertAlmostEqual(result["start"], 45, delta=1e-12)

    def test_pvserver_draws_itself_and_lets_the_client_draw(self):
        for where in ((), ("remote",)):
            with socket.socket() as free:
                free.bind(("127.0.0.1", 0))
                port = free.getsockname()[1]
            server = subprocess.Popen(
                [DISPLAY, program("pvserver"), f"--server-port={port}", "--timeout=5"],
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                env=environment(),
            )
            try:
                for line in server.stdout:
                    if line.startswith("Accepting connection"):
                        break
                folder = self.folder()
                self.check_drawing(folder, self.run_scene("pvpython", folder, "draw", f"localhost:{port}", *where))
                server.wait(60)  # it ends with its client
            finally:
                server.kill()
                server.stdout.close()

    def test_every_proxy_works_and_every_name_is_offered(self):
        with open(os.path.join(self.scratch.name, "spectral.xml"), "w") as file:
            file.write(
                "<material version='1' channels='spectral' wavelengths='450 550 650'>"
                "<lobe model='Lambertian'><scale>0.1 0.2 0.8</scale></lobe></material>"
            )
        # One incidence a file, and specular fractions only: not for this material.
        extensions = sorted(set(brdflab.names("extensions written")) - {".pab", ".sdr"})
        folder = self.folder(
            material="(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2)",
            spectral=file.name,
            lobes=names_in("lobes.xml", "sources"),
            sources=sorted(set(names_in("sources.xml", "sources")) - {"BRDFReader"}),
            program=f"{sys.executable} {ROOT}/examples/external/v_groove.py --walls 40 --albedo 0.8 --rays 100",
            filters=names_in("filters.xml", "filters"),
            extensions=extensions,
        )
        with open(os.path.join(folder, "plain.csv"), "w") as file:
            file.write("a,b\n1,2\n")
        result = self.run_scene("pvpython", folder, "proxies")
        for name, description in result["lobes"].items():
            self.assertRegex(description or "", r"^\(1,1,1\)\*[A-Z]", name)
        self.assertEqual(len(result["lobes"]), len(brdflab.names("lobes")))
        for kind, first in (("metrics", []), ("optimizers", [])):
            self.assertEqual(result[kind], first + brdflab.names(kind))
        self.assertEqual(result["measures"], ["absolute", "difference"] + brdflab.names("metrics"))
        self.assertEqual(result["allowed"], {"material": 1, "sphere": 0, "lobe": 0})
        types = result["types"]
        self.assertEqual(types["BRDFFit"], ["vtkDataObject", "vtkTable", "vtkTable"])
        self.assertEqual(types["BRDFLobe"], ["vtkPolyData"])
        self.assertEqual(types["BRDFSlice"], ["vtkImageData"])
        self.assertEqual(types["BRDFGonioreflectometer"], ["vtkDataObject", "vtkTable"])
        for extension in extensions:
            self.assertEqual(types["written" + extension][0], "BRDFReader", extension)
            self.assertTrue(types["written" + extension][1], extension)
        self.assertEqual(types["BRDFMaterial"], ["vtkDataObject", brdflab.material("Lambertian").GetDescription()])
        for name, kind in (("BRDFWave", "vtkDataObject"), ("BRDFProgram", "vtkDataObject"), ("BRDFObject", "vtkPolyData")):
            self.assertEqual(types[name][0], kind)
        for name in ("BRDFWave", "BRDFProgram"):
            self.assertTrue(types[name][1], name)
        self.assertIn("GGX(alpha=0.2", types["written.vtkhdf"][1])
        self.assertEqual(types["plain.csv"], ["CSVReader"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
