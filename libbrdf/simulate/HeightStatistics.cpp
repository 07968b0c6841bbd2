#include <brdf/simulate/HeightStatistics.h>

#include <algorithm>
#include <cmath>

namespace brdf {

HeightStatistics statisticsOf(const HeightField& field) {
  HeightStatistics result;
  const auto nodes = static_cast<double>(field.heights.size());
  if (field.heights.empty()) return result;
  double sum = 0;
  for (const float h : field.heights) sum += h;
  result.mean = sum / nodes;
  const auto [low, high] = std::minmax_element(field.heights.begin(), field.heights.end());
  result.lowest = *low;
  result.highest = *high;
  // Every edge along x belongs to one triangle above and one below it; likewise along y.
  double squares = 0, slopesX = 0, slopesY = 0;
  for (std::size_t j = 0; j < field.rows; ++j) {
    const float* row = field.heights.data() + j * field.columns;
    const float* above = field.heights.data() + (j + 1) % field.rows * field.columns;
    for (std::size_t i = 0; i < field.columns; ++i) {
      const double h = row[i], right = row[i + 1 == field.columns ? 0 : i + 1], up = above[i];
      squares += (h - result.mean) * (h - result.mean);
      slopesX += (right - h) * (right - h);
      slopesY += (up - h) * (up - h);
    }
  }
  result.rms = std::sqrt(squares / nodes);
  result.rmsSlopeX = std::sqrt(slopesX / nodes) / field.spacingX;
  result.rmsSlopeY = std::sqrt(slopesY / nodes) / field.spacingY;
  return result;
}

}  // namespace brdf
