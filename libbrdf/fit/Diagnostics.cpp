#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/fit/Diagnostics.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/RegionErrors.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace brdf {
namespace {

constexpr std::size_t kWorst = 10;

Direction directionAt(const std::array<const double*, 3>& w, std::size_t i) { return {w[0][i], w[1][i], w[2][i]}; }

struct RegionSums {
  std::size_t samples = 0;
  double squared = 0, weight = 0, difference = 0, magnitude = 0, target = 0;

  void add(const RegionSums& other) {
    samples += other.samples;
    squared += other.squared;
    weight += other.weight;
    difference += other.difference;
    magnitude += other.magnitude;
    target += other.target;
  }
};

struct ChunkResiduals {
  std::array<RegionSums, kDirectionRegions.size()> regions;
  std::vector<WorstSample> worst;  ///< share: the squared residual
};

bool worse(const WorstSample& a, const WorstSample& b) { return a.share > b.share; }

ChunkResiduals residualsOf(const FitData& data, const FitChunk& chunk, const Brdf& material) {
  const DirectionPairs<double> pairs = chunk.pairs.view();
  const std::size_t count = pairs.count;
  std::vector<double> fitted(data.channels * count), target(count), residual(count);
  material.evaluate(pairs, fitted.data(), nullptr);
  std::vector<std::size_t> region(count);
  ChunkResiduals result;
  for (std::size_t i = 0; i < count; ++i) {
    region[i] = directionRegion(directionAt(pairs.wi, i), directionAt(pairs.wo, i));
    RegionSums& sums = result.regions[region[i]];
    ++sums.samples;
    double weight = chunk.weight.empty() ? 1 : 0;
    for (std::size_t at = i; at < chunk.weight.size(); at += count) weight += chunk.weight[at] * chunk.weight[at];
    sums.weight += weight / static_cast<double>(data.weightsByChannel ? data.channels : 1);
  }
  for (std::size_t c = 0; c < data.channels; ++c) {
    const double* f = fitted.data() + c * count;
    const ResidualBlock block = data.block(chunk, c);
    block.values(target.data());
    block.residual(f, residual.data());
    double least = result.worst.size() < kWorst ? 0 : result.worst.back().share;
    for (std::size_t i = 0; i < count; ++i) {
      RegionSums& sums = result.regions[region[i]];
      const double squared = residual[i] * residual[i];
      sums.squared += squared;
      sums.difference += f[i] - target[i];
      sums.magnitude += std::abs(f[i] - target[i]);
      sums.target += std::abs(target[i]);
      if (!(squared > least)) continue;
      const WorstSample sample{directionAt(pairs.wi, i), directionAt(pairs.wo, i), c, target[i], f[i], squared};
      result.worst.insert(std::ranges::upper_bound(result.worst, sample, worse), sample);
      if (result.worst.size() > kWorst) result.worst.pop_back();
      if (result.worst.size() == kWorst) least = result.worst.back().share;
    }
  }
  return result;
}

}  // namespace

void describeResiduals(const FitData& data, FitReport& report) {
  std::vector<ChunkResiduals> parts(data.chunks.size());
  parallelFor(parts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) parts[k] = residualsOf(data, data.chunks[k], *report.material);
  });
  std::array<RegionSums, kDirectionRegions.size()> regions;
  double total = 0;
  report.worst.clear();
  for (const ChunkResiduals& part : parts) {
    for (std::size_t region = 0; region < regions.size(); ++region) {
      regions[region].add(part.regions[region]);
      total += part.regions[region].squared;
    }
    report.worst.insert(report.worst.end(), part.worst.begin(), part.worst.end());
  }
  std::ranges::stable_sort(report.worst, worse);
  report.worst.resize(std::min(report.worst.size(), kWorst));
  for (WorstSample& sample : report.worst) sample.share /= total;
  report.regions.clear();
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const RegionSums& sums = regions[k];
    RegionResidual region;
    region.region = kDirectionRegions[k];
    region.samples = sums.samples;
    const double channels = static_cast<double>(data.channels);
    if (sums.weight > 0) region.error = std::sqrt(sums.squared / (sums.weight * channels));
    if (sums.samples > 0) region.meanDifference = sums.difference / (static_cast<double>(sums.samples) * channels);
    if (sums.target > 0) region.relativeMean = sums.magnitude / sums.target;
    if (total > 0) region.share = sums.squared / total;
    report.regions.push_back(std::move(region));
  }
}

std::vector<std::uint8_t> directionParts(const FitData& data, Symmetry symmetry, std::size_t parts) {
  // Half/difference angles, in which a pair and its reciprocal share a block: one must not tell of the other.
  std::vector<std::uint32_t> blocks;
  std::map<std::uint32_t, std::size_t> sizes;
  for (const FitChunk& chunk : data.chunks) {
    const DirectionPairs<double> pairs = chunk.pairs.view();
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const HalfDifference angles = toHalfDifference(directionAt(pairs.wi, i), directionAt(pairs.wo, i));
      const auto step = [](double angle, double from, double width) {
        return static_cast<std::uint32_t>(std::max(0.0, std::floor((angle - from) / width)));
      };
      const double phiD = angles.phiD < 0 ? angles.phiD + kPi : angles.phiD;
      // Finer near the mirror direction, where lobes vary: nine equal steps of the square root.
      std::uint32_t block = step(std::sqrt(angles.thetaH / (kPi / 2)), 0, 1.0 / 9);
      block = block * 16 + step(angles.thetaD, 0, radians(15));
      block = block * 16 + step(phiD, 0, radians(30));
      block = block * 16 + (symmetry == Symmetry::Anisotropic ? step(angles.phiH, -kPi, radians(45)) : 0);
      blocks.push_back(block);
      ++sizes[block];
    }
  }
  if (sizes.size() < parts)
    throw Error(Error::Kind::Value,
                {"the samples lie in fewer blocks of directions than there are parts", "cross-validation",
                 std::to_string(parts), "at most " + std::to_string(sizes.size())});
  std::vector<std::pair<std::size_t, std::uint32_t>> order;
  for (const auto& [block, size] : sizes) order.emplace_back(size, block);
  std::ranges::stable_sort(order, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::size_t> filled(parts);
  std::map<std::uint32_t, std::uint8_t> partOf;
  for (const auto& [size, block] : order) {
    const auto least = std::ranges::min_element(filled) - filled.begin();
    partOf[block] = static_cast<std::uint8_t>(least);
    filled[static_cast<std::size_t>(least)] += size;
  }
  std::vector<std::uint8_t> result;
  for (const std::uint32_t block : blocks) result.push_back(partOf[block]);
  return result;
}

}  // namespace brdf
