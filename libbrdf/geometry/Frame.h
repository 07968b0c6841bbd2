#pragma once
#include <brdf/geometry/Directions.h>

namespace brdf {

/// A place's frame in the world: tangent, bitangent and normal, orthonormal and right-handed. The local frame of BRDFs
/// has them as its x, y and z axes.
struct Frame {
  Direction tangent{1, 0, 0}, bitangent{0, 1, 0}, normal{0, 0, 1};

  /// A world direction in the frame, and back.
  Direction local(const Direction& d) const { return {dot(d, tangent), dot(d, bitangent), dot(d, normal)}; }
  Direction world(const Direction& d) const {
    Direction w;
    for (std::size_t k = 0; k < 3; ++k) w[k] = d[0] * tangent[k] + d[1] * bitangent[k] + d[2] * normal[k];
    return w;
  }
};

}  // namespace brdf
