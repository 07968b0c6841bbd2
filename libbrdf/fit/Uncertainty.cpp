#include <brdf/base/Text.h>
#include <brdf/fit/BoxQuadratic.h>
#include <brdf/fit/Uncertainty.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace brdf {
namespace {

// Eigenvalues of the correlation-like matrix below this part of the largest: the combination is not determined. The
// matrix is a Gram matrix in double, so that anything below about 1e-12 is rounding.
constexpr double kRankTolerance = 1e-11;
// A component of an undetermined direction that is worth naming.
constexpr double kNamedComponent = 0.05;
constexpr double kStrongCorrelation = 0.99;
// A coordinate this close to a bound, as a part of the box, is on it.
constexpr double kAtBound = 1e-9;

bool atBound(double value, double lower, double upper) {
  const double width = std::isfinite(upper - lower) ? upper - lower : std::max(1.0, std::abs(value));
  return value - lower <= kAtBound * width || upper - value <= kAtBound * width;
}

struct Names {
  const FitProblem& problem;
  const JointCost& cost;

  std::string lobe(std::size_t index) const {
    std::size_t same = 0, before = 0;
    for (std::size_t l = 0; l < problem.lobeCount(); ++l)
      if (problem.model(l).name() == problem.model(index).name()) {
        ++same;
        if (l < index) ++before;
      }
    return problem.model(index).name() + (same > 1 ? "#" + std::to_string(before + 1) : "");
  }
  std::size_t lobeOf(std::size_t k) const {
    const std::size_t shapes = problem.coordinates().size();
    return k < shapes ? problem.coordinates()[k].lobe : cost.freeScales()[k - shapes].first;
  }
  std::string parameter(std::size_t k) const {
    const std::size_t shapes = problem.coordinates().size();
    if (k < shapes)
      return problem.model(lobeOf(k)).parameters()[problem.coordinates()[k].parameters.front().parameter].name;
    return "scale";
  }
  std::string full(std::size_t k) const { return parameter(k) + " of " + lobe(lobeOf(k)); }
};

/// "scale and F0 of AshikhminShirley", or with every lobe where there are several; scales of many channels once.
std::string listed(const Names& names, const std::vector<std::size_t>& members) {
  std::vector<std::string> texts;
  const bool oneLobe =
      std::ranges::all_of(members, [&](std::size_t k) { return names.lobeOf(k) == names.lobeOf(members[0]); });
  for (const std::size_t k : members) {
    std::string text = oneLobe ? names.parameter(k) : names.full(k);
    if (std::ranges::find(texts, text) == texts.end()) texts.push_back(std::move(text));
  }
  std::string result;
  for (std::size_t i = 0; i < texts.size(); ++i)
    result += (i == 0 ? "" : i + 1 == texts.size() ? " and " : ", ") + texts[i];
  return oneLobe ? result + " of " + names.lobe(names.lobeOf(members[0])) : result;
}

void addNote(FitReport& report, std::string note) {
  if (std::ranges::find(report.notes, note) == report.notes.end()) report.notes.push_back(std::move(note));
}

/// Coordinates of x that are determined, with their covariance.
struct Determined {
  std::vector<std::size_t> coordinates;
  std::vector<double> covariance;
};

/// What is determined. Adds the notes.
Determined determine(const Names& names, const NormalEquations& equations, const std::vector<bool>& free,
                     std::size_t residuals, const std::string& suffix, FitReport& report) {
  const std::size_t all = free.size();
  Determined result;
  std::vector<std::size_t> index;
  for (std::size_t k = 0; k < all; ++k)
    if (free[k] && equations.matrix[k * all + k] > 0) index.push_back(k);
  const std::size_t p = index.size();
  if (p == 0) return result;
  std::vector<double> matrix(p * p);
  for (std::size_t i = 0; i < p; ++i)
    for (std::size_t j = 0; j < p; ++j) matrix[i * p + j] = equations.matrix[index[i] * all + index[j]];
  std::vector<std::vector<double>> undetermined;
  const std::vector<double> inverse = pseudoInverse(matrix, p, kRankTolerance, &undetermined);
  std::vector<bool> determined(p, true);
  for (const std::vector<double>& direction : undetermined) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < p; ++i)
      if (std::abs(direction[i]) > kNamedComponent) {
        members.push_back(index[i]);
        determined[i] = false;
      }
    addNote(report, listed(names, members) +
                        (members.size() > 1 ? " are not separately determined" : " is not determined") +
                        " by these data" + suffix);
  }
  if (residuals <= p) {
    addNote(report, "there are not more measured values than parameters: no standard errors" + suffix);
    return result;
  }
  const double variance = equations.squaredError / static_cast<double>(residuals - p);
  std::set<std::pair<std::string, std::string>> named;
  for (std::size_t i = 0; i < p; ++i) {
    if (!determined[i]) continue;
    result.coordinates.push_back(index[i]);
    for (std::size_t j = 0; j < p; ++j)
      if (determined[j]) result.covariance.push_back(variance * inverse[i * p + j]);
    for (std::size_t j = 0; j < i; ++j) {
      const double correlation = inverse[i * p + j] / std::sqrt(inverse[i * p + i] * inverse[j * p + j]);
      if (!determined[j] || !(std::abs(correlation) > kStrongCorrelation)) continue;
      const std::string one = names.full(index[i]), other = names.full(index[j]);
      if (one == other || !named.emplace(one, other).second) continue;  // scales of two channels, or said before
      addNote(report, listed(names, {index[j], index[i]}) + " are strongly correlated (" +
                          formatNumber(correlation, 4) + "): neither is well determined by itself" + suffix);
    }
  }
  return result;
}

