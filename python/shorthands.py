"""What takes several lines with VTK's classes alone."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkTable
from vtkmodules.vtkIOImage import vtkPNGWriter

from . import vtkBRDFFilters as _classes


def material(text):
    """The vtkBRDF that `text` means: an expression, a file, "preset:NAME". Raises ValueError with the reason."""
    source = _classes.vtkBRDFSource()
    source.SetMaterial(str(text))
    return _output(source)


def evaluate(brdf, wi, wo):
    """Values (n x channels, 1/sr) and their validity (n booleans) for unit vectors `wi` to the light and `wo` to the
    viewer, n x 3 each, normal +z. Contiguous float64 arrays are used in place, and the result is VTK's own memory."""
    arrays = []
    for name, directions in (("wi", wi), ("wo", wo)):
        directions = np.ascontiguousarray(directions, dtype=np.float64)
        if directions.ndim != 2 or directions.shape[1] != 3:
            raise ValueError(f"{name}: shape {directions.shape}, must be (n, 3)")
        arrays.append(directions)
    if len(arrays[0]) != len(arrays[1]):
        raise ValueError(f"{len(arrays[0])} directions wi, {len(arrays[1])} directions wo: must be as many")
    values, valid = vtkDoubleArray(), vtkUnsignedCharArray()
    if not brdf.Evaluate(numpy_to_vtk(arrays[0]), numpy_to_vtk(arrays[1]), values, valid):
        raise ValueError("no BRDF to evaluate")
    return vtk_to_numpy(values).reshape(len(arrays[0]), brdf.GetNumberOfChannels()), vtk_to_numpy(valid).astype(bool)


def _output(algorithm):
    """A BRDF that outlives its algorithm; ValueError with the reason."""
    if not algorithm.UpdateAndCheck():
        raise ValueError(algorithm.GetErrorText())
    brdf = _classes.vtkBRDF()
    brdf.ShallowCopy(algorithm.GetOutput())
    return brdf


def _fields(data, wavelengths):
    """`data` with the wavelengths (nm) of its channels, where there are any."""
    if wavelengths is not None:
        array = numpy_to_vtk(np.ascontiguousarray(wavelengths, dtype=np.float64), deep=True)
        array.SetName("wavelengths")
        data.GetFieldData().AddArray(array)
    return data


def from_samples(wi, wo, values, uncertainty=None, isotropic=True, wavelengths=None, description="samples"):
    """The vtkBRDF of measurements: directions n x 3 to the light and to the viewer, values n or n x channels (f_r, 1/sr
    without the cosine; nan where there is none), their uncertainty likewise. See vtkBRDFFromSamples."""
    table = vtkTable()
    for name, numbers in (("wi", wi), ("wo", wo), ("value", values), ("uncertainty", uncertainty)):
        if numbers is None:
            continue
        array = numpy_to_vtk(np.ascontiguousarray(numbers, dtype=np.float64), deep=True)
        array.SetName(name)
        if array.GetNumberOfTuples() != len(wi):
            raise ValueError(f"{name}: {array.GetNumberOfTuples()} rows, {len(wi)} directions wi: must be as many")
        table.AddColumn(array)
    maker = _classes.vtkBRDFFromSamples()
    maker.SetInputData(_fields(table, wavelengths))
    maker.SetIsotropic(isotropic)
    maker.SetDescription(description)
    return _output(maker)


def from_function(function, cells=(180, 90, 90), reciprocal=True, wavelengths=None, description="function"):
    """The vtkBRDF of a function, as a table: `function(wi, wo)` takes unit vectors, n x 3 each, and gives n or n x
    channels values (f_r, 1/sr). `cells` along phi_d, theta_d and theta_h; see vtkBRDFFromTable."""
    wi, wo = vtkDoubleArray(), vtkDoubleArray()
    if not _classes.vtkBRDFFromTable.GetDirections(*cells, reciprocal, wi, wo):
        raise ValueError(f"cells {cells}: must be 2 to 1024 each")
    wi, wo = vtk_to_numpy(wi), vtk_to_numpy(wo)
    above = np.flatnonzero((wi[:, 2] > 0) & (wo[:, 2] > 0))
    found = np.asarray(function(wi[above], wo[above]), dtype=np.float64).reshape(len(above), -1)
    values = np.full((len(wi), found.shape[1]), np.nan)
    values[above] = found
    spacing = np.array([180 if reciprocal else 360, 90, 1]) / cells
    image = vtkImageData()
    image.SetDimensions(*cells)
    image.SetSpacing(*spacing)
    image.SetOrigin(*(spacing / 2))
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    maker = _classes.vtkBRDFFromTable()
    maker.SetInputData(_fields(image, wavelengths))
    maker.SetDescription(description)
    return _output(maker)


def names(kind):
    """What there is of a kind: "lobes", "formats", "metrics", "optimizers", "exporters", "presets", "materials",
    "surfaces", "plugins", "failures" (see vtkBRDFRegistry)."""
    array = vtkStringArray()
    if not _classes.vtkBRDFRegistry.GetNames(kind, array):
        raise ValueError(f"no such kind: {kind!r}")
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def pixels(image):
    """A vtkImageData of one slice as an array, height x width x channels, rows from the top, without a copy."""
    width, height, depth = image.GetDimensions()
    if depth != 1:
        raise ValueError(f"{depth} slices, must be 1")
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


def _picture(thing):
    """A vtkImageData of 8-bit pixels."""
    image = vtkImageData()
    if isinstance(thing, _classes.vtkBRDF):
        view = _classes.vtkBRDFLobeView()
        view.SetSize(450, 350)
        view.AddInputData(thing)
        return _picture(view)
    if isinstance(thing, _classes.vtkBRDFView):
        if not thing.Capture(image):
            raise ValueError(thing.GetErrorText())
        return image
    if isinstance(thing, _classes.vtkBRDFRender):
        if not thing.UpdateAndCheck():
            raise ValueError(thing.GetPipelineErrorText())
        tone_map = _classes.vtkBRDFToneMap()
        tone_map.SetInputData(thing.GetOutput())
        tone_map.Update()
        return tone_map.GetOutput()
    raise TypeError(f"no picture of a {type(thing).__name__}: a vtkBRDF, a view or a vtkBRDFRender")


def png(thing):
    """A vtkBRDF (its lobe at 45 degrees), a view, or a vtkBRDFRender (tone-mapped) as the bytes of a PNG file."""
    writer = vtkPNGWriter()
    writer.SetInputData(_picture(thing))
    writer.WriteToMemoryOn()
    writer.Write()
    return vtk_to_numpy(writer.GetResult()).tobytes()
