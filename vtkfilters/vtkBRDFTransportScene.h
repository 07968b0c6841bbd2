#ifndef vtkBRDFTransportScene_h
#define vtkBRDFTransportScene_h
// What the "gpu" backend traces. For .cxx files only; knows neither VTK nor OpenGL.

#include "vtkBRDFShaderText.h"

#include <brdf/simulate/Microsurface.h>
#include <brdf/simulate/gpu/FieldTexels.h>
#include <brdf/simulate/gpu/TileTree.h>

#include <optional>
#include <variant>
#include <vector>

// A microsurface as the shaders take it; made without a device.
struct vtkBRDFTransportScene
{
  // Throws brdf::Error (kind Value) for what the backend cannot trace.
  vtkBRDFTransportScene(const brdf::Microsurface& surface, std::size_t bounces);

  std::variant<brdf::FieldTexels, brdf::TileTree> Shape;
  bool Spheres = false;
  int PlaneMedium = -2; // -1: opaque, -2: no plane
  int BelowMedium = -1; // in which transmitted light leaves; -2: any
  std::vector<brdf::Facet> Facets;
  std::vector<int> MediumOf; // by facet, -1: none
  std::size_t Channels = 1;
  bool Dispersive = false; // channels refract into different directions
  bool Splits = false;     // there are dielectrics
  std::size_t Bounces = 1000;
  std::optional<vtkBRDFShaderText> Scattering;
  bool ScattersRgb = false;

  double Unit() const
  {
    return std::visit([](const auto& shape) { return shape.unit; }, this->Shape);
  }
};

#endif
