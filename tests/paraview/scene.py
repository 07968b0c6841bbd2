"""Run by pvpython and pvbatch: pipelines of the plugin, what they give, and their pictures.

usage: scene.py FOLDER draw [SERVER_URL [remote]]     draws FOLDER/sphere.png, FOLDER/lobe.png, and saves the state
       scene.py FOLDER reopen STATE PICTURE           opens a state file and draws its sphere
       scene.py FOLDER blocks                         draws two surfaces apart, as two blocks, and one of those hidden
       scene.py FOLDER drag                           drags the arrow of the light from 45 to 20 degrees
       scene.py FOLDER extended                       uses what the plugin in examples/plugin registers
       scene.py FOLDER proxies                        makes and updates every proxy

FOLDER/task.json says what to draw; results go to FOLDER/result.json.
"""

import json
import math
import os
import sys

import paraview.simple as simple
from paraview import servermanager, smstate
from vtkmodules.util.numpy_support import vtk_to_numpy

FOLDER, WHAT, *REST = sys.argv[1:]
with open(os.path.join(FOLDER, "task.json")) as file:
    TASK = json.load(file)


def path(name):
    return os.path.join(FOLDER, name)


def result(**values):
    with open(path("result.json"), "w") as file:
        json.dump(values, file)


def field(source, name):
    """A string of the field data, which describes the BRDF."""
    array = source.GetDataInformation(0).GetFieldDataInformation().GetArrayInformation(name)
    return array.GetStringValue(0) if array else None


def look_from(view, camera):
    view.CameraPosition = camera["position"]
    view.CameraFocalPoint = camera["focal_point"]
    view.CameraViewUp = camera["view_up"]
    view.CameraViewAngle = camera["view_angle"]


def save(view, name):
    simple.SaveScreenshot(path(name), view, ImageResolution=TASK["size"], TransparentBackground=0)


def plain_view(name):
    view = simple.CreateView("RenderView", registrationName=name)
    view.ViewSize = TASK["size"]
    view.UseColorPaletteForBackground = 0
    view.Background = [0, 0, 0]
    view.OrientationAxesVisibility = 0
    return view


def draw():
    if REST:
        host, port = REST[0].split(":")
        simple.Connect(host, int(port))
        if REST[1:] == ["remote"]:
            simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0
    target = simple.OpenDataFile(TASK["target"])
    fit = simple.BRDFFit(registrationName="fit", Input=target, **TASK["fit"])
    lobe = simple.BRDFLobe(registrationName="lobe", Input=fit, ThetaI=30.0)
    shape = simple.BRDFObject(Object="sphere")
    surface = simple.BRDFSurfaceMaterial(registrationName="surface", Input=shape, Material=fit)
    view = plain_view("sphere")
    shown = simple.Show(surface, view)
    shown.Representation = "BRDF under light"
    shown.EnvironmentFile = TASK["environment"]
    shown.EnvironmentSamples = TASK["samples"]
    simple.Render(view)  # the first one moves the camera
    look_from(view, TASK["camera"])
    simple.Render(view)
    save(view, "sphere.png")
    shown.ShowEnvironment = 1
    shown.EnvironmentRotation = 70
    save(view, "sky.png")
    shown.ShowEnvironment = 0
    shown.EnvironmentRotation = 0

    other = plain_view("lobe")
    simple.Show(lobe, other)
    simple.ResetCamera(other)
    simple.Render(other)
    save(other, "lobe.png")

    points = servermanager.Fetch(lobe)
    simple.SaveState(path("state.pvsm"))
    with open(path("state.py"), "w") as file:
        file.write(smstate.get_state())
    result(
        reader=target.GetXMLName(),
        fit=field(fit, "vtkBRDF"),
        error=fit.GetDataInformation(0).GetFieldDataInformation().GetArrayInformation("error").GetComponentRange(0)[0],
        points=vtk_to_numpy(points.GetPoints().GetData())[:: TASK["stride"]].tolist(),
        count=points.GetNumberOfPoints(),
        window=view.GetRenderWindow().GetClassName(),
    )


def reopen():
    state, picture = REST
    if state.endswith(".py"):
        with open(path(state)) as file:
            exec(compile(file.read(), state, "exec"), {"__name__": "state"})
    else:
        simple.LoadState(path(state))
    surface = simple.FindSource("surface")  # states as Python name the views anew
    (view,) = [v for v in simple.GetViews() if any(getattr(r, "Input", None) == surface for r in v.Representations)]
    save(view, picture)
    result(fit=field(simple.FindSource("fit"), "vtkBRDF"))


