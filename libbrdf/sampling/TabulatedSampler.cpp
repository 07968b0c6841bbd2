#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>
#include <brdf/sampling/PolarTable.h>
#include <brdf/sampling/PolarWarp.h>
#include <brdf/sampling/SamplerEfficiency.h>
#include <brdf/sampling/SamplingChart.h>
#include <brdf/sampling/Sequence.h>
#include <brdf/sampling/TabulatedSampler.h>

#include <algorithm>
#include <chrono>

namespace brdf {
namespace {

using Kind = TabulatedSampler::Kind;

constexpr double kGrazing = radians(89.94);  // the last tabulated viewer; those beyond use its tables
constexpr double kFloorRank = 0.1;           // share of the hemisphere below the constant floor

struct Resolution {
  std::size_t thetas = 5, phis = 4;
  double tolerance = 0.2;
};

std::span<const Chart> chartsOf(Kind kind) {
  static constexpr Chart half[] = {Chart::Half, Chart::Retro}, light[] = {Chart::Light};
  return kind == Kind::Light ? std::span<const Chart>(light) : std::span<const Chart>(half, kind == Kind::Half ? 1 : 2);
}

/// The part of f cos that belongs to a chart of HalfAndRetro: by the squared sines of theta_h and theta_d.
double partOf(Chart chart, const Direction& wi, const Direction& wo) {
  const double x = wi[0] + wo[0], y = wi[1] + wo[1], z = wi[2] + wo[2];
  const double half = (x * x + y * y) / (x * x + y * y + z * z);
  double difference = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) difference += (wi[axis] - wo[axis]) * (wi[axis] - wo[axis]) / 4;
  const double share = half + difference > 0 ? difference / (half + difference) : 0.5;
  return chart == Chart::Half ? share : 1 - share;
}

/// Takes one of several choices of the given shares, and stretches the number for use again.
template <std::size_t N>
std::size_t pick(const std::array<double, N>& shares, std::size_t count, double& u) {
  double below = 0;
  std::size_t k = 0;
  for (; k + 1 < count && u >= below + shares[k]; ++k) below += shares[k];
  while (k > 0 && !(shares[k] > 0)) below -= shares[--k];  // rounding left u above the sum
  u = std::clamp((u - below) / std::max(shares[k], 1e-300), 0.0, 1 - 0x1p-53);
  return k;
}

}  // namespace

/// The tables of all viewers.
class TabulatedSampler::Tables {
 public:
  Tables(const Brdf& brdf, Kind kind, const Resolution& resolution, const SamplerOptions& options)
      : kind_(kind),
        turning_(brdf.symmetry() != Symmetry::Anisotropic),
        thetas_(resolution.thetas),
        phis_(turning_ ? 1 : resolution.phis),
        cosineShare_(options.cosineShare),
        nodes_(thetas_ * phis_) {
    const std::size_t most =
        std::max<std::size_t>(16, options.maximumBytes / (nodes_.size() * chartsOf(kind).size() * sizeof(double)));
    parallelFor(nodes_.size(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        nodes_[k] = makeNode(brdf, viewerOf(k), resolution.tolerance, most, options.cosineShare);
    });
  }

  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const {
    const std::span<const Chart> charts = chartsOf(kind_);
    for (std::size_t i = 0; i < count; ++i) {
      Direction light{0, 0, 0};
      if (wo[2][i] > 0) {
        const ChartViewer viewer({wo[0][i], wo[1][i], wo[2][i]}, turning_);
        const Neighbours near = neighbours(viewer);
        double first = u[0][i];
        const Node& node = nodes_[near.node[pick(near.weight, near.count, first)]];
        const std::size_t component = pick(node.shares, charts.size() + 1, first);
        if (component == 0) {
          light = cosineDirection(first, u[1][i]);
        } else {
          double x, phi;
          node.tables[component - 1].draw(first, u[1][i], x, phi);
          fromChart(charts[component - 1], viewer, x, phi, light);
        }
      }
      for (std::size_t axis = 0; axis < 3; ++axis) wi[axis][i] = light[axis];
    }
  }

