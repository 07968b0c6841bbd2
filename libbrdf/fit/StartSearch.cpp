#include <brdf/base/Parallel.h>
#include <brdf/fit/BoxQuadratic.h>
#include <brdf/fit/Gram.h>
#include <brdf/fit/StartSearch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace brdf {
namespace {

double squaredSum(const std::vector<double>& values) {
  double sum = 0;
  addProducts(values.data(), 1, values.data(), values.size(), &sum);
  return sum;
}

/// Residuals of the sum of scaled columns.
void residualAt(const ResidualBlock& block, const std::vector<const double*>& columns,
                const std::vector<double>& scales, std::vector<double>& model, std::vector<double>& residual) {
  const std::size_t count = model.size();
  std::ranges::fill(model, 0.0);
  for (std::size_t l = 0; l < columns.size(); ++l)
    if (scales[l] != 0)
      for (std::size_t i = 0; i < count; ++i) model[i] += scales[l] * columns[l][i];
  block.residual(model.data(), residual.data());
}

/// The change of the scales that minimises the linearised squared error: residual + weight * columns * change.
std::vector<double> scaleStep(const std::vector<const double*>& columns, const std::vector<bool>& held,
                              const std::vector<double>& scales, const std::vector<double>& weight,
                              const std::vector<double>& residual, std::vector<double>& weighted) {
  const std::size_t n = columns.size(), count = weight.size();
  weighted.resize(n * count);
  for (std::size_t l = 0; l < n; ++l)
    for (std::size_t i = 0; i < count; ++i) weighted[l * count + i] = weight[i] * columns[l][i];
  std::vector<double> matrix(n * n), right(n), lower(n), upper(n);
  addGram(weighted.data(), n, count, matrix.data());
  addProducts(weighted.data(), n, residual.data(), count, right.data());
  for (std::size_t l = 0; l < n; ++l) {
    for (std::size_t k = 0; k < l; ++k) matrix[l * n + k] = matrix[k * n + l];
    right[l] = -right[l];
    lower[l] = held[l] ? 0 : -scales[l];
    upper[l] = held[l] ? 0 : std::numeric_limits<double>::infinity();
  }
  std::vector<double> step = minimizeInBox(matrix, right, lower, upper);
  return step;
}

}  // namespace

double solveScales(const ResidualBlock& block, const std::vector<const double*>& columns, const std::vector<bool>& held,
                   std::vector<double>& scales) {
  const std::size_t count = block.pairs.count;
  const bool quadratic = block.metric->quadratic();
  std::vector<double> model(count), residual(count), weight(count), weighted, value(count);
  std::vector<double> best = scales;
  double bestError = std::numeric_limits<double>::infinity();
  const auto consider = [&](const std::vector<double>& trial) {
    residualAt(block, columns, trial, model, residual);
    const double error = squaredSum(residual);
    if (!(error < bestError)) return false;
    bestError = error;
    best = trial;
    return true;
  };
  const auto moved = [&](const std::vector<double>& step, double fraction) {
    std::vector<double> trial = best;
    for (std::size_t l = 0; l < trial.size(); ++l) trial[l] = std::max(0.0, trial[l] + fraction * step[l]);
    return trial;
  };

  // Linear solutions: weighted by the metric's slope at the data, and (where that differs) not weighted.
  block.values(value.data());
  block.slope(value.data(), weight.data());
  std::vector<std::vector<double>> linear;
  for (int round = 0; round < (quadratic ? 1 : 2); ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      model[i] = -value[i];
      for (std::size_t l = 0; l < columns.size(); ++l) model[i] += scales[l] * columns[l][i];
      residual[i] = weight[i] * model[i];
    }
    linear.push_back(moved(scaleStep(columns, held, scales, weight, residual, weighted), 1));
    std::ranges::fill(weight, 1.0);
  }
  for (const std::vector<double>& trial : linear) consider(trial);

  constexpr int kMaximumSteps = 12;
  for (int k = 0; !quadratic && k < kMaximumSteps; ++k) {
    residualAt(block, columns, best, model, residual);
    block.slope(model.data(), weight.data());
    const std::vector<double> step = scaleStep(columns, held, best, weight, residual, weighted);
    const double before = bestError;
    for (double fraction = 1; fraction > 0.05; fraction /= 2)
      if (consider(moved(step, fraction))) break;
    if (!(bestError < before * (1 - 1e-4))) break;
  }
  scales = best;
  return bestError;
}

Scales solveScales(const FitProblem& problem, const FitData& data, ChannelRange channels, std::span<const double> x) {
  const std::size_t lobes = problem.lobeCount();
  const FitChunk& chunk = data.chunks.front();
  const std::size_t count = chunk.pairs.size();
  std::vector<double> values(lobes * count), scratch;
  problem.evaluate(chunk.pairs.view(), problem.parameters(x), false, scratch, values.data());
  std::vector<const double*> columns;
  std::vector<bool> held;
  for (std::size_t l = 0; l < lobes; ++l) {
    columns.push_back(values.data() + l * count);
    held.push_back(problem.fixedScale(l).has_value());
  }
  Scales scales = initialScales(problem, channels.count);
  parallelFor(channels.count, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) {
      std::vector<double> own(scales.begin() + static_cast<std::ptrdiff_t>(c * lobes),
                              scales.begin() + static_cast<std::ptrdiff_t>((c + 1) * lobes));
      solveScales(data.block(chunk, channels.first + c), columns, held, own);
      std::ranges::copy(own, scales.begin() + static_cast<std::ptrdiff_t>(c * lobes));
    }
  });
  return scales;
}

std::vector<std::size_t> coordinatesOf(const FitProblem& problem, std::size_t lobe) {
  std::vector<std::size_t> own;
  for (std::size_t k = 0; k < problem.coordinates().size(); ++k)
    if (problem.coordinates()[k].lobe == lobe) own.push_back(k);
  return own;
}