def make(name, inputs):
    """One proxy with every input that it needs, updated."""
    made = getattr(simple, name)(**inputs)
    made.UpdatePipeline()
    return made


SAMPLES = """
import numpy as np
wi = np.array([[0.6, 0, 0.8], [0, 0, 1], [0, 0.6, 0.8], [0.6, 0, 0.8]])
output.RowData.append(wi, "wi")
output.RowData.append(wi[::-1].copy(), "wo")
output.RowData.append(np.full(4, 0.1), "value")
"""


def proxies():
    material = simple.BRDFMaterial(Material=TASK["material"])
    material.UpdatePipeline()
    table = simple.BRDFReader(FileName=TASK["target"])
    table.UpdatePipeline()
    spectral = simple.BRDFMaterial(Material=TASK["spectral"])
    sphere = simple.BRDFObject(Object="sphere")
    samples = simple.ProgrammableSource(OutputDataSetType="vtkTable", Script=SAMPLES)
    grooves = simple.BRDFMicrosurface(Surface="grooves(width=4, spacing=10, angle=120)")
    special = {
        "BRDFCells": {"Input": table},
        "BRDFFillHoles": {"Input": table},
        "BRDFHoleMap": {"Input": table},
        "BRDFLobeSamples": {"Input": table},
        "BRDFErrorMap": {"Input": material, "Reference": material},
        "BRDFSpectrum": {"Input": spectral, "Directions": [30.0, 0.0, 30.0, 180.0, 0.0, 0.0, 60.0, 0.0]},
        "BRDFFit": {"Input": table, "Lobes": "Lambertian", "Channels": "luminance", "MaximumTheta": 30.0},
        "BRDFFromTable": {"Input": make("BRDFTabulate", {"Input": material, "Cells": [18, 9, 9]})},
        "BRDFFromSamples": {"Input": samples},
        "BRDFSurfaceMaterial": {"Input": sphere, "Material": material},
        "BRDFMicrosurfaceFromData": {"Input": simple.Wavelet(WholeExtent=[0, 7, 0, 7, 0, 0]), "HeightScale": 0.001},
        "BRDFMicrosurfaceGeometry": {"Input": grooves},
        "BRDFGonioreflectometer": {"Input": grooves, "ThetaI": "30", "Tolerance": 0.3},
    }
    outputs, types = {}, {}
    for name in TASK["lobes"]:
        outputs[name] = field(make(name, {}), "vtkBRDF")
    special["BRDFProgram"] = {"Command": TASK["program"]}
    for name in TASK["sources"]:
        made = make(name, special.get(name, {}))
        types[name] = [made.GetDataInformation(0).GetDataClassName(), field(made, "vtkBRDF")]
    for name in TASK["filters"]:
        made = make(name, special.get(name, {"Input": material}))
        ports = made.SMProxy.GetNumberOfOutputPorts()
        types[name] = [made.GetDataInformation(k).GetDataClassName() for k in range(ports)]
    for extension in TASK["extensions"]:
        file = path("written" + extension)
        simple.SaveData(file, proxy=material)
        read = simple.OpenDataFile(file)
        read.UpdatePipeline()
        types["written" + extension] = [read.GetXMLName(), field(read, "vtkBRDF")]
    types["plain.csv"] = [simple.OpenDataFile(path("plain.csv")).GetXMLName()]

    fit = simple.BRDFFit(Input=table)
    errors = simple.BRDFErrorMap(Input=material, Reference=material)
    # Which inputs the user interface allows.
    domain = fit.GetProperty("Input").SMProperty.GetDomain("input_type")
    allowed = {}
    for name, proxy in (("material", material), ("sphere", sphere), ("lobe", make("BRDFLobe", {"Input": material}))):
        fit.GetProperty("Input").SMProperty.SetUncheckedInputConnection(0, proxy.SMProxy, 0)
        allowed[name] = domain.IsInDomain(fit.GetProperty("Input").SMProperty)
        fit.GetProperty("Input").SMProperty.RemoveAllUncheckedProxies()
    result(
        lobes=outputs,
        types=types,
        metrics=fit.GetProperty("Metric").GetAvailable(),
        optimizers=fit.GetProperty("Optimizer").GetAvailable(),
        measures=errors.GetProperty("Measure").GetAvailable(),
        allowed=allowed,
    )


