#include <brdf/check/Tally.h>
#include <brdf/sampling/SamplerChecks.h>
#include <brdf/sampling/TabulatedSampler.h>

#include <algorithm>

namespace brdf {
namespace {

constexpr double kViewAngles[] = {0, 30, 60, 80, 89};  // degrees

template <class T>
DirectionPairs<T> exchangedPairs(const DirectionPairs<T>& pairs) {
  return {pairs.wo, pairs.wi, pairs.count};
}

}  // namespace

bool Audit::passed() const {
  return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed; });
}

void OneLobe::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  model_.evaluate(pairs, parameters_, values);
  if (valid) std::fill_n(valid, pairs.count, std::uint8_t{1});
}

void OneLobe::evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const {
  model_.evaluate(pairs, parameters_, values);
  if (valid) std::fill_n(valid, pairs.count, std::uint8_t{1});
}

void OneLobe::sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                     const std::array<double*, 3>& wi, std::size_t count) const {
  model_.sample(wo, u, parameters_, wi, count);
}

void OneLobe::pdf(const DirectionPairs<double>& pairs, double* density) const {
  model_.pdf(pairs, parameters_, density);
}

void tallyExtremes(const Brdf& brdf, const CheckPairs& set, const std::string& label, Tally& finite, Tally& negative) {
  const std::size_t count = set.size(), values = brdf.channels().count() * count;
  const DirectionPairBuffer<float> narrow = set.narrow();
  const CheckPairs rounded = set.rounded();
  std::vector<double> wide(values), wideThere(values);
  std::vector<float> floats(values);
  brdf.evaluate(set.pairs.view(), wide.data(), nullptr);
  brdf.evaluate(rounded.pairs.view(), wideThere.data(), nullptr);
  brdf.evaluate(narrow.view(), floats.data(), nullptr);
  for (std::size_t k = 0; k < values; ++k) {
    const auto at = [&](const char* precision) {
      return [&, precision] {
        return label + " " + directionText(set.wi(k % count), set.wo(k % count)) + ", " + precision;
      };
    };
    if (!std::isfinite(wide[k])) finite.count(at("double"));
    // Infinity is right beyond the largest float.
    const bool beyond = std::isinf(floats[k]) && wideThere[k] > static_cast<double>(std::numeric_limits<float>::max());
    if (!std::isfinite(floats[k]) && !beyond) finite.count(at("float"));
    if (wide[k] < 0) negative.count(at("double"));
    if (floats[k] < 0) negative.count(at("float"));
  }
}

void tallyReciprocity(const Brdf& brdf, const CheckPairs& set, const std::string& label, double floor, Tally& tally) {
  const std::size_t count = set.size(), values = brdf.channels().count() * count;
  std::vector<double> there(values), back(values);
  std::vector<std::uint8_t> thereValid(count), backValid(count);
  brdf.evaluate(set.pairs.view(), there.data(), thereValid.data());
  brdf.evaluate(exchangedPairs(set.pairs.view()), back.data(), backValid.data());
  double largest = 0;
  for (std::size_t k = 0; k < values; ++k)
    if (std::isfinite(there[k])) largest = std::max(largest, std::fabs(there[k]));
  for (std::size_t k = 0; k < values; ++k) {
    const double size = std::max(std::fabs(there[k]), std::fabs(back[k]));
    if (!thereValid[k % count] || !backValid[k % count] || !std::isfinite(size) ||
        !(size > std::max(floor * largest, 1e-290)))
      continue;
    tally.offer(std::fabs(there[k] - back[k]) / size,
                [&] { return label + " " + directionText(set.wi(k % count), set.wo(k % count)); });
  }
}

SamplerTallies::SamplerTallies(std::size_t cases, const Declaration* declaredEnergy)
    : energy("energy", 1.002, declaredEnergy),
      directions("sampler_directions", 0),
      surprise("sampler", -std::log10(sidakSignificance(1e-4, cases * std::size(kViewAngles)))),
      integral("pdf_integral", 5),
      efficiency("efficiency", kEfficiencyBound) {}

void SamplerTallies::into(std::vector<Check>& checks) const {
  for (const Tally* tally : {&energy, &directions, &surprise, &integral, &efficiency})
    checks.push_back(tally->result());
}

void tallySampler(const Brdf& brdf, const Brdf& reflecting, const std::string& label, const CheckOptions& options,
                  SamplerTallies& tallies) {
  SamplerTestOptions test;
  test.draws = scaled(20'000, options, 2000);
  test.cells = 128;
  test.seed = options.seed;
  const DirectionSampler own = samplerOf(brdf);
  // Peaks that the own sampler misses are found by a coarse tabulated one.
  SamplerOptions coarse;
  coarse.tolerance = 1;
  coarse.maximumBytes = std::size_t{4} << 20;
  const TabulatedSampler guide(brdf, coarse);
  // Densities that underflow where the value nearly does are no hole; a hole counts 1e30 times what it reflects.
  DirectionSampler floored = own;
  floored.pdf = [&](const DirectionPairs<double>& pairs, double* density) {
    own.pdf(pairs, density);
    for (std::size_t k = 0; k < pairs.count; ++k) density[k] = std::max(density[k], 1e-30);
  };
  const DirectionSampler samplers[] = {floored, cosineSampler(), samplerOf(guide)};
  for (const double angle : kViewAngles) {
    const Direction wo = fromSpherical(radians(angle), 0.7);
    const auto viewer = [&] {
      return label + " theta_o " + std::to_string(static_cast<int>(angle)) + " phi_o 40.1 deg";
    };
    const SamplerTest found = testSampler(own, wo, test);
    tallies.directions.count(found.bad + found.uncovered, viewer());
    tallies.surprise.offer(-std::log10(std::max(found.chiSquare.probability, 1e-300)),
                           [&] { return label + " " + directionText(found.worst, wo); });
    tallies.integral.offer(std::fabs(found.deviation), viewer);

    // The integral of f cos over where the light at theta_o goes, by the cells that serve densities.
    const std::size_t channels = reflecting.channels().count();
    std::vector<double> values;
    DirectionSampler reflected = own;
    for (std::size_t channel = 0; channel < channels; ++channel) {
      reflected.pdf = [&](const DirectionPairs<double>& pairs, double* density) {
        values.resize(channels * pairs.count);
        reflecting.evaluate(exchangedPairs(pairs), values.data(), nullptr);
        for (std::size_t k = 0; k < pairs.count; ++k) {
          const double value = values[channel * pairs.count + k] * std::max(0.0, pairs.wi[2][k]);
          density[k] = std::isfinite(value) ? value : 0;  // the matter of another check
        }
      };
      tallies.energy.offer(pdfIntegral(reflected, wo, test), [&] {
        return label + " theta_i " + std::to_string(static_cast<int>(angle)) + " phi_i 40.1 deg";
      });
    }
    const SamplerVariances variances = relativeVariances(brdf, wo, samplers, scaled(4096, options, 1024));
    const double visible = std::min(1.0, variances.albedo / kLeastAlbedo);
    tallies.efficiency.offer(variances.relativeVariance[0] * visible * visible, viewer);
  }
}

}  // namespace brdf