  void pdf(const DirectionPairs<double>& pairs, double* density) const {
    const std::span<const Chart> charts = chartsOf(kind_);
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      const Direction wo{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      density[i] = 0;
      if (!(wi[2] > 0 && wo[2] > 0)) continue;
      const ChartViewer viewer(wo, turning_);
      const Neighbours near = neighbours(viewer);
      for (std::size_t k = 0; k < near.count; ++k)
        density[i] += near.weight[k] * nodes_[near.node[k]].shares[0] * wi[2] / kPi;
      for (std::size_t c = 0; c < charts.size(); ++c) {
        const ChartPoint point = toChart(charts[c], viewer, wi);
        if (!(point.jacobian > 0)) continue;
        double sum = 0;
        for (std::size_t k = 0; k < near.count; ++k) {
          const Node& node = nodes_[near.node[k]];
          sum += near.weight[k] * node.shares[c + 1] * node.tables[c].density(point.x, point.phi);
        }
        density[i] += sum / point.jacobian;
      }
    }
  }

  Texels texels() const {
    Texels result{kind_, turning_, static_cast<int>(thetas_), static_cast<int>(phis_), 1, {}};
    std::vector<float>& numbers = result.numbers;
    numbers.resize(12 * nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      for (std::size_t c = 0; c < 3; ++c) numbers[12 * k + c] = static_cast<float>(nodes_[k].shares[c]);
      for (std::size_t c = 0; c < 2; ++c) {
        const PolarTable& table = nodes_[k].tables[c];
        const std::size_t sizes[] = {table.rows(), table.columns(), numbers.size() / 4};
        std::copy(std::begin(sizes), std::end(sizes),
                  numbers.begin() + static_cast<std::ptrdiff_t>(12 * k + 4 * (c + 1)));
        while (2 * static_cast<std::size_t>(result.search) < std::max(sizes[0], sizes[1])) result.search *= 2;
        table.appendTexels(numbers);
      }
    }
    return result;
  }

