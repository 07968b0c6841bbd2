#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace brdf {

/// A batch of direction pairs, one array for each component, read but not owned. Local frame: normal +z, tangent +x;
/// `wi` points to the light, `wo` to the viewer, both of unit length. T is float or double.
template <class T>
struct DirectionPairs {
  std::array<const T*, 3> wi{};  ///< x, y, z of the light directions, `count` each
  std::array<const T*, 3> wo{};  ///< x, y, z of the view directions, `count` each
  std::size_t count = 0;

  /// The `length` pairs that start at `first`.
  DirectionPairs slice(std::size_t first, std::size_t length) const {
    DirectionPairs part;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      part.wi[axis] = wi[axis] + first;
      part.wo[axis] = wo[axis] + first;
    }
    part.count = length;
    return part;
  }
};

/// Storage for direction pairs: six arrays of equal length.
template <class T>
struct DirectionPairBuffer {
  std::array<std::vector<T>, 3> wi, wo;

  DirectionPairBuffer() = default;
  explicit DirectionPairBuffer(std::size_t count) { resize(count); }

  std::size_t size() const { return wi[0].size(); }
  void resize(std::size_t count) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      wi[axis].resize(count);
      wo[axis].resize(count);
    }
  }
  void set(std::size_t index, const std::array<T, 3>& light, const std::array<T, 3>& viewer) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      wi[axis][index] = light[axis];
      wo[axis][index] = viewer[axis];
    }
  }
  void push(const std::array<T, 3>& light, const std::array<T, 3>& viewer) {
    resize(size() + 1);
    set(size() - 1, light, viewer);
  }
  DirectionPairs<T> view() const {
    DirectionPairs<T> pairs;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pairs.wi[axis] = wi[axis].data();
      pairs.wo[axis] = wo[axis].data();
    }
    pairs.count = size();
    return pairs;
  }
};

}  // namespace brdf
