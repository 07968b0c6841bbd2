#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/FacetExpression.h>
#include <brdf/simulate/Microsurface.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

[[noreturn]] void fail(std::string what, std::string where, std::string found, std::string allowed) {
  throw Error(Error::Kind::Value, {std::move(what), std::move(where), std::move(found), std::move(allowed)});
}

void checkPeriods(double x, double y, const std::string& where) {
  for (const double period : {x, y})
    if (!(period > 0 && std::isfinite(period)))
      fail("period of the tile", where, formatNumber(period), "a positive number of micrometres");
}

bool finite(const std::array<float, 3>& point) {
  return std::ranges::all_of(point, [](float x) { return std::isfinite(x); });
}

void checkShape(const TiledMesh& mesh, const std::string& where) {
  constexpr std::size_t most = std::size_t{1} << 28;
  checkPeriods(mesh.periodX, mesh.periodY, where);
  if (mesh.triangles.size() > most || mesh.points.size() > most)
    fail("too many triangles or points", where, std::to_string(std::max(mesh.triangles.size(), mesh.points.size())),
         "at most 2^28");
  const auto bad = std::ranges::find_if_not(mesh.points, finite);
  if (bad != mesh.points.end())
    fail("point " + std::to_string(bad - mesh.points.begin()), where, "not finite", "finite micrometres");
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    for (const std::uint32_t corner : mesh.triangles[k])
      if (corner >= mesh.points.size())
        fail("corner of triangle " + std::to_string(k), where, std::to_string(corner),
             "below " + std::to_string(mesh.points.size()));
  if (!mesh.facets.empty() && mesh.facets.size() != mesh.triangles.size())
    fail("number of facet indices", where, std::to_string(mesh.facets.size()),
         "none, or " + std::to_string(mesh.triangles.size()));
}

void checkShape(const SpherePacking& packing, const std::string& where) {
  checkPeriods(packing.periodX, packing.periodY, where);
  if (packing.spheres.size() > std::size_t{1} << 26)
    fail("too many spheres", where, std::to_string(packing.spheres.size()), "at most 2^26");
  for (std::size_t k = 0; k < packing.spheres.size(); ++k) {
    const SpherePacking::Sphere& sphere = packing.spheres[k];
    if (!finite(sphere.centre) || !(sphere.radius > 0 && std::isfinite(sphere.radius)))
      fail("sphere " + std::to_string(k), where, "radius " + formatNumber(double(sphere.radius)),
           "a finite centre and a positive radius, micrometres");
  }
}

void checkShape(const HeightField& field, const std::string& where) { field.check(where); }

void checkFacet(const Facet& facet, std::size_t channels, const std::string& where) {
  const auto check = [&](const char* name, const std::vector<double>& numbers, bool needed, double least, double most) {
    if (numbers.empty() ? needed : numbers.size() != 1 && numbers.size() != channels)
      fail(std::string("number of values of ") + name, where, std::to_string(numbers.size()),
           (needed ? "1 or " : "none, 1 or ") + std::to_string(channels));
    for (const double number : numbers)
      if (!(number >= least && number <= most))
        fail(name, where, formatNumber(number), "[" + formatNumber(least) + ", " + formatNumber(most) + "]");
  };
  switch (facet.kind) {
    case Facet::Kind::Mirror:
      break;
    case Facet::Kind::Conductor:
      check("eta", facet.eta, true, 0, 1000);
      check("k", facet.k, true, 0, 1000);
      break;
    case Facet::Kind::Dielectric:
      check("eta", facet.eta, true, 0.01, 1000);
      check("absorption", facet.absorption, false, 0, 1e6);
      break;
    case Facet::Kind::Lambertian:
      check("albedo", facet.albedo, true, 0, 1);
      break;
    case Facet::Kind::Scattering:
      if (!facet.brdf) fail("no BRDF", where, "none", "a material");
      if (const std::size_t count = facet.brdf->channels().count(); count != 1 && count != channels)
        fail("channels of the material", where, std::to_string(count), "1 or " + std::to_string(channels));
  }
}

}  // namespace

std::size_t Microsurface::facetsNeeded() const {
  if (const auto* packing = std::get_if<SpherePacking>(&shape)) return packing->substrate ? 2 : 1;
  if (const auto* mesh = std::get_if<TiledMesh>(&shape); mesh && !mesh->facets.empty())
    return std::size_t{1} + *std::ranges::max_element(mesh->facets);
  return 1;
}

void Microsurface::check(const std::string& where) const {
  std::visit([&](const auto& s) { checkShape(s, where); }, shape);
  if (channels.count() == 0) fail("no channels", where, "0", "1 or more");
  const std::size_t needed = facetsNeeded();
  if (facets.size() < needed || facets.size() > 256)
    fail("number of facets", where, std::to_string(facets.size()), std::to_string(needed) + " to 256");
  std::size_t dielectrics = 0;
  for (std::size_t k = 0; k < facets.size(); ++k) {
    checkFacet(facets[k], channels.count(), where + ", facet " + std::to_string(k) + " (" + facetText(facets[k]) + ")");
    dielectrics += facets[k].kind == Facet::Kind::Dielectric;
  }
  if (dielectrics > kMostDielectrics)
    fail("too many dielectric facets", where, std::to_string(dielectrics), "at most 8");
}

}  // namespace brdf