  Warps warps(double base) const {
    const std::span<const Chart> charts = chartsOf(kind_);
    constexpr std::size_t numbers = 4 * PolarWarp::kRows * PolarWarp::kColumns;
    Warps result;
    result.shares.resize(4 * nodes_.size());
    result.texels.resize(nodes_.size() * charts.size() * numbers);
    parallelFor(nodes_.size(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        const Node& node = nodes_[k];
        const ChartViewer viewer = viewerOf(k);
        const double above = kPi * std::max(0.0, node.floor - base);
        const double tables = node.tables[0].mass() + node.tables[1].mass();
        const double cosine = tables > 0 ? std::max(cosineShare_, above / (above + tables)) : 1;
        double masses[2] = {0, 0};
        for (std::size_t c = 0; c < charts.size(); ++c) {
          const double share = tables > 0 ? (1 - cosine) * node.tables[c].mass() / tables : 0;
          const PolarWarp warp(node.tables[c], share, maximumX(charts[c]), [&](double x, double phi) {
            Direction wi;
            const double jacobian = fromChart(charts[c], viewer, x, phi, wi);
            if (!(jacobian > 0)) return 0.0;
            return cosine * wi[2] / kPi * jacobian * (charts.size() > 1 ? partOf(charts[c], wi, viewer.wo) : 1);
          });
          masses[c] = warp.mass;
          std::copy(warp.texels.begin(), warp.texels.end(),
                    result.texels.begin() + static_cast<std::ptrdiff_t>((k * charts.size() + c) * numbers));
        }
        // Either chart is drawn from: both have directions of their own.
        const double part = masses[0] / (masses[0] + masses[1]);
        result.shares[4 * k] = static_cast<float>(charts.size() > 1 ? std::clamp(part, 0.02, 0.98) : 1.0);
      }
    });
    return result;
  }

  void describe(Report& report) const {
    report.kind = kind_;
    report.viewers = nodes_.size();
    report.cells = report.bytes = 0;
    for (const Node& node : nodes_)
      for (const PolarTable& table : node.tables) {
        report.cells += table.cells();
        report.bytes += table.bytes();
      }
  }

 private:
  struct Node {
    std::array<double, 3> shares{1, 0, 0};  ///< of the cosine and of each table; they sum to 1
    std::array<PolarTable, 2> tables;
    double floor = 0;  ///< drawn by the cosine
  };
  struct Neighbours {
    std::array<std::size_t, 4> node;
    std::array<double, 4> weight;
    std::size_t count;
  };

  /// Polar angles 90 (1 - (1 - t)^2) degrees for even steps of t.
  ChartViewer viewerOf(std::size_t node) const {
    const double t = static_cast<double>(node % thetas_) / static_cast<double>(thetas_ - 1);
    const double theta = std::min(kPi / 2 * (1 - (1 - t) * (1 - t)), kGrazing);
    const double phi = 2 * kPi * static_cast<double>(node / thetas_) / static_cast<double>(phis_);
    return {theta, phi, turning_};
  }

  Neighbours neighbours(const ChartViewer& viewer) const {
    const double share = std::min(1.0, std::atan2(viewer.sinTheta, viewer.wo[2]) / (kPi / 2));
    const double steps = (1 - std::sqrt(1 - share)) * static_cast<double>(thetas_ - 1);
    const std::size_t t = std::min(static_cast<std::size_t>(steps), thetas_ - 2);
    const double upper = steps - static_cast<double>(t);
    Neighbours near{{t, t + 1, 0, 0}, {1 - upper, upper, 0, 0}, 2};
    if (phis_ == 1) return near;
    double turn = std::atan2(viewer.sinPhi, viewer.cosPhi) / (2 * kPi) * static_cast<double>(phis_);
    if (turn < 0) turn += static_cast<double>(phis_);
    const std::size_t p = std::min(static_cast<std::size_t>(turn), phis_ - 1);
    const double after = turn - static_cast<double>(p);
    for (std::size_t k = 0; k < 2; ++k) {
      near.node[k + 2] = near.node[k] + (p + 1) % phis_ * thetas_;
      near.node[k] += p * thetas_;
      near.weight[k + 2] = near.weight[k] * after;
      near.weight[k] *= 1 - after;
    }
    near.count = 4;
    return near;
  }

  Node makeNode(const Brdf& brdf, const ChartViewer& viewer, double tolerance, std::size_t most,
                double cosineShare) const {
    const std::span<const Chart> charts = chartsOf(kind_);
    const double base = floorOf(brdf, viewer.wo);
    Node node;
    node.floor = base;
    std::array<double, 3> mass{kPi * base, 0, 0};
    DirectionPairBuffer<double> pairs;
    std::vector<double> values, jacobians;
    for (std::size_t c = 0; c < charts.size(); ++c) {
      const auto function = [&](const double* x, const double* phi, double* result, std::size_t count) {
        pairs.resize(count);
        jacobians.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
          Direction wi;
          jacobians[i] = fromChart(charts[c], viewer, x[i], phi[i], wi);
          pairs.set(i, wi, viewer.wo);
        }
        meanValues(brdf, pairs.view(), result, values);
        for (std::size_t i = 0; i < count; ++i) {
          const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
          const double part = charts.size() > 1 && wi[2] > 0 ? partOf(charts[c], wi, viewer.wo) : 1;
          result[i] = std::max(0.0, result[i] - base) * wi[2] * jacobians[i] * part;
        }
      };
      node.tables[c] = PolarTable(function, maximumX(charts[c]), tolerance, most);
      mass[c + 1] = node.tables[c].mass();
    }
    const double total = mass[0] + mass[1] + mass[2];
    if (!(mass[1] + mass[2] > 0) || !std::isfinite(total)) return node;
    node.shares[0] = std::max(cosineShare, mass[0] / total);
    for (std::size_t c = 1; c < 3; ++c) node.shares[c] = (1 - node.shares[0]) * mass[c] / (mass[1] + mass[2]);
    return node;
  }

  static double floorOf(const Brdf& brdf, const Direction& wo) {
    constexpr std::size_t count = 256;
    DirectionPairBuffer<double> pairs(count);
    std::vector<double> values(count), scratch;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [u, v] = r2(i, 0.5, 0.5);
      pairs.set(i, cosineDirection(u, v), wo);
    }
    meanValues(brdf, pairs.view(), values.data(), scratch);
    const auto rank = values.begin() + static_cast<std::ptrdiff_t>(kFloorRank * count);
    std::nth_element(values.begin(), rank, values.end());
    return *rank;
  }

  Kind kind_;
  bool turning_;
  std::size_t thetas_, phis_;
  double cosineShare_;
  std::vector<Node> nodes_;
};

TabulatedSampler::TabulatedSampler(const Brdf& brdf, const SamplerOptions& options) {
  choose(brdf, std::array{Kind::Half, Kind::HalfAndRetro, Kind::Light}, options);
}

