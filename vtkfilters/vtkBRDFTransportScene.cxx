#include "vtkBRDFTransportScene.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/material/LobeSum.h>
#include <brdf/simulate/FacetExpression.h>

#include <algorithm>

namespace
{
using brdf::Error, brdf::Facet;

// Texels along an axis: a texture of this size fits every device that has 32-bit floats.
constexpr std::size_t kMostTexels = 16384;

std::vector<int> MediaOf(const std::vector<Facet>& facets)
{
  std::vector<int> media;
  int count = 0;
  for (const Facet& facet : facets)
  {
    media.push_back(facet.kind == Facet::Kind::Dielectric ? count++ : -1);
  }
  return media;
}

std::variant<brdf::FieldTexels, brdf::TileTree> ShapeOf(const brdf::Microsurface& surface,
                                                        const std::vector<int>& media)
{
  const std::string& where = surface.description;
  if (const auto* field = std::get_if<brdf::HeightField>(&surface.shape))
  {
    return brdf::FieldTexels(*field, kMostTexels, where);
  }
  if (const auto* mesh = std::get_if<brdf::TiledMesh>(&surface.shape))
  {
    return brdf::TileTree(*mesh, media, where);
  }
  return brdf::TileTree(std::get<brdf::SpherePacking>(surface.shape), media, where);
}

bool Disperses(const Facet& facet)
{
  return facet.kind == Facet::Kind::Dielectric &&
         std::any_of(facet.eta.begin(), facet.eta.end(), [&](double eta) { return eta != facet.eta[0]; });
}
}

vtkBRDFTransportScene::vtkBRDFTransportScene(const brdf::Microsurface& surface, std::size_t bounces)
  : Shape(ShapeOf(surface, MediaOf(surface.facets)))
  , Facets(surface.facets)
  , MediumOf(MediaOf(surface.facets))
  , Channels(surface.channels.count())
  , Bounces(bounces)
{
  const auto* packing = std::get_if<brdf::SpherePacking>(&surface.shape);
  this->Spheres = packing != nullptr;
  const bool plane = packing && packing->substrate;
  this->PlaneMedium = plane ? this->MediumOf[1] : -2;
  const bool open = std::holds_alternative<brdf::TiledMesh>(surface.shape) || (packing && !plane);
  this->BelowMedium = open ? -2 : this->MediumOf[plane ? 1 : 0];

  brdf::BrdfPointer scattering;
  for (const Facet& facet : surface.facets)
  {
    this->Dispersive = this->Dispersive || Disperses(facet);
    this->Splits = this->Splits || facet.kind == Facet::Kind::Dielectric;
    if (facet.kind != Facet::Kind::Scattering)
    {
      continue;
    }
    const auto lobes = std::dynamic_pointer_cast<const brdf::LobeSum>(facet.brdf);
    const bool drawable = lobes && facet.brdf->channels().kind != brdf::Channels::Kind::Spectral;
    if (!drawable || (scattering && scattering != facet.brdf))
    {
      throw Error(Error::Kind::Value,
                  { scattering && drawable ? "the gpu backend takes one material on facets"
                                           : "the gpu backend cannot scatter by this",
                    surface.description,
                    brdf::facetText(facet),
                    "a sum of lobes, monochrome or RGB; the cpu backend takes any" });
    }
    scattering = facet.brdf;
    this->ScattersRgb = facet.brdf->channels().count() == 3;
    this->Scattering.emplace(*lobes);
  }
}
