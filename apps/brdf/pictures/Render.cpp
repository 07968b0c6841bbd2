#include "Pictures.h"

#include <brdf/geometry/Directions.h>

#include <vtkAlgorithmOutput.h>
#include <vtkBRDF.h>
#include <vtkBRDFEXRWriter.h>
#include <vtkBRDFEnvironment.h>
#include <vtkBRDFRender.h>
#include <vtkBRDFToneMap.h>
#include <vtkImageData.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkPolyDataNormals.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>

namespace brdf::app {
namespace {

template <class Reader>
vtkSmartPointer<vtkPolyData> readWith(const std::string& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPolys() + reader->GetOutput()->GetNumberOfStrips() == 0)
    throw Error(Error::Kind::Format, {"no surface in the file", path, "0 polygons", "a mesh: .ply, .obj, .stl, .vtp"});
  return reader->GetOutput();
}

/// The object to render; null for the sphere.
vtkSmartPointer<vtkPolyData> readObject(const std::string& object) {
  if (object == "sphere") return nullptr;
  const std::string extension = std::filesystem::path(object).extension().string();
  if (extension.empty())
    throw Error(Error::Kind::Value,
                {"unknown object", "--object", "'" + object + "'", "sphere, or a file: .ply, .obj, .stl, .vtp"});
  readFileHead(object, 1);  // says what is wrong with a missing or unreadable file
  if (extension == ".ply") return readWith<vtkPLYReader>(object);
  if (extension == ".obj") return readWith<vtkOBJReader>(object);
  if (extension == ".stl") return readWith<vtkSTLReader>(object);
  if (extension == ".vtp") return readWith<vtkXMLPolyDataReader>(object);
  throw Error(Error::Kind::Value, {"unknown kind of object", object, extension, ".ply, .obj, .stl, .vtp"});
}

/// Brightness: a white Lambertian that faces the light, at the origin, has radiance 1.
void addLight(vtkBRDFRender* render, const Light& light, double rotation) {
  const auto& at = light.numbers;
  if (light.kind == Light::Kind::Directional) {
    render->AddDirectionalLight(at[0], at[1], kPi, kPi, kPi);
  } else if (light.kind == Light::Kind::Point) {
    const double intensity = kPi * (at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
    render->AddPointLight(at[0], at[1], at[2], intensity, intensity, intensity);
  } else {
    vtkNew<vtkBRDFEnvironment> environment;
    environment->SetRotation(rotation);
    if (!environment->ReadFile(light.file)) throw Error(Error::Kind::File, {environment->GetErrorText()});
    render->SetEnvironment(environment);
  }
}

void writePng(vtkImageData* radiance, const RenderPicture& request, const std::string& path) {
  writeVtk<vtkPNGWriter>(toneMapped(radiance, request).Get(), path);
}

void writeExrFile(vtkImageData* radiance, const std::string& path) {
  vtkNew<vtkBRDFEXRWriter> writer;
  writer->SetInputDataObject(radiance);
  writer->SetFileName(path);
  if (!writer->Write()) throw Error(Error::Kind::File, {writer->GetErrorText()});
}

std::vector<Direction> directions(vtkDataArray* array) {
  std::vector<Direction> result(array ? static_cast<std::size_t>(array->GetNumberOfTuples()) : 0);
  for (std::size_t k = 0; k < result.size(); ++k) array->GetTuple(static_cast<vtkIdType>(k), result[k].data());
  return result;
}

double meanOf(vtkImageData* image) {
  const auto* values = static_cast<const float*>(image->GetScalarPointer());
  const std::size_t count = static_cast<std::size_t>(image->GetNumberOfPoints()) *
                            static_cast<std::size_t>(image->GetNumberOfScalarComponents());
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += values[i];
  return sum / static_cast<double>(count);
}

}  // namespace

TriangleMesh readMesh(const std::string& path) {
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(readObject(path));
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  vtkSmartPointer<vtkPolyData> surface = triangles->GetOutput();
  if (!surface->GetPointData()->GetNormals()) {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(surface);
    normals->SetFeatureAngle(40);
    normals->Update();
    surface = normals->GetOutput();
  }
  TriangleMesh mesh;
  mesh.points = directions(surface->GetPoints()->GetData());
  mesh.normals = directions(surface->GetPointData()->GetNormals());
  mesh.tangents = directions(surface->GetPointData()->GetTangents());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell) {
    surface->GetCellPoints(cell, corners);
    auto& triangle = mesh.triangles.emplace_back();
    for (vtkIdType k = 0; k < 3; ++k)
      triangle[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(corners->GetId(k));
  }
  return mesh;
}

vtkSmartPointer<vtkImageData> toVtk(const Image& radiance) {
  auto picture = vtkSmartPointer<vtkImageData>::New();
  const auto width = static_cast<int>(radiance.width), height = static_cast<int>(radiance.height);
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_FLOAT, 3);
  for (int y = 0; y < height; ++y)  // VTK's rows go up
    std::copy_n(radiance.pixel(0, static_cast<std::size_t>(height - 1 - y)), 3 * radiance.width,
                static_cast<float*>(picture->GetScalarPointer(0, y, 0)));
  return picture;
}

void writeRadiancePng(const Image& radiance, const RenderPicture& request, const std::string& path) {
  writePng(toVtk(radiance), request, path);
}

vtkSmartPointer<vtkImageData> toneMapped(vtkImageData* radiance, const RenderPicture& request) {
  vtkNew<vtkBRDFToneMap> tone;
  tone->SetInputDataObject(radiance);
  tone->SetExposure(request.exposure);
  tone->SetCurve(request.toneCurve == "aces"       ? vtkBRDFToneMap::ACES
                 : request.toneCurve == "reinhard" ? vtkBRDFToneMap::REINHARD
                                                   : vtkBRDFToneMap::CLAMP);
  tone->Update();
  return tone->GetOutput();
}

RenderResult drawRender(const RenderPicture& request) {
  vtkNew<vtkBRDFRender> render;
  render->SetInputDataObject(0, pipelineMaterial(request.material, request.assumptions));
  if (const auto object = readObject(request.object)) render->SetInputDataObject(1, object);
  for (const Light& light : request.lights) addLight(render, light, request.rotation);
  render->SetSize(static_cast<int>(request.size.width), static_cast<int>(request.size.height));
  render->SetNumberOfSamples(static_cast<int>(request.samples));
  setColours(render.Get(), request.colours);
  updateOrThrow(render);
  vtkImageData* radiance = render->GetOutput();
  for (const std::string& path : request.out)
    path.ends_with(".png") ? writePng(radiance, request, path) : writeExrFile(radiance, path);
  return {render->GetDeviceDescription(), meanOf(radiance)};
}

}  // namespace brdf::app
