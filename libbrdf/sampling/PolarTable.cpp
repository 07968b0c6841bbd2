#include <brdf/geometry/Directions.h>
#include <brdf/sampling/PolarTable.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kPilotColumns = 64;
constexpr std::size_t kMaximumRows = 256, kMaximumColumns = 192;
constexpr std::size_t kSubCells = 2;  // quadrature points along each side of a cell
constexpr double kSteepest = 3;       // change of log F between pilot cells that counts; an edge has no end
constexpr double kEvenShare = 0.25;   // of the lines, spread evenly, so that no stretch goes without
constexpr double kSmallest = 5e-7;    // sqrt(x) of the innermost pilot line: half an angle of 1e-6, a hundredth of the
                                      // sharpest roughness that lobes allow

/// Lines in sqrt(x) that see peaks of any width at the pole and features of a few degrees elsewhere.
std::vector<double> pilotRows(double maximum) {
  constexpr int logarithmic = 112, even = 48;
  std::vector<double> lines{0};
  for (int k = 0; k <= logarithmic; ++k)
    lines.push_back(kSmallest * std::pow(maximum / kSmallest, static_cast<double>(k) / logarithmic));
  for (int k = 1; k < even; ++k) lines.push_back(maximum * k / even);
  std::sort(lines.begin(), lines.end());
  lines.back() = maximum;
  return lines;
}

/// As many lines as `tolerance` asks for. `spread[i]` is the sum of m g^2 over pilot cell i.
std::vector<double> adaptedLines(const std::vector<double>& pilot, const std::vector<double>& spread, double tolerance,
                                 std::size_t most) {
  std::vector<double> sums{0};
  for (const double value : spread) sums.push_back(sums.back() + std::cbrt(value));
  const double total = sums.back(), even = kEvenShare * std::max(total, 1e-3) / static_cast<double>(spread.size());
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += even * static_cast<double>(k);
  const double ideal = (1 + kEvenShare) * std::sqrt(total * total * total / (12 * tolerance));
  const auto count = static_cast<std::size_t>(std::clamp(std::ceil(ideal), 4.0, static_cast<double>(most)));
  std::vector<double> lines(count + 1);
  for (std::size_t k = 0; k <= count; ++k) {
    const double wanted = sums.back() * static_cast<double>(k) / static_cast<double>(count);
    const auto above = std::upper_bound(sums.begin() + 1, sums.end() - 1, wanted);
    const auto i = static_cast<std::size_t>(above - sums.begin());
    const double part = (wanted - sums[i - 1]) / (sums[i] - sums[i - 1]);
    lines[k] = pilot[i - 1] + part * (pilot[i] - pilot[i - 1]);
  }
  lines.front() = pilot.front();
  lines.back() = pilot.back();
  return lines;
}

/// Index of the cell that holds `value`; `ends` ascends.
std::size_t cellOf(const double* ends, std::size_t cells, double value) {
  const auto above = static_cast<std::size_t>(std::upper_bound(ends + 1, ends + cells, value) - ends);
  return above - 1;
}

}  // namespace

