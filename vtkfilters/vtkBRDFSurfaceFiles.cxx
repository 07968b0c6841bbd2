#include "vtkBRDFSurfaceFiles.h"

#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkGLTFReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"

#include <brdf/base/Error.h>
#include <brdf/render/MeshFileChecks.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace
{
[[noreturn]] void Refuse(const std::string& path, const char* what, std::string found = {}, std::string allowed = {})
{
  throw brdf::Error(brdf::Error::Kind::Format, { what, path, std::move(found), std::move(allowed) });
}

template<class Reader>
vtkSmartPointer<vtkPolyData> ReadWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

// All meshes of the default scene, each where its node puts it.
vtkSmartPointer<vtkPolyData> ReadGltf(const std::string& path)
{
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(path.c_str());
  reader->ApplyDeformationsToGeometryOn();
  reader->Update();
  vtkNew<vtkAppendPolyData> together;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  int count = 0;
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(blocks ? blocks->NewIterator() : nullptr);
  for (; iterator && !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* part = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject());
    if (part && part->GetNumberOfPolys() + part->GetNumberOfStrips() > 0)
    {
      together->AddInputData(part);
      ++count;
    }
  }
  if (count == 0)
  {
    Refuse(path, "no surface in the file", "no triangles", "meshes of triangles in the default scene");
  }
  together->Update();
  return together->GetOutput();
}
}

std::string vtkBRDFSurfaceFiles::Endings()
{
  return ".ply, .obj, .stl, .vtp, .gltf, .glb";
}

vtkSmartPointer<vtkPolyData> vtkBRDFSurfaceFiles::Read(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(
    ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool gltf = ending == ".gltf" || ending == ".glb";
  if (!gltf && ending != ".ply" && ending != ".obj" && ending != ".stl" && ending != ".vtp")
  {
    Refuse(path, "unknown kind of object", ending, Endings());
  }
  brdf::checkMeshFile(path); // what VTK's readers do not survive
  vtkSmartPointer<vtkPolyData> surface = gltf               ? ReadGltf(path)
                                         : ending == ".ply" ? ReadWith<vtkPLYReader>(path)
                                         : ending == ".obj" ? ReadWith<vtkOBJReader>(path)
                                         : ending == ".stl" ? ReadWith<vtkSTLReader>(path)
                                                            : ReadWith<vtkXMLPolyDataReader>(path);
  if (!surface || surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    Refuse(path, "no surface in the file", "0 polygons", "a mesh: " + Endings());
  }
  return surface;
}
