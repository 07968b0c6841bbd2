#include <brdf/base/Error.h>
#include <brdf/models/Model.h>
#include <brdf/sampling/SamplerEfficiency.h>
#include <brdf/sampling/Sequence.h>
#include <brdf/sampling/TabulatedSampler.h>

#include <algorithm>
#include <limits>

namespace brdf {

DirectionSampler samplerOf(const Brdf& brdf) {
  return {[&brdf](const auto& wo, const auto& u, const auto& wi, std::size_t count) { brdf.sample(wo, u, wi, count); },
          [&brdf](const DirectionPairs<double>& pairs, double* density) { brdf.pdf(pairs, density); }};
}

DirectionSampler samplerOf(const TabulatedSampler& sampler) {
  return {[&](auto&&... all) { sampler.sample(all...); }, [&](auto&&... all) { sampler.pdf(all...); }};
}

DirectionSampler samplerOf(const Model& model, std::span<const double> parameters) {
  return {[&model, parameters](const auto& wo, const auto& u, const auto& wi, std::size_t count) {
            model.sample(wo, u, parameters, wi, count);
          },
          [&model, parameters](const DirectionPairs<double>& pairs, double* density) {
            model.pdf(pairs, parameters, density);
          }};
}

DirectionSampler cosineSampler() {
  return {[](const auto&, const auto& u, const auto& wi, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) {
              const Direction light = cosineDirection(u[0][i], u[1][i]);
              for (std::size_t axis = 0; axis < 3; ++axis) wi[axis][i] = light[axis];
            }
          },
          [](const DirectionPairs<double>& pairs, double* density) {
            for (std::size_t i = 0; i < pairs.count; ++i)
              density[i] = pairs.wo[2][i] > 0 ? std::max(0.0, pairs.wi[2][i]) / kPi : 0.0;
          }};
}

void meanValues(const Brdf& brdf, const DirectionPairs<double>& pairs, double* result, std::vector<double>& scratch) {
  const std::size_t channels = brdf.channels().count();
  scratch.resize(channels * pairs.count);
  brdf.evaluate(pairs, scratch.data(), nullptr);
  for (std::size_t i = 0; i < pairs.count; ++i) {
    double sum = 0;
    for (std::size_t channel = 0; channel < channels; ++channel) sum += scratch[channel * pairs.count + i];
    result[i] = std::isfinite(sum) ? std::max(0.0, sum / static_cast<double>(channels)) : 0.0;
  }
}

SamplerVariances relativeVariances(const Brdf& brdf, const Direction& wo, std::span<const DirectionSampler> samplers,
                                   std::size_t draws) {
  const std::size_t kinds = samplers.size(), count = kinds * draws;
  if (count == 0) throw Error(Error::Kind::Value, {"no draws", "sampler variance", std::to_string(count), "1 or more"});
  DirectionPairBuffer<double> pairs(count);
  std::vector<double> u(draws), v(draws);
  for (std::size_t axis = 0; axis < 3; ++axis) std::fill(pairs.wo[axis].begin(), pairs.wo[axis].end(), wo[axis]);
  for (std::size_t s = 0; s < kinds; ++s) {
    for (std::size_t i = 0; i < draws; ++i) {
      const auto point = r2(i, 0.13 + 0.37 * static_cast<double>(s), 0.71 + 0.23 * static_cast<double>(s));
      u[i] = point[0];
      v[i] = point[1];
    }
    const std::size_t first = s * draws;
    samplers[s].sample({pairs.wo[0].data(), pairs.wo[1].data(), pairs.wo[2].data()}, {u.data(), v.data()},
                       {pairs.wi[0].data() + first, pairs.wi[1].data() + first, pairs.wi[2].data() + first}, draws);
  }
  std::vector<double> values(count), scratch, densities(kinds * count);
  meanValues(brdf, pairs.view(), values.data(), scratch);
  for (std::size_t s = 0; s < kinds; ++s) samplers[s].pdf(pairs.view(), densities.data() + s * count);

  SamplerVariances result;
  std::vector<double> squares(kinds);
  result.largestWeight.assign(kinds, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double reflected = values[i] * pairs.wi[2][i];
    double mixture = 0;  // density of a draw of all samplers together, times `draws`
    for (std::size_t s = 0; s < kinds; ++s) mixture += densities[s * count + i];
    if (!(reflected > 0 && mixture > 0)) continue;
    const double weight = 1 / (mixture * static_cast<double>(draws));
    result.albedo += reflected * weight;
    for (std::size_t s = 0; s < kinds; ++s) {
      const double density = densities[s * count + i];
      const double ratio = density > 0 ? reflected / density : std::numeric_limits<double>::infinity();
      squares[s] += reflected * ratio * weight;
      result.largestWeight[s] = std::max(result.largestWeight[s], ratio);
    }
  }
  for (std::size_t s = 0; s < kinds; ++s) {
    const double albedo = result.albedo;
    result.relativeVariance.push_back(albedo > 0 ? std::max(0.0, squares[s] / (albedo * albedo) - 1) : 0);
    result.largestWeight[s] = albedo > 0 ? result.largestWeight[s] / albedo : 0;
  }
  return result;
}

std::vector<Efficiency> efficiency(const Brdf& brdf, std::span<const double> thetas, const EfficiencyOptions& options) {
  const TabulatedSampler guide(brdf);
  const DirectionSampler samplers[] = {samplerOf(brdf), cosineSampler(), samplerOf(guide)};
  std::vector<Efficiency> result;
  for (const double theta : thetas) {
    const Direction wo = fromSpherical(theta, options.phi);
    const SamplerVariances found = relativeVariances(brdf, wo, samplers, options.draws);
    result.push_back({wo, found.albedo, found.relativeVariance[0], found.largestWeight[0], found.relativeVariance[1]});
  }
  return result;
}

}  // namespace brdf
