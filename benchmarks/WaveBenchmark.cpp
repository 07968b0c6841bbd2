// Wave models: values a second on one thread beside plain code for one pair after another (ScalarWaves.cpp) where there
// is any; Mueller matrices a second; and the time to make a model from its text, with its table.
#include <brdf/base/Parallel.h>
#include <brdf/simulate/wave/WaveModels.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "Measuring.h"
#include "ScalarWaves.h"

namespace {

using namespace brdf;

constexpr std::size_t kWavePairs = 200'000;
const std::complex<double> kIndex(0.2, 3);
const std::string kMetal = "(wavelength=0.5, eta=0.2, k=3, ";

struct Case {
  const char* name;
  std::string expression;
  std::function<void(const scalar::WavePairs&, double*)> plain{};
};

const std::vector<Case>& cases() {
  using scalar::WavePairs;
  static const std::vector<Case> all{
      {"RayleighRice_abc", "RayleighRice" + kMetal + "spectrum=abc(a=1e-4, b=5, c=2.5))",
       [](const WavePairs& pairs, double* out) { scalar::rayleighRice(pairs, kIndex, 0.5, 1e-4, 5, 2.5, out); }},
      {"HarveyShack_gaussian", "HarveyShack" + kMetal + "spectrum=gaussian(rms=0.1, correlation=0.5))",
       [](const WavePairs& pairs, double* out) { scalar::harveyShackGaussian(pairs, kIndex, 0.5, 0.1, 0.5, out); }},
      {"HarveyShack_exponential", "HarveyShack" + kMetal + "spectrum=abc(a=0.04, b=5, c=3))",
       [](const WavePairs& pairs, double* out) { scalar::harveyShackExponential(pairs, kIndex, 0.5, 0.04, 5, out); }},
      {"BeckmannKirchhoff_gaussian", "BeckmannKirchhoff" + kMetal + "spectrum=gaussian(rms=0.1, correlation=0.5))",
       [](const WavePairs& pairs, double* out) { scalar::beckmannKirchhoff(pairs, kIndex, 0.5, 0.1, 0.5, out); }},
      {"HarveyShack_power_law", "HarveyShack" + kMetal + "spectrum=fractal(a=1e-3, exponent=2.5, corner=0))"},
      {"Facet", "Facet" + kMetal + "slopes=gaussian(s=0.3), shadowing=smith(w=0.2))"},
      {"DoubleInteraction", "DoubleInteraction" + kMetal + "scatterer=mie(radius=0.1))"},
      {"FirstDiffuse", "FirstDiffuse(wavelength=0.5)"},
      {"Grating", "Grating" + kMetal + "period=5)"}};
  return all;
}

void values(benchmark::State& state, const Case& one) {
  const auto model = makeWaveBrdf(one.expression);
  const DirectionPairs<double> pairs = randomPairs<double>().view().slice(0, kWavePairs);
  const scalar::WavePairs plainPairs{pairs.wi[0], pairs.wi[1], pairs.wi[2], pairs.wo[0],
                                     pairs.wo[1], pairs.wo[2], kWavePairs};
  std::vector<double> ours(kWavePairs), theirs(kWavePairs);
  setThreadCount(1);
  double best = 1e30, plain = 1e30;
  for (auto _ : state) {
    const double seconds = secondsOf([&] { model->evaluate(pairs, ours.data(), nullptr); });
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
    if (one.plain) plain = std::min(plain, secondsOf([&] { one.plain(plainPairs, theirs.data()); }));
  }
  setThreadCount(0);
  state.counters["Mvalues/s"] = kWavePairs / best * 1e-6;
  if (!one.plain) return;
  double worst = 0, largest = 0;
  for (std::size_t k = 0; k < kWavePairs; ++k) {
    worst = std::max(worst, std::abs(ours[k] - theirs[k]));
    largest = std::max(largest, theirs[k]);
  }
  if (!(worst < 1e-4 * largest)) state.SkipWithError("the plain code computes something else");
  state.counters["times plain"] = plain / best;
}

void matrices(benchmark::State& state, const Case& one) {
  const auto model = makeWaveBrdf(one.expression);
  const DirectionPairs<double> pairs = randomPairs<double>().view().slice(0, kWavePairs);
  std::vector<wave::Mueller> matrices(kWavePairs);
  double best = 1e30;
  for (auto _ : state) {
    const double seconds = secondsOf([&] { model->mueller(pairs, 0, matrices.data()); });
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
  }
  state.counters["Mmatrices/s"] = kWavePairs / best * 1e-6;
}

void making(benchmark::State& state, const std::string& expression) {
  setThreadCount(1);
  for (auto _ : state) state.SetIterationTime(secondsOf([&] { makeWaveBrdf(expression); }));
  setThreadCount(0);
}

const int registered = [] {
  const auto add = [](const std::string& name, auto function, const auto& argument) {
    benchmark::RegisterBenchmark(name.c_str(), function, argument)->UseManualTime()->Unit(benchmark::kMillisecond);
  };
  for (const Case& one : cases()) add(std::string("values/") + one.name, values, one);
  for (const Case& one : cases()) add(std::string("mueller/") + one.name, matrices, one);
  for (const auto& [name, spectrum] :
       {std::pair{"abc", "abc(a=0.04, b=5, c=3)"}, std::pair{"fractal", "fractal(a=1e-3, exponent=2.5, corner=0.1)"},
        std::pair{"power_law", "fractal(a=1e-3, exponent=2.5, corner=0)"}})
    add(std::string("making/") + name, making, "HarveyShack" + kMetal + "spectrum=" + spectrum + ")");
  return 0;
}();

}  // namespace
