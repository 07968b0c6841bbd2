"""What ParaView offers: which class is a source, which a filter, and how its settings are entered. Names, defaults,
bounds and texts come from the classes."""

from dataclasses import dataclass, field

import brdflab

ANGLE = {"low": -360.0, "high": 360.0}
POLAR = {"low": 0.0, "high": 89.9}
ADVANCED = {"advanced": True}
TRANSFORMS = {"choices": ["none", "cuberoot", "log", "logfloor"]}
LOBES = {"mention": ("Lobes", lambda: brdflab.names("lobes"))}
CHANNELS = {
    "Channel": {},
    "Illuminant": ADVANCED,
    "Observer": {"choices": ["2", "10"], "advanced": True},
    "Adaptation": {"choices": ["bradford", "none"], "advanced": True},
}
COLOURS = {name: how for name, how in CHANNELS.items() if name != "Channel"}
LIGHT = ("Light", ["ThetaI", "PhiI"], "BRDFDirection")


DATA = "of surfaces from images and meshes, which are a filter"


@dataclass
class Proxy:
    """A source or filter. `settings`: property name -> how it is entered (properties.KEYS), in the panel's order.
    `inputs`: (name, port, types, optional), types None for a BRDF. `left_out`: settings of the class that are no
    property, with the reason. `groups`: (title, properties, panel widget or None). `outputs`: names of several ports."""

    name: str
    kind: str
    settings: dict
    inputs: list = field(default_factory=list)
    outputs: list = field(default_factory=list)
    left_out: dict = field(default_factory=dict)
    groups: list = field(default_factory=list)
    view: str = None
    text: str = None
    extra: list = field(default_factory=list)
    category: str = "BRDF"


MATERIAL = ("Input", 0, None, False)

SOURCES = [
    Proxy("BRDFMaterial", "vtkBRDFSource", {"Material": {"lines": True} | LOBES}),
    Proxy(
        "BRDFProgram",
        "vtkBRDFProgramSource",
        {
            "Command": {},
            "Channels": {},
            "Symmetry": {"choices": ["anisotropic", "bilateral", "isotropic"]},
            "Reciprocal": {},
            "Stay": {},
            "TimeLimit": {"low": 0.0, "high": 3600.0, "advanced": True},
            "Processes": {"low": 0, "high": 64, "advanced": True},
        },
    ),
    Proxy("BRDFObject", "vtkBRDFObjectSource", {"Object": {"mention": ("Shapes", lambda: brdflab.vtkBRDFObjectSource.GetShapeNames().split())}}),
    Proxy("BRDFWave", "vtkBRDFWaveSource", {"Model": {}}),
    Proxy(
        "BRDFMicrosurface", "vtkBRDFMicrosurfaceSource", {"Surface": {}}, left_out={"HeightScale": DATA, "Period": DATA}
    ),
]

READERS = [
    Proxy("BRDFReader", "vtkBRDFReader", {"FileName": {"file": "open"}, "Entry": {}, "Assumptions": {}}),
]

WRITERS = [
    Proxy("BRDFWriter", "vtkBRDFWriter", {"FileName": {"file": "save"}, "Format": {}, "Entry": {}}, [MATERIAL]),
]

