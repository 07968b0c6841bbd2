#include <brdf/geometry/Directions.h>
#include <brdf/sampling/PolarTable.h>
#include <brdf/sampling/PolarWarp.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr double kUniformShare = 0.01;

/// Lines with even steps between them put in until there are `least` cells.
std::vector<double> refined(const std::vector<double>& lines, std::size_t least) {
  const std::size_t cells = lines.size() - 1, parts = (least + cells - 1) / cells;
  std::vector<double> result;
  for (std::size_t k = 0; k < cells; ++k)
    for (std::size_t i = 0; i < parts; ++i)
      result.push_back(lines[k] + (lines[k + 1] - lines[k]) * static_cast<double>(i) / static_cast<double>(parts));
  result.push_back(lines.back());
  return result;
}

/// Where the sum of `masses`, spread evenly over the cells between `lines`, reaches each of `levels` (ascending, 0 to
/// 1).
std::vector<double> inverse(const std::vector<double>& masses, const std::vector<double>& lines,
                            const std::vector<double>& levels) {
  double total = 0;
  for (const double mass : masses) total += mass;
  std::vector<double> places{lines.front()};
  std::size_t k = 0;
  double below = 0;
  for (std::size_t i = 1; i + 1 < levels.size(); ++i) {
    const double wanted = levels[i] * total;
    while (k + 1 < masses.size() && below + masses[k] < wanted) below += masses[k++];
    places.push_back(lines[k] + std::clamp((wanted - below) / masses[k], 0.0, 1.0) * (lines[k + 1] - lines[k]));
  }
  places.push_back(lines.back());
  return places;
}

}  // namespace

PolarWarp::PolarWarp(const PolarTable& table, double share, double maximumX,
                     const std::function<double(double x, double phi)>& more) {
  const std::vector<double> x =
      refined(table.rows() > 0 ? table.rowEnds() : std::vector<double>{0, maximumX}, 2 * kRows);
  const std::vector<double> phi =
      refined(table.rows() > 0 ? table.columnEnds() : std::vector<double>{0, 2 * kPi}, 2 * kColumns);
  const std::size_t rows = x.size() - 1, columns = phi.size() - 1;
  std::vector<double> masses(rows * columns), rowMasses(rows);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const double middle = 0.5 * (x[r] + x[r + 1]), azimuth = 0.5 * (phi[c] + phi[c + 1]);
      const double density = (table.rows() > 0 ? share * table.density(middle, azimuth) : 0.0) + more(middle, azimuth);
      masses[r * columns + c] = 2 * (x[r + 1] - x[r]) * (phi[c + 1] - phi[c]) * density;
      mass += masses[r * columns + c];
    }
  // Nothing at all: uniform.
  const double uniform = (mass > 0 ? kUniformShare * mass : 1.0) / (4 * kPi * x.back());
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      masses[r * columns + c] += 2 * (x[r + 1] - x[r]) * (phi[c + 1] - phi[c]) * uniform;
      rowMasses[r] += masses[r * columns + c];
    }

  std::vector<double> rowLevels, columnLevels;
  for (std::size_t r = 0; r <= kRows; ++r) {
    const double left = 1 - static_cast<double>(r) / kRows;
    rowLevels.push_back(1 - left * left);
  }
  for (std::size_t c = 0; c <= kColumns; ++c) columnLevels.push_back(static_cast<double>(c) / kColumns);
  const std::vector<double> rowEnds = inverse(rowMasses, x, rowLevels);
  std::vector<double> across(columns);
  for (std::size_t r = 0, first = 0; r < kRows; ++r) {
    std::fill(across.begin(), across.end(), 0.0);
    while (first + 1 < rows && x[first + 1] <= rowEnds[r]) ++first;
    for (std::size_t k = first; k < rows && (k == first || x[k] < rowEnds[r + 1]); ++k) {
      const double part = (std::min(x[k + 1], rowEnds[r + 1]) - std::max(x[k], rowEnds[r])) / (x[k + 1] - x[k]);
      for (std::size_t c = 0; c < columns; ++c) across[c] += std::max(part, 1e-300) * masses[k * columns + c];
    }
    const std::vector<double> ends = inverse(across, phi, columnLevels);
    for (std::size_t c = 0; c < kColumns; ++c)
      for (const double number : {rowEnds[r], rowEnds[r + 1] - rowEnds[r], ends[c], ends[c + 1] - ends[c]})
        texels.push_back(static_cast<float>(number));
  }
}

}  // namespace brdf
