#include "vtkBRDFSurface.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <brdf/base/Error.h>
#include <brdf/render/MeshFrames.h>

#include <cmath>

namespace
{
std::vector<brdf::Direction> Tuples(vtkDataArray* array)
{
  std::vector<brdf::Direction> result(array ? static_cast<std::size_t>(array->GetNumberOfTuples()) : 0);
  for (std::size_t k = 0; k < result.size(); ++k)
  {
    array->GetTuple(static_cast<vtkIdType>(k), result[k].data());
  }
  return result;
}

vtkSmartPointer<vtkFloatArray> Array(const std::vector<brdf::Direction>& values, const char* name)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    array->SetTuple(static_cast<vtkIdType>(k), values[k].data());
  }
  return array;
}

void RequireFinite(vtkDataArray* array, const char* what)
{
  for (vtkIdType k = 0; array && k < array->GetNumberOfTuples(); ++k)
  {
    const double* v = array->GetTuple3(k);
    if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
    {
      throw brdf::Error(brdf::Error::Kind::Value,
                        { "the object to render has a number that is not finite",
                          std::string(what) + " " + std::to_string(k),
                          {},
                          {} });
    }
  }
}
}

void vtkBRDFSurface::RequireCorners(vtkPolyData* surface)
{
  for (vtkCellArray* cells : { surface->GetPolys(), surface->GetStrips() })
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    for (cells->InitTraversal(); cells->GetNextCell(count, corners);)
    {
      for (vtkIdType k = 0; k < count; ++k)
      {
        if (corners[k] < 0 || corners[k] >= surface->GetNumberOfPoints())
        {
          throw brdf::Error(brdf::Error::Kind::Value,
                            { "a polygon has a corner that is no point",
                              {},
                              std::to_string(corners[k]),
                              "0 to " + std::to_string(surface->GetNumberOfPoints() - 1) });
        }
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> vtkBRDFSurface::UnitSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1);
  source->SetThetaResolution(256);
  source->SetPhiResolution(129);
  source->Update();
  vtkSmartPointer<vtkPolyData> sphere = source->GetOutput();
  vtkNew<vtkFloatArray> tangents;
  tangents->SetName("Tangents");
  tangents->SetNumberOfComponents(3);
  tangents->SetNumberOfTuples(sphere->GetNumberOfPoints());
  for (vtkIdType point = 0; point < sphere->GetNumberOfPoints(); ++point)
  {
    double n[3];
    sphere->GetPoint(point, n);
    const double length = std::hypot(n[0], n[2]);
    const double tangent[3] = { length > 0 ? n[2] / length : 1, 0, length > 0 ? -n[0] / length : 0 };
    tangents->SetTuple(point, tangent);
  }
  sphere->GetPointData()->SetTangents(tangents);
  return sphere;
}

vtkSmartPointer<vtkPolyData> vtkBRDFSurface::Complete(vtkPolyData* surface)
{
  if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "the object to render is empty", {}, "no polygons", {} });
  }
  RequireFinite(surface->GetPoints()->GetData(), "point");
  RequireFinite(surface->GetPointData()->GetNormals(), "normal");
  RequireFinite(surface->GetPointData()->GetTangents(), "tangent");
  RequireCorners(surface);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  vtkSmartPointer<vtkPolyData> complete = triangles->GetOutput();
  if (!complete->GetPointData()->GetNormals())
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(complete);
    normals->SetFeatureAngle(40);
    normals->Update();
    complete = normals->GetOutput();
  }
  brdf::TriangleMesh mesh = ToMesh(complete);
  brdf::removeDegenerateTriangles(mesh);
  if (mesh.triangles.empty())
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "the object to render is empty", {}, "no polygons with an area", {} });
  }
  brdf::settleNormals(mesh);
  brdf::addTangents(mesh);
  return FromMesh(mesh);
}

brdf::TriangleMesh vtkBRDFSurface::ToMesh(vtkPolyData* surface)
{
  brdf::TriangleMesh mesh;
  mesh.points = Tuples(surface->GetPoints()->GetData());
  mesh.normals = Tuples(surface->GetPointData()->GetNormals());
  mesh.tangents = Tuples(surface->GetPointData()->GetTangents());
  if (vtkDataArray* coordinates = surface->GetPointData()->GetTCoords();
      coordinates && coordinates->GetNumberOfComponents() >= 2)
  {
    for (vtkIdType k = 0; k < coordinates->GetNumberOfTuples(); ++k)
    {
      mesh.textureCoordinates.push_back({ coordinates->GetComponent(k, 0), coordinates->GetComponent(k, 1) });
    }
  }
  vtkCellArray* cells = surface->GetPolys();
  mesh.triangles.reserve(static_cast<std::size_t>(cells->GetNumberOfCells()));
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(count, corners);)
  {
    auto& triangle = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangle[k] = static_cast<std::uint32_t>(corners[k]);
    }
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> vtkBRDFSurface::FromMesh(const brdf::TriangleMesh& mesh)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(Array(mesh.points, "Points"));
  surface->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : mesh.triangles)
  {
    const vtkIdType corners[3] = { triangle[0], triangle[1], triangle[2] };
    cells->InsertNextCell(3, corners);
  }
  surface->SetPolys(cells);
  if (!mesh.normals.empty())
  {
    surface->GetPointData()->SetNormals(Array(mesh.normals, "Normals"));
  }
  if (!mesh.tangents.empty())
  {
    surface->GetPointData()->SetTangents(Array(mesh.tangents, "Tangents"));
  }
  if (!mesh.textureCoordinates.empty())
  {
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetName("TextureCoordinates");
    coordinates->SetNumberOfComponents(2);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh.textureCoordinates.size()));
    for (std::size_t k = 0; k < mesh.textureCoordinates.size(); ++k)
    {
      coordinates->SetTuple(static_cast<vtkIdType>(k), mesh.textureCoordinates[k].data());
    }
    surface->GetPointData()->SetTCoords(coordinates);
  }
  return surface;
}