PolarTable::PolarTable(const Function& function, double maximumX, double tolerance, std::size_t maximumCells) {
  // A pilot grid shows where the function changes.
  const std::vector<double> pilot = pilotRows(std::sqrt(maximumX));
  const std::size_t rows = pilot.size() - 1, columns = kPilotColumns, pilotCells = rows * columns;
  std::vector<double> x(pilotCells), phi(pilotCells), values(pilotCells);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const double s = 0.5 * (pilot[r] + pilot[r + 1]);
      x[r * columns + c] = s * s;
      phi[r * columns + c] = (static_cast<double>(c) + 0.5) * 2 * kPi / kPilotColumns;
    }
  function(x.data(), phi.data(), values.data(), pilotCells);
  const double highest = *std::max_element(values.begin(), values.end());
  if (!(highest > 0)) return;
  double total = 0;
  std::vector<double> logs(pilotCells), masses(pilotCells);
  for (std::size_t k = 0; k < pilotCells; ++k) {
    const std::size_t r = k / columns;
    masses[k] = values[k] * (pilot[r + 1] * pilot[r + 1] - pilot[r] * pilot[r]);
    total += masses[k];
    logs[k] = std::log(std::max(values[k], 1e-12 * highest));
  }
  std::vector<double> rowSpread(rows), columnSpread(columns);
  const auto squaredChange = [&](std::size_t before, std::size_t after, double steps) {
    const double change = std::clamp((logs[after] - logs[before]) / steps, -kSteepest, kSteepest);
    return change * change;
  };
  for (std::size_t k = 0; k < pilotCells; ++k) {
    const std::size_t r = k / columns, c = k % columns;
    const std::size_t inner = r > 0 ? k - columns : k, outer = r + 1 < rows ? k + columns : k;
    rowSpread[r] += masses[k] / total * squaredChange(inner, outer, static_cast<double>((outer - inner) / columns));
    columnSpread[c] += masses[k] / total *
                       squaredChange(r * columns + (c + columns - 1) % columns, r * columns + (c + 1) % columns, 2);
  }
  std::vector<double> pilotPhi(columns + 1);
  for (std::size_t c = 0; c <= columns; ++c) pilotPhi[c] = static_cast<double>(c) * 2 * kPi / kPilotColumns;
  rowEnds_ = adaptedLines(pilot, rowSpread, tolerance / 2, std::clamp<std::size_t>(maximumCells / 4, 4, kMaximumRows));
  for (double& end : rowEnds_) end *= end;
  const std::size_t rowCount = rowEnds_.size() - 1;
  columnEnds_ = adaptedLines(pilotPhi, columnSpread, tolerance / 2,
                             std::clamp<std::size_t>(maximumCells / rowCount, 4, kMaximumColumns));
  const std::size_t columnCount = columnEnds_.size() - 1;

  // The integral of the function over each cell, a row at a time.
  constexpr std::size_t points = kSubCells * kSubCells;
  x.resize(columnCount * points);
  phi.resize(columnCount * points);
  values.resize(columnCount * points);
  rowShare_.assign(rowCount + 1, 0);
  cellShare_.assign(rowCount * (columnCount + 1), 0);
  for (std::size_t r = 0; r < rowCount; ++r) {
    const double height = rowEnds_[r + 1] - rowEnds_[r];
    for (std::size_t k = 0; k < x.size(); ++k) {
      const std::size_t c = k / points;
      const double a = (static_cast<double>(k % kSubCells) + 0.5) / kSubCells;
      const double b = (static_cast<double>(k % points / kSubCells) + 0.5) / kSubCells;
      x[k] = rowEnds_[r] + a * height;
      phi[k] = columnEnds_[c] + b * (columnEnds_[c + 1] - columnEnds_[c]);
    }
    function(x.data(), phi.data(), values.data(), x.size());
    double* share = cellShare_.data() + r * (columnCount + 1);
    for (std::size_t c = 0; c < columnCount; ++c) {
      double mean = 0;
      for (std::size_t k = 0; k < points; ++k) mean += values[c * points + k] / points;
      share[c + 1] = share[c] + mean * 2 * height * (columnEnds_[c + 1] - columnEnds_[c]);
    }
    const double rowMass = share[columnCount];
    rowShare_[r + 1] = rowShare_[r] + rowMass;
    for (std::size_t c = 1; c <= columnCount; ++c) share[c] = rowMass > 0 ? share[c] / rowMass : 0;
  }
  mass_ = rowShare_.back();
  if (mass_ > 0 && std::isfinite(mass_))
    for (double& share : rowShare_) share /= mass_;
  else
    *this = {};
}

std::size_t PolarTable::bytes() const {
  return sizeof(double) * (rowEnds_.size() + columnEnds_.size() + rowShare_.size() + cellShare_.size());
}

void PolarTable::appendTexels(std::vector<float>& texels) const {
  if (rows() == 0) return;
  const auto append = [&texels](const double* ends, const double* shares, std::size_t cells) {
    // A cell without width hands its share on to the next one that has some; the last that has some gets the rest.
    std::vector<float> end(cells + 1), share(cells + 1);
    for (std::size_t k = 0; k <= cells; ++k) {
      end[k] = static_cast<float>(ends[k]);
      share[k] = static_cast<float>(shares[k]);
    }
    for (std::size_t k = 1; k < cells; ++k)
      if (!(end[k] > end[k - 1])) share[k] = share[k - 1];
    for (std::size_t k = cells; k > 0 && !(end[k] > end[k - 1]); --k) share[k - 1] = share[k];
    for (std::size_t k = 0; k < cells; ++k) texels.insert(texels.end(), {end[k], share[k], end[k + 1], share[k + 1]});
  };
  append(rowEnds_.data(), rowShare_.data(), rows());
  for (std::size_t row = 0; row < rows(); ++row)
    append(columnEnds_.data(), cellShare_.data() + row * (columns() + 1), columns());
}

void PolarTable::draw(double u, double v, double& x, double& phi) const {
  const auto place = [](const double* shares, const double* ends, std::size_t cells, double number, double& result) {
    const std::size_t k = cellOf(shares, cells, number);
    const double part = std::clamp((number - shares[k]) / (shares[k + 1] - shares[k]), 0.0, 1.0);
    result = ends[k] + part * (ends[k + 1] - ends[k]);
    return k;
  };
  const std::size_t columns = columnEnds_.size() - 1;
  const std::size_t row = place(rowShare_.data(), rowEnds_.data(), rowEnds_.size() - 1, u, x);
  place(cellShare_.data() + row * (columns + 1), columnEnds_.data(), columns, v, phi);
}

double PolarTable::density(double x, double phi) const {
  if (rowEnds_.empty() || !(x <= rowEnds_.back())) return 0;
  const std::size_t columns = columnEnds_.size() - 1;
  const std::size_t row = cellOf(rowEnds_.data(), rowEnds_.size() - 1, x);
  const std::size_t column = cellOf(columnEnds_.data(), columns, phi);
  const double* share = cellShare_.data() + row * (columns + 1) + column;
  return (rowShare_[row + 1] - rowShare_[row]) * (share[1] - share[0]) /
         (2 * (rowEnds_[row + 1] - rowEnds_[row]) * (columnEnds_[column + 1] - columnEnds_[column]));
}

}  // namespace brdf