TabulatedSampler::TabulatedSampler(const Brdf& brdf, Kind kind, const SamplerOptions& options) {
  choose(brdf, std::array{kind}, options);
}

void TabulatedSampler::choose(const Brdf& brdf, std::span<const Kind> kinds, const SamplerOptions& options) {
  const auto check = [](const char* what, double value, bool fine, const char* allowed) {
    if (!fine) throw Error(Error::Kind::Value, {what, "sampler", formatNumber(value), allowed});
  };
  check("tolerance out of bounds", options.tolerance, options.tolerance >= 1e-4 && options.tolerance <= 10,
        "1e-4 to 10");
  check("share of cosine-weighted draws out of bounds", options.cosineShare,
        options.cosineShare > 0 && options.cosineShare <= 1, "more than 0, at most 1");
  const auto start = std::chrono::steady_clock::now();

  // Between the tabulated viewers, where mixing them does worst.
  constexpr double angles[] = {12, 33, 57, 74, 86};
  std::vector<Direction> viewers;
  for (std::size_t k = 0; k < std::size(angles); ++k)
    viewers.push_back(fromSpherical(radians(angles[k]), 0.4 + 1.3 * static_cast<double>(k)));
  const auto measure = [&](std::span<const std::shared_ptr<const Tables>> candidates) {
    std::vector<DirectionSampler> samplers;
    for (const auto& tables : candidates)
      samplers.push_back(
          {[&t = *tables](auto&&... all) { t.sample(all...); }, [&t = *tables](auto&&... all) { t.pdf(all...); }});
    std::vector<std::vector<double>> variances(candidates.size());
    for (const Direction& wo : viewers) {
      const SamplerVariances found = relativeVariances(brdf, wo, samplers, 2048);
      for (std::size_t k = 0; k < candidates.size(); ++k) variances[k].push_back(found.relativeVariance[k]);
    }
    return variances;
  };
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  };

  // Coarse tables of each kind, as far apart as they are; a more costly kind has to be clearly better.
  Resolution resolution;
  resolution.tolerance = std::max(resolution.tolerance, options.tolerance);
  std::vector<std::shared_ptr<const Tables>> candidates;
  for (const Kind kind : kinds) candidates.push_back(std::make_shared<Tables>(brdf, kind, resolution, options));
  const auto coarse = measure(candidates);
  std::size_t best = 0;
  for (std::size_t k = 1; k < kinds.size(); ++k)
    if (mean(coarse[k]) < 0.9 * mean(coarse[best])) best = k;
  tables_ = candidates[best];
  std::vector<double> variances = coarse[best];

  const double wanted = options.tolerance + options.cosineShare / std::max(1e-3, 1 - options.cosineShare);
  resolution = {9, 8, options.tolerance};
  for (int round = 0; round < 3 && mean(variances) > wanted; ++round) {
    const std::shared_ptr<const Tables> pair[] = {std::make_shared<Tables>(brdf, kinds[best], resolution, options),
                                                  tables_};
    const auto found = measure(pair);
    const bool better = mean(found[0]) < mean(found[1]);
    const bool worthwhile = mean(found[0]) < 0.8 * mean(found[1]);
    if (better) tables_ = pair[0];
    variances = found[better ? 0 : 1];
    if (round > 0 && !worthwhile) break;
    resolution = {2 * resolution.thetas - 1, 2 * resolution.phis, resolution.tolerance / 2};
  }
  tables_->describe(report_);
  report_.relativeVariance = mean(variances);
  report_.worstVariance = *std::max_element(variances.begin(), variances.end());
  report_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void TabulatedSampler::sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                              const std::array<double*, 3>& wi, std::size_t count) const {
  tables_->sample(wo, u, wi, count);
}

void TabulatedSampler::pdf(const DirectionPairs<double>& pairs, double* density) const { tables_->pdf(pairs, density); }

TabulatedSampler::Texels TabulatedSampler::texels() const { return tables_->texels(); }

TabulatedSampler::Warps TabulatedSampler::warps(double base) const { return tables_->warps(base); }

const char* name(TabulatedSampler::Kind kind) {
  switch (kind) {
    case Kind::Half:
      return "half vector";
    case Kind::HalfAndRetro:
      return "half vector and retro";
    default:
      return "light";
  }
}

}  // namespace brdf
