#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <optional>
#include <string_view>
#include <vector>

namespace brdf {

/// Which part of a material's scattering a component is.
enum class ComponentKind {
  FrontReflection,    ///< "front reflection": the main BRDF
  BackReflection,     ///< "back reflection"
  FrontTransmission,  ///< "front transmission": light arrives on the front, leaves from the back
  BackTransmission    ///< "back transmission": light arrives on the back, leaves from the front
};
/// The name given above.
BRDF_EXPORT std::string_view componentName(ComponentKind kind);

/// A directional distribution other than the front reflection, as a Brdf in the same conventions (1/sr without the
/// cosine). Both of its directions are above its horizon:
/// - back reflection: the sheet is turned over by a rotation of 180 degrees about the tangent +x, so that (x, y, z)
///   becomes (x, -y, -z), and then described as a front is;
/// - transmission: the viewer is mirrored through the surface, wo = (x, y, -z) of the direction in which light leaves;
///   the straight-through direction of a light wi is then (-wi.x, -wi.y, wi.z), where a reflection has its mirror
///   direction. For back transmission the sheet is turned over first.
struct ScatterComponent {
  ComponentKind kind = ComponentKind::FrontTransmission;
  BrdfPointer brdf;
};

/// Light that leaves in one direction only: the mirror direction, or straight through. Not part of any Brdf.
/// Fraction of the incident power by polar angle of incidence: linear between the angles, constant beyond them.
struct SpecularComponent {
  ComponentKind kind = ComponentKind::FrontReflection;
  Channels channels;
  std::vector<double> thetaI;  ///< radians, ascending
  std::vector<double> values;  ///< planar: channel c at angle k at [c * thetaI.size() + k]; 1

  /// The fraction of one channel at an angle of incidence (radians).
  BRDF_EXPORT double at(std::size_t channel, double theta) const;
  /// Throws Error::Kind::Value for angles that are not ascending within [0, 90] degrees, or a wrong number of values.
  BRDF_EXPORT void check() const;
};

/// Total integrated scatter by incidence, as a file states it: a check of the data, not part of them.
struct TotalScatter {
  ComponentKind kind = ComponentKind::FrontReflection;
  std::vector<double> thetaI;  ///< radians, ascending
  std::vector<double> values;  ///< fraction of the incident power, luminance or first channel
};

/// What a measured material has beside its front reflection. Nothing renders or draws these yet; they are read, kept,
/// listed and stored.
struct Components {
  /// Whether the material has a front reflection. Where it has none, the Brdf that stands for it is its first
  /// component, or one that is valid nowhere.
  bool front = true;
  std::vector<ScatterComponent> scatter;
  std::vector<SpecularComponent> specular;
  std::vector<TotalScatter> totals;

  bool empty() const { return scatter.empty() && specular.empty() && totals.empty(); }
  /// The distribution of this kind, or null.
  BRDF_EXPORT BrdfPointer find(ComponentKind kind) const;
};

}  // namespace brdf