FILTERS = [
    Proxy(
        "BRDFLobe",
        "vtkBRDFLobe",
        {
            "ThetaI": POLAR,
            "PhiI": ANGLE,
            "Transform": TRANSFORMS,
            "Floor": {"low": 1e-9, "high": 1.0, "show_if": ("Transform", "logfloor")},
            "Shape": {"choices": ["value", "difference", "displaced"]},
            **CHANNELS,
            "Colour": {},
            "Resolution": {"low": 0, "high": 9, "advanced": True},
            "Tolerance": {"low": 0.0, "high": 1.0, "advanced": True},
            "MaximumTriangles": ADVANCED,
        },
        [MATERIAL, ("Second", 1, None, True)],
        groups=[LIGHT],
    ),
    Proxy(
        "BRDFLobeSamples",
        "vtkBRDFLobeSamples",
        {
            "ThetaI": POLAR,
            "PhiI": ANGLE,
            "Within": {"low": 0.0, "high": 180.0},
            "Transform": TRANSFORMS,
            "Floor": {"low": 1e-9, "high": 1.0, "show_if": ("Transform", "logfloor")},
            **CHANNELS,
            "MaximumPoints": ADVANCED,
        },
        [MATERIAL, ("Model", 1, None, True)],
        groups=[LIGHT],
    ),
    Proxy(
        "BRDFSlice",
        "vtkBRDFSlice",
        {
            "Axes": {
                "choices": ["theta_h,theta_d", "theta_i,theta_o"]
                + [angle + ",wavelength" for angle in ("theta_o", "phi", "theta_h", "theta_d", "phi_d")]
            },
            "Cells": {"low": 1, "high": 8192},
            "Warp": {"low": 0.1, "high": 10.0},
            **{name: POLAR for name in ("ThetaI", "ThetaO", "ThetaH", "ThetaD")},
            **{name: ANGLE for name in ("PhiI", "Phi", "PhiH", "PhiD")},
            **CHANNELS,
        },
        [MATERIAL],
        groups=[("Fixed angles (degrees)", ["ThetaI", "ThetaO", "ThetaH", "ThetaD", "PhiI", "Phi", "PhiH", "PhiD"], None)],
    ),
    Proxy(
        "BRDFCurve",
        "vtkBRDFCurve",
        {
            "Angle": {"choices": ["theta_o", "phi", "theta_h", "theta_d", "phi_d"]},
            "Quantity": {"choices": ["f", "f_cos"]},
            **{name: POLAR for name in ("ThetaI", "ThetaO", "ThetaH", "ThetaD")},
            **{name: ANGLE for name in ("PhiI", "Phi", "PhiH", "PhiD")},
            **CHANNELS,
            "Intervals": {"low": 1, "high": 100000, "advanced": True},
            "SampleTolerance": {"low": 0.0, "high": 90.0, "advanced": True},
        },
        [MATERIAL],
        outputs=["Values", "Samples"],
        groups=[("Fixed angles (degrees)", ["ThetaI", "ThetaO", "ThetaH", "ThetaD", "PhiI", "Phi", "PhiH", "PhiD"], None)],
        view="XYChartView",
    ),
    Proxy(
        "BRDFAlbedo",
        "vtkBRDFAlbedo",
        {"Intervals": {}, "PhiI": ANGLE, **CHANNELS, "Points": ADVANCED},
        [MATERIAL],
        view="XYChartView",
    ),
    Proxy(
        "BRDFErrorMap",
        "vtkBRDFErrorMap",
        {
            "Measure": {"names": "metrics", "first": "absolute difference"},
            "Average": {"choices": ["automatic", "rms", "absolute", "signed"]},
            "Axes": {"choices": ["theta_i,theta_o", "theta_h,theta_d", "theta_d,phi_d", "hemisphere"]},
            "ThetaI": POLAR | {"show_if": ("Axes", "hemisphere")},
            "PhiI": ANGLE | {"show_if": ("Axes", "hemisphere")},
            "Projection": {"choices": ["equal-area", "orthographic"], "show_if": ("Axes", "hemisphere")},
            "SampleAngle": {"low": 0.0, "high": 180.0, "show_if": ("Axes", "hemisphere")},
            "Directions": {"choices": ["automatic", "samples", "chosen"]},
            "Intervals": {},
            "Azimuths": {"low": 1, "high": 3600},
            **CHANNELS,
            "NumberOfWorst": ADVANCED,
            "NumberOfBins": ADVANCED,
        },
        [MATERIAL, ("Reference", 1, None, False)],
        outputs=["Errors", "Histogram", "Worst"],
    ),
    Proxy("BRDFTabulate", "vtkBRDFTabulate", {"Cells": {"low": 2, "high": 1024}, "Reciprocal": {}}, [MATERIAL]),
    Proxy("BRDFFromTable", "vtkBRDFFromTable", {"Description": {}}, [("Input", 0, "vtkImageData", False)]),
    Proxy("BRDFFromSamples", "vtkBRDFFromSamples", {"Isotropic": {}, "Description": {}}, [("Input", 0, "vtkTable", False)]),
    Proxy("BRDFCells", "vtkBRDFCells", {}, [MATERIAL]),
    Proxy("BRDFHoleMap", "vtkBRDFHoleMap", {"XAxis": {}, "YAxis": {}}, [MATERIAL]),
    Proxy(
        "BRDFFillHoles",
        "vtkBRDFFillHoles",
        {"Method": {"choices": ["nearest", "none", "reciprocity", "symmetry", "model"]}},
        [MATERIAL, ("Model", 1, None, True)],
    ),
    Proxy(
        "BRDFSpectrum",
        "vtkBRDFSpectrum",
        {},
        [MATERIAL],
        view="XYChartView",
        extra=["spectrum_directions"],
    ),
    Proxy(
        "BRDFFit",
        "vtkBRDFFit",
        {
            "Lobes": LOBES,
            "Metric": {"names": "metrics"},
            "Optimizer": {"names": "optimizers"},
            "Constraints": {},
            "Channels": {"choices": ["native", "luminance", "rgb"]},
            "PerChannel": {},
            "MaximumTheta": {"low": 0.0, "high": 90.0},
            "Sampling": {"choices": ["automatic", "all", "hemisphere", "importance"]},
            "NumberOfSamples": ADVANCED,
            "SolidAngleWeights": ADVANCED,
            "NoiseWeights": ADVANCED,
            "Strategy": {"choices": ["automatic", "separable", "joint"], "advanced": True},
            "Progressive": {},
            "CrossValidation": ADVANCED,
            "Tolerance": {"low": 0.0, "high": 1.0, "advanced": True},
            "Starts": {},
            "Seed": ADVANCED,
        },
        [MATERIAL],
        outputs=["Fit", "Parameters", "Regions"],
        groups=[
            ("Model", ["Lobes", "Constraints", "PerChannel", "Progressive"], None),
            ("Target", ["Channels", "Sampling", "NumberOfSamples", "SolidAngleWeights", "NoiseWeights", "MaximumTheta"], None),
            ("Search", ["Metric", "Optimizer", "Strategy", "Starts", "Seed", "Tolerance", "CrossValidation"], None),
        ],
    ),
    Proxy(
        "BRDFMicrosurfaceFromData",
        "vtkBRDFMicrosurfaceSource",
        {"HeightScale": {}, "Period": {"low": 0.0}},
        [("Input", 0, "vtkImageData vtkPolyData", False)],
        left_out={"Surface": "of surfaces by name, which are a source"},
    ),
    Proxy(
        "BRDFMicrosurfaceGeometry",
        "vtkBRDFMicrosurfaceGeometry",
        {"Tiles": {"low": 1, "high": 100}, "Stride": {}},
        [("Input", 0, "vtkBRDFMicrosurface", False)],
        outputs=["Surface", "Heights"],
    ),
    Proxy(
        "BRDFGonioreflectometer",
        "vtkBRDFGonioreflectometer",
        {
            "ThetaI": {},
            "PhiI": {},
            "Resolution": {"low": 0.05, "high": 45.0},
            "Bins": {"choices": ["auto", "spherical", "specular", "retro"]},
            "Tolerance": {"low": 0.0, "high": 1.0},
            "ToleranceOf": {"choices": ["bins", "albedo"]},
            "MaximumRays": {},
            "Bounces": ADVANCED,
            "Seed": ADVANCED,
            "Backend": {"choices": ["cpu", "gpu"]},
        },
        [("Input", 0, "vtkBRDFMicrosurface", False)],
        outputs=["BRDF", "Balance"],
        left_out={"Progressive": "each update has to be asked for", "RaysPerUpdate": "of progressive updates"},
        extra=["facets"],
    ),
    Proxy(
        "BRDFSurfaceMaterial",
        "vtkBRDFSurfaceMaterial",
        {},
        [("Input", 0, "vtkPolyData", False), ("Material", 1, None, False)],
        text="A surface that carries its material to where it is drawn: in triangles, with normals (splitting edges "
        'sharper than 40 degrees) and tangents where it had none. The representation "BRDF under light" draws it.',
    ),
]
