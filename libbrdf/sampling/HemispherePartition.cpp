#include <brdf/sampling/HemispherePartition.h>

#include <algorithm>
#include <bit>
#include <numeric>

namespace brdf {
namespace {

constexpr double kInner = 1e-12;  // of x = sin^2(theta/2): angles of 2e-6, below every lobe's width

double widest() { return std::log1p(1 / kInner); }

}  // namespace

bool HemispherePartition::nearViewer(const Direction& wi) const {
  const Direction &mirror = poles_[0].wo, &viewer = poles_[1].wo;
  return wi[0] * (viewer[0] - mirror[0]) + wi[1] * (viewer[1] - mirror[1]) > 0;
}

HemispherePartition::Point HemispherePartition::coordinates(const Direction& wi) const {
  const ChartPoint point = toChart(Chart::Retro, poles_[nearViewer(wi)], wi);
  return {std::log1p(point.x / kInner), point.phi};
}

double HemispherePartition::directionAt(bool retro, const Point& at, Direction& wi) const {
  const double x = std::min(1.0, kInner * std::expm1(at[0]));
  const double inside = fromChart(Chart::Retro, poles_[retro], x, at[1], wi);
  return inside > 0 && nearViewer(wi) == retro ? 2 * (x + kInner) : 0;  // d omega = 2 dx dphi, dx = (x + e) dw
}

Direction HemispherePartition::centre(const Cell& cell) const {
  Direction wi;
  directionAt(cell.retro, {(cell.w0 + cell.w1) / 2, (cell.phi0 + cell.phi1) / 2}, wi);
  return wi;
}

HemispherePartition::HemispherePartition(const Direction& wo, std::span<const Direction> directions, std::size_t cells)
    : poles_{{{-wo[0], -wo[1], wo[2]}, true}, {wo, true}} {
  std::vector<Point> sides[2];
  for (const Direction& direction : directions)
    if (direction[2] > 0) sides[nearViewer(direction)].push_back(coordinates(direction));
  const std::size_t total = std::max<std::size_t>(1, sides[0].size() + sides[1].size());
  for (const bool retro : {false, true}) {
    const std::size_t first = points_.size(), count = sides[retro].size();
    points_.insert(points_.end(), sides[retro].begin(), sides[retro].end());
    const std::size_t share = std::max<std::size_t>(cells * count / total, 16);
    const auto depth = static_cast<std::size_t>(std::bit_width(share) - 1);
    roots_[retro] = divide(first, count, {0, widest(), 0, 2 * kPi, retro}, depth, true);
  }
  cellPoints_.push_back(points_.size());
}

std::size_t HemispherePartition::divide(std::size_t first, std::size_t count, const Cell& cell, std::size_t depth,
                                        bool alongW) {
  Split split;
  split.alongW = alongW;
  const std::size_t axis = alongW ? 0 : 1, middle = count / 2;
  const double low = alongW ? cell.w0 : cell.phi0, high = alongW ? cell.w1 : cell.phi1;
  split.at = (low + high) / 2;
  const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(first);
  if (count >= 2) {
    const auto median = begin + static_cast<std::ptrdiff_t>(middle);
    std::nth_element(begin, median, begin + static_cast<std::ptrdiff_t>(count),
                     [&](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    split.at = (*median)[axis];
  }
  split.leaf = depth == 0 || !(split.at > low && split.at < high);
  if (split.leaf) {
    split.lower = cells_.size();
    cells_.push_back(cell);
    cellPoints_.push_back(first);
  } else {
    Cell below = cell, above = cell;
    (alongW ? below.w1 : below.phi1) = split.at;
    (alongW ? above.w0 : above.phi0) = split.at;
    split.lower = divide(first, middle, below, depth - 1, !alongW);
    split.upper = divide(first + middle, count - middle, above, depth - 1, !alongW);
  }
  splits_.push_back(split);
  return splits_.size() - 1;
}

std::size_t HemispherePartition::cellOf(const Direction& wi) const {
  const Point point = coordinates(wi);
  std::size_t k = roots_[nearViewer(wi)];
  while (!splits_[k].leaf) k = point[splits_[k].alongW ? 0 : 1] < splits_[k].at ? splits_[k].lower : splits_[k].upper;
  return splits_[k].lower;
}

std::vector<double> HemispherePartition::integrate(const Density& density, double tolerance) const {
  constexpr std::size_t side = 8, midpoints = side * side, deepest = 20, chunk = 64,
                        mostDivisions = std::size_t{1} << 18;
  constexpr double above = 1.25;  // how far a known density may exceed those at the midpoints
  struct Known {
    Point at;
    double value;
  };
  struct Piece {
    Cell cell;
    std::size_t owner, depth, first, last;  ///< its known densities
  };
  // The integrand over w and phi: the density times `weights`.
  DirectionPairBuffer<double> pairs(std::max(points_.size(), chunk * midpoints));
  std::vector<double> values(pairs.size()), weights(pairs.size());
  const auto place = [&](std::size_t k, bool retro, const Point& at) {
    Direction wi;
    weights[k] = directionAt(retro, at, wi);
    pairs.set(k, wi, poles_[1].wo);
  };
  const auto evaluate = [&](std::size_t count) {
    density(pairs.view().slice(0, count), values.data());
    for (std::size_t k = 0; k < count; ++k) values[k] = weights[k] > 0 ? weights[k] * values[k] : 0;
  };
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    pieces.push_back({cells_[k], k, 0, cellPoints_[k], cellPoints_[k + 1]});
    for (std::size_t p = cellPoints_[k]; p < cellPoints_[k + 1]; ++p) place(p, cells_[k].retro, points_[p]);
  }
  evaluate(points_.size());
  std::vector<Known> known;
  for (std::size_t k = 0; k < points_.size(); ++k) known.push_back({points_[k], values[k]});

  const double share = tolerance / static_cast<double>(cells_.size());
  double found = 0;
  std::size_t divisions = 0;
  std::vector<double> integrals(cells_.size());
  while (!pieces.empty()) {
    const std::size_t count = std::min(chunk, pieces.size());
    const std::vector<Piece> batch(pieces.end() - static_cast<std::ptrdiff_t>(count), pieces.end());
    pieces.resize(pieces.size() - count);
    for (std::size_t k = 0; k < count * midpoints; ++k) {
      const Cell& cell = batch[k / midpoints].cell;
      const double a = (static_cast<double>(k % side) + 0.5) / side;
      const double b = (static_cast<double>(k % midpoints / side) + 0.5) / side;
      place(k, cell.retro, {cell.w0 + a * (cell.w1 - cell.w0), cell.phi0 + b * (cell.phi1 - cell.phi0)});
    }
    evaluate(count * midpoints);
    for (std::size_t p = 0; p < count; ++p) {
      const Piece& piece = batch[p];
      const Cell& cell = piece.cell;
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(p * midpoints), end = begin + midpoints;
      const auto [lowest, highest] = std::minmax_element(begin, end);
      double knownHighest = 0;
      for (std::size_t k = piece.first; k < piece.last; ++k) knownHighest = std::max(knownHighest, known[k].value);
      const double area = (cell.w1 - cell.w0) * (cell.phi1 - cell.phi0), part = area / midpoints;
      const double allowed = share * std::max(1.0, found);
      const bool hidden = knownHighest > above * *highest && knownHighest * area > allowed;
      if ((!hidden && part * (*highest - *lowest) <= allowed) || piece.depth == deepest || divisions == mostDivisions) {
        const double integral = part * std::accumulate(begin, end, 0.0);
        integrals[piece.owner] += integral;
        found += integral;
        continue;
      }
      ++divisions;
      const double w = (cell.w0 + cell.w1) / 2, phi = (cell.phi0 + cell.phi1) / 2;
      const auto divided = [&](std::size_t first, std::size_t last, const auto& inside) {
        const auto at = [&](std::size_t k) { return known.begin() + static_cast<std::ptrdiff_t>(k); };
        return static_cast<std::size_t>(std::partition(at(first), at(last), inside) - known.begin());
      };
      const auto innerPhi = [&](const Known& k) { return k.at[1] < phi; };
      const std::size_t middle = divided(piece.first, piece.last, [&](const Known& k) { return k.at[0] < w; });
      const std::size_t lower = divided(piece.first, middle, innerPhi), upper = divided(middle, piece.last, innerPhi);
      const auto push = [&](const Cell& quarter, std::size_t first, std::size_t last) {
        pieces.push_back({quarter, piece.owner, piece.depth + 1, first, last});
      };
      push({cell.w0, w, cell.phi0, phi, cell.retro}, piece.first, lower);
      push({cell.w0, w, phi, cell.phi1, cell.retro}, lower, middle);
      push({w, cell.w1, cell.phi0, phi, cell.retro}, middle, upper);
      push({w, cell.w1, phi, cell.phi1, cell.retro}, upper, piece.last);
    }
  }
  return integrals;
}

}  // namespace brdf
