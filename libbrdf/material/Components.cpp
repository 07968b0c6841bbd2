#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Components.h>

#include <algorithm>
#include <array>

namespace brdf {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"front reflection", "back reflection", "front transmission",
                                                    "back transmission"};

}  // namespace

std::string_view componentName(ComponentKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

double SpecularComponent::at(std::size_t channel, double theta) const {
  const double* row = values.data() + channel * thetaI.size();
  if (!(theta > thetaI.front())) return row[0];
  if (theta >= thetaI.back()) return row[thetaI.size() - 1];
  const auto upper = static_cast<std::size_t>(std::upper_bound(thetaI.begin(), thetaI.end(), theta) - thetaI.begin());
  const double t = (theta - thetaI[upper - 1]) / (thetaI[upper] - thetaI[upper - 1]);
  return (1 - t) * row[upper - 1] + t * row[upper];
}

void SpecularComponent::check() const {
  const std::string where = "specular " + std::string(componentName(kind));
  const bool ascending =
      std::adjacent_find(thetaI.begin(), thetaI.end(), [](double a, double b) { return !(a < b); }) == thetaI.end();
  if (thetaI.empty() || !ascending || !(thetaI.front() >= 0 && thetaI.back() <= kPi / 2 + 1e-6))
    throw Error(Error::Kind::Value, {"wrong angles of incidence", where, std::to_string(thetaI.size()) + " angles",
                                     "ascending, 0 to 90 degrees"});
  if (values.size() != thetaI.size() * channels.count())
    throw Error(Error::Kind::Value, {"wrong number of values", where, std::to_string(values.size()),
                                     std::to_string(thetaI.size() * channels.count())});
}

BrdfPointer Components::find(ComponentKind kind) const {
  for (const ScatterComponent& component : scatter)
    if (component.kind == kind) return component.brdf;
  return nullptr;
}

}  // namespace brdf
