#pragma once
// Values at the cells of a grid, and what a look-up makes of them. Internal to libbrdf/material.
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/material/GridLocator.h>

#include <cstdint>
#include <memory>
#include <mutex>

namespace brdf {

/// Reads the cells of a grid or table, which must outlive it: planar values, 0 where the state is Invalid (0).
///
/// Up to three channels are interpolated from a second copy, made when the first look-up in that precision asks for it:
/// a cell's channels and a 1 (0 for an invalid cell) side by side, so that one corner costs one or two cache lines
/// instead of one a channel, and the sum of weights of valid cells comes with the values. It takes 2 numbers a cell for
/// one channel, 4 for two or three.
class GridCells {
 public:
  GridCells(const double* values, const std::uint8_t* states, std::size_t cells, std::size_t channels)
      : values_(values), states_(states), cells_(cells), channels_(channels) {}

  /// As Brdf::evaluate. The locator is one for nodes. T is float or double.
  template <class T>
  void interpolate(const GridLocator& locator, const DirectionPairs<T>& pairs, T* values, std::uint8_t* valid) const;
  /// As Brdf::evaluate. The locator is one for cells.
  template <class T>
  void nearest(const GridLocator& locator, const DirectionPairs<T>& pairs, T* values, std::uint8_t* valid) const;

 private:
  template <class T>
  struct Packed {
    std::once_flag once;
    std::unique_ptr<T, void (*)(void*)> cells{nullptr, nullptr};
  };
  template <class T>
  const T* packed(Packed<T>& store) const;
  const float* packedAs(const float*) const { return packed(floats_); }
  const double* packedAs(const double*) const { return packed(doubles_); }
  template <class T>
  void interpolatePacked(const GridLocator& locator, const DirectionPairs<T>& pairs, T* values,
                         std::uint8_t* valid) const;
  template <class T, int dimensions>
  void interpolatePlanar(const GridLocator& locator, const DirectionPairs<T>& pairs, T* values,
                         std::uint8_t* valid) const;
  std::size_t width() const { return channels_ == 1 ? 2 : 4; }

  const double* values_;
  const std::uint8_t* states_;
  std::size_t cells_, channels_;
  mutable Packed<float> floats_;
  mutable Packed<double> doubles_;
};

}  // namespace brdf
