"""The server-manager XML of the ParaView plugin against the classes and registries; needs no ParaView.

usage: test_descriptions.py BRDF      with the package brdflab on PYTHONPATH
"""

import glob
import json
import math
import os
import re
import subprocess
import sys
import unittest
from xml.etree import ElementTree

import brdflab
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkRenderingCore import vtkMapper

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PLUGIN = os.path.join(ROOT, "paraview", "plugin")
BRDF = sys.argv.pop(1)

NOT_OFFERED = {
    "vtkBRDFEXRWriter": "pictures are written by ParaView",
    "vtkBRDFRender": "its lights, objects and camera are objects; the representation draws surfaces",
    "vtkBRDFToneMap": "for pictures of vtkBRDFRender",
}


def proxies(*tags):
    """(proxy, class name) of every proxy in the plugin's files."""
    for path in sorted(glob.glob(os.path.join(PLUGIN, "*.xml"))):
        for proxy in ElementTree.parse(path).iter():
            if proxy.tag in tags:
                yield proxy, proxy.get("class")


def properties(proxy):
    return [child for child in proxy if child.tag.endswith("VectorProperty")]


def values_of(prop):
    text = prop.get("default_values")
    if prop.tag == "StringVectorProperty":
        return text
    values = [float(word) for word in text.split()]
    return values[0] if len(values) == 1 else values


def refusal(kind, **settings):
    """The error of a class with some settings on a Lambertian or a flat microsurface; empty when there is none."""
    source, surface = brdflab.vtkBRDFModelSource(), brdflab.vtkBRDFMicrosurfaceSource()
    source.SetModel("Lambertian")
    surface.SetSurface("flat")
    algorithm = getattr(brdflab, kind)()
    for port in range(algorithm.GetNumberOfInputPorts()):
        wanted = algorithm.GetInputPortInformation(port).Get(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), 0)
        made = surface if wanted == "vtkBRDFMicrosurface" else source
        algorithm.SetInputConnection(port, made.GetOutputPort())
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.AddObserver("ErrorEvent", lambda *_: None)
    return "" if algorithm.UpdateAndCheck() else algorithm.GetPipelineErrorText()


