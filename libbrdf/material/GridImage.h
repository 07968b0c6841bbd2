#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/GridLayout.h>

#include <array>
#include <string>

namespace brdf {

/// The cells of a grid as the points of an image, in their order: x runs along the first axis, y along the second, z
/// along all others (of a 4-D grid whose outgoing axes come first, a slice of z is one incident direction).
struct GridImage {
  std::array<std::size_t, 3> size{1, 1, 1};  ///< points
  std::array<double, 3> origin{0, 0, 0};     ///< of the first point
  std::array<double, 3> spacing{1, 1, 1};
  /// What is counted along each: "deg" where the nodes are equally spaced in degrees (to a millionth of a step),
  /// "sqrt(theta / 90 deg)" where they are so in that, "index" otherwise.
  std::array<std::string, 3> unit{"index", "index", "index"};
  std::array<std::string, 3> name{};  ///< of the axes, e.g. "theta_o"; "theta_i, phi_i" where z is several; or empty
};
BRDF_EXPORT GridImage imageOf(const GridLayout& layout);

}  // namespace brdf
