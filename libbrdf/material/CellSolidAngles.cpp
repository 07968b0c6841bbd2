#include <brdf/material/CellSolidAngles.h>

#include <cmath>

namespace brdf {
namespace {

double antiderivative(AxisQuantity quantity, double angle) {
  if (isAzimuth(quantity)) return angle;
  if (quantity == AxisQuantity::ThetaD) return 2 * std::sin(angle) * std::sin(angle);
  return -std::cos(angle);
}

std::vector<double> cellMeasures(const GridAxis& axis) {
  const std::size_t n = axis.size();
  if (n == 1) return {1.0};
  std::vector<double> edges = axis.edges, measures(n);
  if (edges.empty()) {
    const double gap = axis.period > 0 ? axis.period - (axis.nodes.back() - axis.nodes.front()) : 0;
    edges.push_back(axis.nodes.front() - gap / 2);
    for (std::size_t k = 0; k + 1 < n; ++k)
      edges.push_back(
          fromScale(axis.scale, (toScale(axis.scale, axis.nodes[k]) + toScale(axis.scale, axis.nodes[k + 1])) / 2));
    edges.push_back(axis.nodes.back() + gap / 2);
  }
  for (std::size_t k = 0; k < n; ++k)
    measures[k] = antiderivative(axis.quantity, edges[k + 1]) - antiderivative(axis.quantity, edges[k]);
  return measures;
}

}  // namespace

CellSolidAngles::CellSolidAngles(const GridLayout& layout) {
  for (const GridAxis& axis : layout.axes) factors_.push_back(cellMeasures(axis));
}

void CellSolidAngles::read(std::size_t first, std::size_t length, double* measures) const {
  const std::vector<double>& fastest = factors_.front();
  const std::size_t row = fastest.size();
  for (std::size_t i = 0; i < length;) {
    std::size_t rest = (first + i) / row;
    double outer = 1;
    for (std::size_t axis = 1; axis < factors_.size(); rest /= factors_[axis].size(), ++axis)
      outer *= factors_[axis][rest % factors_[axis].size()];
    for (std::size_t k = (first + i) % row; k < row && i < length; ++k, ++i) measures[i] = outer * fastest[k];
  }
}

}  // namespace brdf