class Descriptions(unittest.TestCase):
    def test_files_are_what_the_generator_writes(self):
        done = subprocess.run(
            [sys.executable, os.path.join(ROOT, "paraview", "describe.py"), BRDF, "--check"], capture_output=True, text=True
        )
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_every_algorithm_is_offered_or_has_a_reason_not_to_be(self):
        kinds = {n: k for n, k in vars(brdflab).items() if isinstance(k, type) and issubclass(k, vtkAlgorithm)}
        bases = {base.__name__ for kind in kinds.values() for base in kind.__mro__[1:]}
        drawing = (brdflab.vtkBRDFView, vtkMapper)
        offered = {kind for _, kind in proxies("SourceProxy", "WriterProxy")}
        left = {n for n, k in kinds.items() if n not in bases and not issubclass(k, drawing)} - offered
        self.assertEqual(left, set(NOT_OFFERED), "give them a place in paraview/describe/proxies.py, or a reason here")

    def test_every_default_is_that_of_the_getter(self):
        compared = 0
        for proxy, kind in proxies("SourceProxy", "WriterProxy"):
            if not hasattr(brdflab, kind):
                self.assertEqual(properties(proxy), [], f"{kind} has settings, and no getters to compare them with")
                continue
            instance = getattr(brdflab, kind)()
            for prop in properties(proxy):
                where = f"{proxy.get('name')}.{prop.get('name')}"
                self.assertTrue((prop.findtext("Documentation") or "").strip(), where)
                command = prop.get("command")
                if command == "SetModel":
                    instance.SetModel(prop.get("default_values"))
                    continue
                if command == "SetParameter":
                    expected = instance.GetParameter(prop.get("initial_string"))
                    self.assertEqual(prop.get("name"), prop.get("initial_string"))
                elif command.startswith("Add"):
                    self.assertIsNone(prop.get("default_values"), where)
                    continue
                else:
                    expected = getattr(instance, "G" + command[1:])()
                expected = list(expected) if isinstance(expected, tuple) else expected
                self.assertEqual(values_of(prop), expected, where)
                compared += 1
        self.assertGreater(compared, 200)

    def test_defaults_of_the_representation_are_the_mappers(self):
        mapper, environment = brdflab.vtkBRDFPolyDataMapper(), brdflab.vtkBRDFEnvironment()
        expected = {
            "EnvironmentFile": "",
            "UseEnvironment": 1,  # the representation has one of its own
            "ShowEnvironment": 0,
            "EnvironmentRotation": environment.GetRotation(),
            "Exposure": mapper.GetExposure(),
            "EnvironmentSamples": mapper.GetNumberOfSamples(),
            "ResamplingTolerance": mapper.GetResamplingTolerance(),
        }
        ((proxy, _),) = proxies("RepresentationProxy")
        self.assertEqual({p.get("name"): values_of(p) for p in properties(proxy)}, expected)
        (group,) = ElementTree.parse(PLUGIN + "/representations.xml").iter("PropertyGroup")
        exposed = {p.get("name") for p in group.iter("Property")}
        self.assertEqual(exposed, set(expected))
        arrow = brdflab.vtkBRDFDirectionRepresentation()
        (proxy,) = [p for p, kind in proxies("Proxy") if kind == arrow.GetClassName()]
        for name in ("Theta", "Phi", "Visibility"):
            (prop,) = [p for p in properties(proxy) if p.get("name") == name]
            self.assertEqual(values_of(prop), getattr(arrow, "Get" + name)())

    def test_every_lobe_is_a_source_with_all_its_parameters(self):
        models = json.loads(subprocess.run([BRDF, "models", "--json", "-"], check=True, capture_output=True).stdout)
        sources = {
            prop.get("default_values"): proxy
            for proxy, kind in proxies("SourceProxy")
            for prop in properties(proxy)
            if kind == "vtkBRDFModelSource" and prop.get("command") == "SetModel"
        }
        self.assertEqual(set(sources), {model["name"] for model in models})
        for model in models:
            described = {p.get("name"): p for p in properties(sources[model["name"]]) if p.get("initial_string")}
            self.assertEqual(list(described), [p["name"] for p in model["parameters"]], model["name"])
            for parameter in model["parameters"]:
                text = described[parameter["name"]].find("Documentation").text
                self.assertIn(parameter["description"], text)
                self.assertIn(f"unit {parameter['unit']};", text)
                low, high = (float(described[parameter["name"]].find("DoubleRangeDomain").get(e)) for e in ("min", "max"))
                self.assertTrue(parameter["min"] <= low < high <= parameter["max"], (model["name"], parameter))

    def test_every_format_has_its_extension_in_the_dialogs(self):
        for factory, names in (("ReaderFactory", "extensions"), ("WriterFactory", "extensions written")):
            (element,) = [e for p, _ in proxies("SourceProxy", "WriterProxy") for e in p.iter(factory)]
            offered = {"." + extension for extension in element.get("extensions").split()}
            self.assertEqual(set(brdflab.names(names)) - offered, set())
        self.assertIn(".binary", offered)

    def test_every_choice_is_taken_and_no_other(self):
        for proxy, kind in proxies("SourceProxy"):
            for prop in properties(proxy):
                choices = [e.get("value") for domain in prop.findall("StringListDomain") for e in domain]
                if not choices:
                    continue
                name = prop.get("command")[3:]
                for choice in choices:
                    # What the data lack (samples, cells, wavelengths) may be refused, the name may not.
                    self.assertNotIn("unknown", refusal(kind, **{name: choice}), (kind, name, choice))
                text = refusal(kind, **self.context(kind, name) | {name: "nonsense"})
                self.assertIn("nonsense", text, (kind, name))
                allowed = re.search(r"allowed: (.*?)(?: \(|$)", text).group(1)
                # Axes of wavelength are spoken of where the angle is wrong.
                offered = {choice for choice in choices if not choice.endswith(",wavelength")}
                self.assertEqual(set(re.split(", | or ", allowed)), offered, (kind, name))

    @staticmethod
    def context(kind, name):
        """Settings under which the class looks at another."""
        return {"Axes": "hemisphere"} if (kind, name) == ("vtkBRDFErrorMap", "Projection") else {}

    def test_parameters_of_a_lobe_are_those_of_the_expression(self):
        source = brdflab.vtkBRDFModelSource()
        source.SetModel("Ward")
        source.SetParameter("ax", 0.1)
        source.SetScale(0.3, 0.2, 0.1)
        source.Update()
        followed = source.GetOutput().GetDescription()
        self.assertEqual(followed, brdflab.material("(0.3,0.2,0.1)*Ward(ax=0.1)").GetDescription())
        source.SetParameter("ay", 0.3)
        source.Update()
        self.assertEqual(
            source.GetOutput().GetDescription(), brdflab.material("(0.3,0.2,0.1)*Ward(ax=0.1, ay=0.3)").GetDescription()
        )
        source.TiedOn()
        source.Update()
        self.assertEqual(source.GetOutput().GetDescription(), followed)
        self.assertTrue(math.isnan(source.GetParameter("roughness")))
        source.AddObserver("ErrorEvent", lambda *_: None)
        for name, value, found in (("roughness", 0.1, "roughness"), ("ax", -1.0, "-1")):
            source.RemoveAllParameters()
            source.SetParameter(name, value)
            self.assertFalse(source.UpdateAndCheck())
            self.assertIn(found, source.GetErrorText())


vtkObject.GlobalWarningDisplayOff()  # errors are looked at
unittest.main()
