#pragma once
#include <cstddef>
#include <vector>

namespace brdf {

/// A picture of floats, linear unless said otherwise: `channels` interleaved numbers a pixel, rows from the top down.
struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t channels = 0;   ///< 1 grey, 3 R G B, 4 R G B A
  std::vector<float> values;  ///< width * height * channels

  Image() = default;
  Image(std::size_t w, std::size_t h, std::size_t c) : width(w), height(h), channels(c), values(w * h * c) {}

  float* pixel(std::size_t x, std::size_t y) { return values.data() + (y * width + x) * channels; }
  const float* pixel(std::size_t x, std::size_t y) const { return values.data() + (y * width + x) * channels; }
};

}  // namespace brdf