std::vector<std::vector<double>> lowDiscrepancyShapes(const FitProblem& problem, std::size_t lobe,
                                                      const std::vector<double>& x) {
  const std::vector<std::size_t> own = coordinatesOf(problem, lobe);
  const std::size_t d = own.size();
  // The R_d sequence: multiples of the powers of 1/phi_d, phi_d^(d+1) = phi_d + 1 (Roberts 2018, "The Unreasonable
  // Effectiveness of Quasirandom Sequences").
  double phi = 2;
  for (int k = 0; k < 60; ++k) phi = std::pow(1 + phi, 1.0 / static_cast<double>(d + 1));
  std::vector<std::vector<double>> shapes(d == 0 ? 0 : d == 1 ? 32 : d == 2 ? 128 : 256, x);
  for (std::size_t k = 0; k < shapes.size(); ++k)
    for (std::size_t j = 0; j < d; ++j) {
      const ShapeCoordinate& coordinate = problem.coordinates()[own[j]];
      const double position = 0.5 + static_cast<double>(k) * std::pow(phi, -static_cast<double>(j + 1));
      shapes[k][own[j]] = std::lerp(coordinate.softLower, coordinate.softUpper, position - std::floor(position));
    }
  return shapes;
}

std::vector<Start> scanShapes(const FitProblem& problem, const FitData& data, std::size_t keep) {
  const std::size_t lobes = problem.lobeCount();
  const FitChunk& chunk = data.chunks.front();
  const DirectionPairs<double> pairs = chunk.pairs.view();
  const std::size_t count = pairs.count;
  std::vector<double> x = problem.start();
  std::vector<std::vector<double>> values(lobes, std::vector<double>(count));
  const auto evaluateLobe = [&](std::size_t lobe, std::span<const double> at, double* out) {
    problem.model(lobe).evaluate(pairs, problem.parameters(at)[lobe], out);
  };
  std::vector<bool> included(lobes);
  const auto errorWith = [&](std::size_t lobe, const double* lobeValues) {
    std::vector<const double*> columns;
    std::vector<bool> held;
    std::vector<double> scales;
    for (std::size_t l = 0; l < lobes; ++l) {
      if (l != lobe && !included[l]) continue;
      columns.push_back(l == lobe ? lobeValues : values[l].data());
      held.push_back(problem.fixedScale(l).has_value());
      scales.push_back(problem.fixedScale(l).value_or(0));
    }
    return solveScales(data.block(chunk, 0), columns, held, scales);
  };
  std::vector<std::size_t> scanned;
  for (std::size_t l = 0; l < lobes; ++l) {
    included[l] = coordinatesOf(problem, l).empty();
    if (!included[l]) scanned.push_back(l);
    evaluateLobe(l, x, values[l].data());
  }

  std::vector<Start> found;
  const int sweeps = scanned.size() > 1 ? 3 : 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    found.clear();
    for (const std::size_t lobe : scanned) {
      const std::vector<std::vector<double>> shapes = lowDiscrepancyShapes(problem, lobe, x);
      std::vector<Start> grid(shapes.size() + 1);  // the last is the shape so far
      parallelFor(grid.size(), 4, [&](std::size_t first, std::size_t last) {
        std::vector<double> lobeValues(count);
        for (std::size_t k = first; k < last; ++k) {
          grid[k].x = k < shapes.size() ? shapes[k] : x;
          evaluateLobe(lobe, grid[k].x, lobeValues.data());
          grid[k].squaredError = errorWith(lobe, lobeValues.data());
        }
      });
      x = std::ranges::min_element(grid, {}, &Start::squaredError)->x;
      included[lobe] = true;
      for (const DerivativeColumn& moved : problem.derivativeColumns())  // other lobes may be tied to this one
        if (moved.lobe == lobe || problem.coordinates()[moved.coordinate].lobe == lobe)
          evaluateLobe(moved.lobe, x, values[moved.lobe].data());
      found.insert(found.end(), grid.begin(), grid.end());
      if (scanned.size() > 1 && sweep == 0 && lobe != scanned.back()) found.clear();  // fewer lobes: not comparable
    }
  }

  std::erase_if(found, [](const Start& start) { return !std::isfinite(start.squaredError); });
  std::ranges::stable_sort(found, {}, &Start::squaredError);
  std::vector<Start> best;
  for (const Start& start : found) {
    if (best.size() == keep) break;
    const bool isNew = std::ranges::none_of(best, [&](const Start& other) {
      for (std::size_t k = 0; k < start.x.size(); ++k) {
        const ShapeCoordinate& coordinate = problem.coordinates()[k];
        const double width = coordinate.softUpper - coordinate.softLower;
        if (std::abs(start.x[k] - other.x[k]) > 0.1 * width) return false;
      }
      return true;
    });
    if (isNew) best.push_back(start);
  }
  return best;
}

std::vector<std::vector<double>> latinHypercube(const FitProblem& problem, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  // The distributions of the standard library differ between implementations; its generators do not.
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<std::vector<double>> shapes(count, problem.start());
  std::vector<std::size_t> order(count);
  for (std::size_t k = 0; k < problem.coordinates().size(); ++k) {
    const ShapeCoordinate& coordinate = problem.coordinates()[k];
    for (std::size_t i = 0; i < count; ++i) {
      order[i] = i;
      std::swap(order[i], order[static_cast<std::size_t>(uniform() * static_cast<double>(i + 1))]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double position = (static_cast<double>(order[i]) + uniform()) / static_cast<double>(count);
      shapes[i][k] = std::lerp(coordinate.softLower, coordinate.softUpper, position);
    }
  }
  return shapes;
}

}  // namespace brdf