/// Adds the covariance of another group of channels, 0 between it and those before.
void append(FitCovariance& covariance, const std::vector<std::size_t>& parameters, const std::vector<double>& block) {
  const std::size_t before = covariance.parameters.size(), added = parameters.size(), n = before + added;
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t i = 0; i < before; ++i)
    for (std::size_t j = 0; j < before; ++j) matrix[i * n + j] = covariance.matrix[i * before + j];
  for (std::size_t i = 0; i < added; ++i)
    for (std::size_t j = 0; j < added; ++j) matrix[(before + i) * n + before + j] = block[i * added + j];
  covariance.parameters.insert(covariance.parameters.end(), parameters.begin(), parameters.end());
  covariance.matrix = std::move(matrix);
}

}  // namespace

void describeParameters(const FitProblem& problem, const FitData& data, ChannelRange channels,
                        std::optional<std::size_t> channel, std::span<const double> shape, const Scales& scales,
                        FitReport& report) {
  const std::size_t lobes = problem.lobeCount(), shapes = shape.size();
  JointCost cost(problem, data, channels);
  const std::vector<double> x = cost.join(shape, scales);
  const NormalEquations equations = cost.normalEquations(x);
  const Names names{problem, cost};
  const std::string suffix = channel && data.channels > 1 ? " (channel " + std::to_string(*channel) + ")" : "";

  std::vector<bool> hasShare(lobes), onBound(x.size()), free(x.size());
  for (std::size_t l = 0; l < lobes; ++l) {
    for (std::size_t c = 0; c < channels.count; ++c) hasShare[l] = hasShare[l] || scales[c * lobes + l] > 0;
    if (!hasShare[l])
      addNote(report, names.lobe(l) + " has no share in the fit: its scale is 0 in every channel" + suffix);
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    onBound[k] = k < shapes ? atBound(x[k], cost.lower()[k], cost.upper()[k]) : x[k] <= 0;
    free[k] = !onBound[k] && hasShare[names.lobeOf(k)];
    if (k < shapes && onBound[k] && hasShare[names.lobeOf(k)])
      addNote(report, names.full(k) + " is on its bound" + suffix);
    // A derivative of 0 everywhere.
    // here).
    if (free[k] && !(equations.matrix[k * x.size() + k] > 0))
      addNote(report, names.full(k) + " has no influence on these data" + suffix);
  }
  Determined determined = determine(names, equations, free, data.samples * channels.count, suffix, report);
  const std::size_t known = determined.coordinates.size();
  std::vector<double> errors(x.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < known; ++i)
    errors[determined.coordinates[i]] = std::sqrt(determined.covariance[i * known + i]);
  std::vector<std::size_t> place(x.size());  // of each coordinate among the report's parameters
  std::vector<double> slopes;
  slopes.assign(x.size(), 1.0);

  std::size_t nextScale = shapes;
  std::vector<std::vector<std::size_t>> scalePlace(lobes, std::vector<std::size_t>(channels.count));
  for (std::size_t c = 0; c < channels.count; ++c)
    for (std::size_t l = 0; l < lobes; ++l)
      if (!problem.fixedScale(l)) scalePlace[l][c] = nextScale++;

  const std::vector<std::vector<double>> values = problem.parameters(shape);
  for (std::size_t l = 0; l < lobes; ++l) {
    const Model& model = problem.model(l);
    for (std::size_t c = 0; c < channels.count; ++c) {
      FittedParameter fitted{"scale",
                             model.name(),
                             l,
                             channels.first + c,
                             scales[c * lobes + l],
                             {},
                             0,
                             std::numeric_limits<double>::infinity(),
                             problem.fixedScale(l).has_value(),
                             false};
      fitted.atBound = !fitted.fixed && fitted.value <= 0;
      if (!fitted.fixed) {
        const std::size_t k = scalePlace[l][c];
        place[k] = report.parameters.size();
        if (std::isfinite(errors[k])) fitted.standardError = errors[k];
      }
      report.parameters.push_back(std::move(fitted));
    }
    for (std::size_t p = 0; p < model.parameters().size(); ++p) {
      const Parameter& parameter = model.parameters()[p];
      FittedParameter fitted{
          parameter.name,    model.name(),          l,    channel, values[l][p], {}, parameter.minimum,
          parameter.maximum, problem.isFixed(l, p), false};
      for (std::size_t k = 0; k < shapes; ++k) {
        const ShapeCoordinate& coordinate = problem.coordinates()[k];
        if (!coordinate.moves({l, p})) continue;
        fitted.atBound = onBound[k];
        if (coordinate.parameters.front() == LobeParameter{l, p}) {
          place[k] = report.parameters.size();
          slopes[k] = coordinate.slope(fitted.value);
        }
        if (std::isfinite(errors[k])) fitted.standardError = errors[k] * coordinate.slope(fitted.value);
      }
      report.parameters.push_back(std::move(fitted));
    }
  }

  std::vector<std::size_t> parameters;
  for (std::size_t i = 0; i < known; ++i) {
    parameters.push_back(place[determined.coordinates[i]]);
    for (std::size_t j = 0; j < known; ++j)
      determined.covariance[i * known + j] *= slopes[determined.coordinates[i]] * slopes[determined.coordinates[j]];
  }
  append(report.covariance, parameters, determined.covariance);
}

std::vector<double> FitCovariance::correlations() const {
  const std::size_t n = parameters.size();
  std::vector<double> result(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double product = matrix[i * n + i] * matrix[j * n + j];
      result[i * n + j] = i == j ? 1 : product > 0 ? matrix[i * n + j] / std::sqrt(product) : 0;
    }
  return result;
}

}  // namespace brdf