def extended():
    turned = simple.BRDFMaterial(Material="turned:45,Ward(ax=0.1, ay=0.4)")
    turned.UpdatePipeline()
    truth = simple.BRDFMaterial(Material="0.2*WorkshopGloss(n=50)")
    fit = simple.BRDFFit(Input=truth, Lobes="WorkshopGloss", Metric="fourth_root", Optimizer="compass")
    fit.NumberOfSamples = 2000
    fit.UpdatePipeline()
    result(
        turned=field(turned, "vtkBRDF"),
        fit=field(fit, "vtkBRDF"),
        metrics=fit.GetProperty("Metric").GetAvailable(),
        optimizers=fit.GetProperty("Optimizer").GetAvailable(),
    )


def blocks():
    sphere = simple.BRDFObject(Object="sphere")
    moved = simple.Transform(Input=sphere)
    moved.Transform.Translate = [2.2, 0.3, 0.0]
    paint, metal = simple.BRDFMaterial(Material=TASK["material"]), simple.BRDFMaterial(Material="GGX(alpha=0.3)")
    pair = [
        simple.BRDFSurfaceMaterial(Input=sphere, Material=paint),
        simple.BRDFSurfaceMaterial(Input=moved, Material=metal),
    ]
    group = simple.GroupDatasets(Input=pair)
    group.UpdatePipeline()
    blocks = group.GetDataInformation(0).DataInformation.GetNumberOfDataSets()
    camera = {"position": [1.1, 1, 9], "focal_point": [1.1, 0.1, 0], "view_up": [0, 1, 0], "view_angle": 30}
    for name, surfaces in (("apart", pair), ("together", [group]), ("first", pair[:1])):
        view = plain_view(name)
        for surface in surfaces:
            shown = simple.Show(surface, view)
            shown.Representation = "BRDF under light"
            shown.EnvironmentFile = TASK["environment"]
            place = "Translation" if "Translation" in shown.ListProperties() else "Position"  # until 5.12
            setattr(shown, place, [0.0, -0.2, 0.0])
        simple.Render(view)
        look_from(view, camera)
        simple.Render(view)
        save(view, name + ".png")
        if name == "together":
            simple.Hide(group, view)
            save(view, "hidden.png")
            simple.Show(group, view)
            group.Input = pair[:1]
            save(view, "fewer.png")
            shown.Representation = "Wireframe"
            save(view, "wireframe.png")
            group.Input, shown.Representation = pair, "BRDF under light"
            simple.Render(view)  # to end with several
    result(blocks=blocks)


def drag():
    view = plain_view("drag")
    view.ViewSize = [400, 400]
    simple.Show(simple.BRDFLobe(Input=simple.BRDFMaterial()), view)
    simple.Render(view)
    look_from(view, {"position": [0, -6, 0], "focal_point": [0, 0, 0], "view_up": [0, 0, 1], "view_angle": 30})
    widget = servermanager.ProxyManager().NewProxy("representations", "BRDFDirectionWidgetRepresentation")
    widget.UpdateVTKObjects()
    view.SMProxy.GetProperty("HiddenRepresentations").AddProxy(widget)
    view.SMProxy.UpdateVTKObjects()
    arrow = servermanager._getPyProxy(widget)
    arrow.Enabled = arrow.Visibility = 1
    simple.Render(view)
    interactor = view.GetInteractor()

    def point(theta):
        """The pixel of the arrow's middle, 1.2 from the origin."""
        scale = 1.2 * 200 / (6 * math.tan(math.radians(15)))
        return [round(200 + scale * f(math.radians(theta))) for f in (math.sin, math.cos)]

    start = arrow.Theta
    for event, theta in (
        ("MouseMoveEvent", 45),
        ("LeftButtonPressEvent", 45),
        ("MouseMoveEvent", 20),
        ("LeftButtonReleaseEvent", 20),
    ):
        interactor.SetEventInformation(*point(theta), 0, 0, "\0", 0, None)
        interactor.InvokeEvent(event)
    widget.UpdatePropertyInformation()
    result(start=start, theta=arrow.Theta, phi=arrow.Phi)


{"draw": draw, "blocks": blocks, "drag": drag, "extended": extended, "reopen": reopen, "proxies": proxies}[WHAT]()
