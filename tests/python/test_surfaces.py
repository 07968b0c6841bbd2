"""Python, the command line (BRDF_PROGRAM) and the headers agree on what there is, and on what is the default."""

import json
import os
import re
import subprocess
import tempfile
import unittest

import numpy as np

os.environ.pop("DISPLAY", None)

import brdflab  # noqa: E402

PROGRAM = os.environ["BRDF_PROGRAM"]
READ_ONLY = {"csail", "carpaint", "kaist"}


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
        with_arguments = {"relative:FLOOR", "huber:DELTA (1/sr)", "sphere", "sphere:MAP (the picture of a sphere under a map)"}
        for command in ("fit", "compare"):
            plain = {name for name in allowed(command, "--metric") if ":" not in name} - with_arguments
            self.assertEqual(plain, set(brdflab.names("metrics")), command)
        self.assertEqual(allowed("fit", "--optimizer"), brdflab.names("optimizers"))
        reported = json.loads(brdf("compare", "GGX", "GGX(alpha=0.3)", "--samples", "500", "--json", "-", "--quiet"))
        self.assertEqual(set(reported["metrics"]), set(brdflab.names("metrics")))

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
        self.assertEqual(written - {"vtkhdf", "xml", "brdflab-xml"}, set(brdflab.names("formats")) - READ_ONLY)
        self.assertEqual(set(allowed("export", "--format")), set(brdflab.names("exporters")))

    def test_every_format_written_in_python_is_recognised_and_means_the_same_everywhere(self):
        albedo = (0.3, 0.2, 0.1)
        paint = brdflab.vtkBRDFSource()
        paint.SetMaterial("(0.3,0.2,0.1)*Lambertian")
        writer, reader = brdflab.vtkBRDFWriter(), brdflab.vtkBRDFReader()
        writer.SetInputConnection(paint.GetOutputPort())
        # One incidence a file, and specular fractions only: no format for a Lambertian.
        formats = set(brdflab.names("formats")) - READ_ONLY - {"pab", "integra-specular"}
        wi, wo = [[0.0, 0.28, 0.96]], [[-0.6, 0.0, 0.8]]
        with tempfile.TemporaryDirectory() as folder:
            for name in sorted(formats | {"vtkhdf", "xml", "brdflab-xml"}):
                path = os.path.join(folder, name)
                writer.SetFileName(path)
                writer.SetFormat(name)
                self.assertTrue(writer.Write(), f"{name}: {writer.GetPipelineErrorText()}")
                self.assertTrue(reader.CanReadFile(path), name)
                reader.SetFileName(path)
                self.assertTrue(reader.UpdateAndCheck(), f"{name}: {reader.GetErrorText()}")
                if name in formats:
                    told = json.loads(brdf("info", path, "--json", "-", "--quiet"))["format"]
                    self.assertEqual(told, re.sub("^radiance_.*", "radiance", name))
                values, valid = brdflab.evaluate(reader.GetOutput(), wi, wo)
                self.assertTrue(valid.all(), name)
                expected = [0.2126 * albedo[0] + 0.7152 * albedo[1] + 0.0722 * albedo[2]] if values.size == 1 else albedo
                with self.subTest(name):
                    # Where the format has wavelengths, the channels are in their order.
                    np.testing.assert_allclose(sorted(values[0] * np.pi), sorted(expected), rtol=2e-3)


NUMBER = r"-?\d+(?:,\d{3})*(?:\.\d+)?(?:e-?\d+)?"
NUMBERS = rf"{NUMBER}(?:(?: x |, ){NUMBER})*"
OTHERS = r'"[^"]*"|on\b|off\b|[A-Z]+_[A-Z_]+|[A-Z]{4,}\b'


def stated_defaults(kind, text):
    """The values that a comment calls the default: "default 0.5", "MODE_INTERACTIVE (default)", "Empty by default"."""
    texts = re.findall(rf"[Dd]efaults? ({NUMBERS}|{OTHERS})", text) + re.findall(rf"({NUMBER}|{OTHERS}) (?:by |\((?:the )?)default", text)
    values = [""] * len(re.findall(r"[Ee]mpty (?:by |\(|\(the )default", text))
    for text in texts:
        if text.startswith('"'):
            values.append(text.strip('"'))
        elif text in ("on", "off"):
            values.append(text == "on")
        elif text[0].isupper():
            values.append(getattr(kind, text))
        else:
            numbers = [float(word.replace(",", "")) for word in re.split(" x |, ", text)]
            values.append(numbers[0] if len(numbers) == 1 else tuple(numbers))
    return values


def comment(method):
    """A method's text without its signatures."""
    paragraphs = re.split(r"\n\s*\n", (method.__doc__ or "").strip())
    return " ".join(" ".join(paragraph.split()) for paragraph in paragraphs if "C++:" not in paragraph)


def own_methods(kind, prefix):
    """Methods of this class and of its bases among ours, by name."""
    found = {}
    for base in reversed(kind.__mro__):
        if base.__name__.startswith("vtkBRDF"):
            found |= {name: method for name, method in vars(base).items() if name.startswith(prefix)}
    return found


def settings():
    """(class, property, its comment, what a new object answers) of whatever is set and got."""
    for name, kind in sorted(vars(brdflab).items()):
        if not (name.startswith("vtkBRDF") and isinstance(kind, type)):
            continue
        try:
            made = kind()
        except TypeError:  # abstract: its properties are looked at in the classes made from it
            continue
        getters = own_methods(kind, "Get")
        for setter, method in own_methods(kind, "Set").items():
            if "G" + setter[1:] not in getters:
                continue
            try:
                answer = getattr(made, "G" + setter[1:])()
            except TypeError:  # takes an argument
                continue
            if isinstance(answer, (str, bool, int, float, tuple)):
                yield kind, setter[3:], comment(method), answer


class Documentation(unittest.TestCase):
    def test_every_method_that_sets_or_adds_says_what(self):
        for name, kind in sorted(vars(brdflab).items()):
            if name.startswith("vtkBRDF") and isinstance(kind, type):
                for prefix in ("Set", "Add"):
                    for method, function in vars(kind).items():
                        if method.startswith(prefix):
                            self.assertNotEqual(comment(function), "", f"{name}.{method}")

    def test_every_property_states_its_default_which_is_that_of_a_new_object(self):
        seen = 0
        for kind, name, text, answer in settings():
            with self.subTest(f"{kind.__name__}::{name}"):
                self.assertEqual(stated_defaults(kind, text), [answer], text)
                seen += 1
        self.assertGreater(seen, 200)


if __name__ == "__main__":
    unittest.main()
