"""Python, the command line (BRDF_PROGRAM) and the headers agree on what there is, and on what is the default."""

import json
import os
import re
import subprocess
import unittest

os.environ.pop("DISPLAY", None)

import brdflab  # noqa: E402

PROGRAM = os.environ["BRDF_PROGRAM"]


def brdf(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=True).stdout


def allowed(command, option):
    """The names that the help of a command lists for an option."""
    line = re.search(rf"^  {option} NAME .*", brdf(command, "--help"), re.MULTILINE).group()
    names = line.split("; with settings")[0].rsplit(": ", 1)[1]
    return re.split(r", | or ", re.sub(r" \[[^\]]*\]$", "", names))


class Registries(unittest.TestCase):
    def test_every_lobe_is_in_the_command_line_and_makes_a_material(self):
        models = json.loads(brdf("models", "--json", "-"))
        self.assertEqual([model["name"] for model in models], brdflab.names("lobes"))
        for name in brdflab.names("lobes"):
            self.assertGreater(brdflab.material(name).GetNumberOfChannels(), 0, name)

    def test_every_default_of_a_lobe_written_out_means_the_lobe(self):
        wo, wi = [[0.36, 0.48, 0.8]], [[-0.48, 0.36, 0.8]]
        for model in json.loads(brdf("models", "--json", "-")):
            written = ", ".join(f"{p['name']}={p['default']!r}" for p in model["parameters"])
            bare, _ = brdflab.evaluate(brdflab.material(model["name"]), wi, wo)
            full, _ = brdflab.evaluate(brdflab.material(f"{model['name']}({written})"), wi, wo)
            self.assertEqual(bare.tolist(), full.tolist(), model["name"])

    def test_every_metric_and_optimizer_is_in_the_command_line(self):
        for command in ("fit", "compare"):
            self.assertLessEqual(set(brdflab.names("metrics")), set(allowed(command, "--metric")), command)
        self.assertEqual(allowed("fit", "--optimizer"), brdflab.names("optimizers"))
        reported = json.loads(brdf("compare", "GGX", "GGX(alpha=0.3)", "--samples", "500", "--json", "-", "--quiet"))
        self.assertLessEqual({"rms", "rms_cos", "log", "cuberoot"}, set(reported["metrics"]))

    def test_every_metric_and_optimizer_is_taken_by_the_filter(self):
        source = brdflab.vtkBRDFSource()
        source.SetMaterial("0.3*Lambertian")
        for setter, kind in (("SetMetric", "metrics"), ("SetOptimizer", "optimizers")):
            for name in brdflab.names(kind):
                fit = brdflab.vtkBRDFFit()
                fit.SetInputConnection(source.GetOutputPort())
                fit.SetLobes("Lambertian")
                fit.SetNumberOfSamples(500)
                getattr(fit, setter)(name)
                self.assertTrue(fit.UpdateAndCheck(), f"{name}: {fit.GetPipelineErrorText()}")

    def test_every_format_and_exporter_that_writes_is_in_the_command_line(self):
        written = set(allowed("convert", "--format"))
        self.assertLessEqual(written - {"vtkhdf", "xml", "brdflab-xml"}, set(brdflab.names("formats")))
        self.assertEqual(set(allowed("export", "--format")), set(brdflab.names("exporters")))


def documented_defaults():
    """(class, property, what its header says is the default, what a new object answers), where the header says one
    value of one property."""
    for name in sorted(dir(brdflab)):
        kind = getattr(brdflab, name)
        if not (name.startswith("vtk") and isinstance(kind, type)):
            continue
        try:
            made = kind()
        except TypeError:  # abstract
            continue
        for method in dir(kind):
            if not method.startswith("Set") or not hasattr(kind, "G" + method[1:]):
                continue
            text = re.sub(r"\s+", " ", getattr(kind, method).__doc__ or "")
            stated = re.findall(r'defaults? (?:is )?(-?\d[\d,]*\.?\d*(?:e-?\d+)?|"[^"]*"|on\b|off\b)', text)
            stated += re.findall(r'("[^"]*") \(default', text) if not stated else []
            if len(stated) != 1:
                continue
            try:
                answer = getattr(made, "G" + method[1:])()
            except TypeError:  # takes an argument
                continue
            yield name, method[3:], stated[0], answer


class DocumentedDefaults(unittest.TestCase):
    def test_are_what_a_new_object_has(self):
        seen = 0
        for name, which, stated, answer in documented_defaults():
            with self.subTest(f"{name}::{which}"):
                if isinstance(answer, str):
                    if not stated.startswith('"'):
                        continue
                    expected = stated.strip('"')
                elif stated in ("on", "off"):
                    expected, answer = stated == "on", bool(answer)
                elif stated.startswith('"') or isinstance(answer, (bool, tuple)):
                    continue
                else:
                    expected = float(stated.replace(",", ""))
                self.assertEqual(answer, expected)
                seen += 1
        self.assertGreater(seen, 60)


if __name__ == "__main__":
    unittest.main()
