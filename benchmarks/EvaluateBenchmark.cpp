// One thread, 1e6 random pairs, RGB: the block evaluator beside scalar std:: code of the same formulas. Each benchmark
// runs both in turn and reports the ratio of the shortest times, so that a loaded or slow machine does not matter.
#include <brdf/material/LobeSum.h>

#include <benchmark/benchmark.h>

#include <algorithm>

#include "Measuring.h"
#include "ScalarModels.h"

namespace {

using namespace brdf;

/// Times the expression's evaluation, beside `plain(pairs, out)`.
template <class T, class Plain>
void besideScalar(benchmark::State& state, const char* expression, Plain plain) {
  const auto material = parseMaterialExpression(expression);
  const DirectionPairs<T> pairs = randomPairs<T>().view();
  const scalar::Pairs<T> scalarPairs{pairs.wi[0], pairs.wi[1], pairs.wi[2], pairs.wo[0],
                                     pairs.wo[1], pairs.wo[2], pairs.count};
  std::vector<T> ours(3 * kPairs), theirs(3 * kPairs);
  material->evaluate(pairs, ours.data(), nullptr);
  double plainSeconds = 1e30, ourSeconds = 1e30;
  for (auto _ : state) {
    const double seconds = secondsOf([&] { material->evaluate(pairs, ours.data(), nullptr); });
    state.SetIterationTime(seconds);
    ourSeconds = std::min(ourSeconds, seconds);
    plainSeconds = std::min(plainSeconds, secondsOf([&] { plain(scalarPairs, theirs.data()); }));
  }
  double worst = 0;
  for (std::size_t i = 0; i < 3 * kPairs; ++i)
    worst = std::max(worst, static_cast<double>(std::abs(ours[i] - theirs[i]) / (std::abs(theirs[i]) + T(1e-3))));
  state.counters["Mpairs/s"] = kPairs / ourSeconds * 1e-6;
  state.counters["ratio"] = plainSeconds / ourSeconds;
  state.counters["difference"] = worst;  // of the two programs: rounding of the plain one
}

template <class T>
constexpr T kScale[3] = {T(0.5), T(0.4), T(0.3)};

template <class T>
void evaluateGgx(benchmark::State& state) {
  besideScalar<T>(state, "(0.5,0.4,0.3)*GGX(alpha=0.2, ior=1.5)",
                  [](const scalar::Pairs<T>& pairs, T* out) { scalar::ggx<T>(pairs, T(0.2), T(1.5), kScale<T>, out); });
}
template <class T>
void evaluateWard(benchmark::State& state) {
  besideScalar<T>(state, "(0.5,0.4,0.3)*Ward(ax=0.2, ay=0.3)", [](const scalar::Pairs<T>& pairs, T* out) {
    scalar::ward<T>(pairs, T(0.2), T(0.3), kScale<T>, out);
  });
}
template <class T>
void evaluateCookTorrance(benchmark::State& state) {
  besideScalar<T>(state, "(0.5,0.4,0.3)*CookTorrance(m=0.2, ior=1.5)", [](const scalar::Pairs<T>& pairs, T* out) {
    scalar::cookTorrance<T>(pairs, T(0.2), T(1.5), kScale<T>, out);
  });
}
template <class T>
void evaluateAshikhminShirley(benchmark::State& state) {
  besideScalar<T>(state, "(0.5,0.4,0.3)*AshikhminShirley(nu=50, nv=80, F0=0.04)",
                  [](const scalar::Pairs<T>& pairs, T* out) {
                    scalar::ashikhminShirley<T>(pairs, T(50), T(80), T(0.04), kScale<T>, out);
                  });
}
template <class T>
void evaluateSgd(benchmark::State& state) {
  besideScalar<T>(state,
                  "(0.5,0.4,0.3)*SGD(alpha=(0.128,0.127,0.11), p=(0.78,0.79,0.66), F0=0.05, F1=-0.1, K=(5.9,5.8,7.1), "
                  "Lambda=2.7, c=1e-7, k=24, theta0=-0.3)",
                  [](const scalar::Pairs<T>& pairs, T* out) {
                    static constexpr T parameters[27] = {
                        T(0.128), T(0.78), T(0.05), T(-0.1), T(5.9), T(2.7), T(1e-7), T(24), T(-0.3),
                        T(0.127), T(0.79), T(0.05), T(-0.1), T(5.8), T(2.7), T(1e-7), T(24), T(-0.3),
                        T(0.11),  T(0.66), T(0.05), T(-0.1), T(7.1), T(2.7), T(1e-7), T(24), T(-0.3)};
                    scalar::sgd<T>(pairs, parameters, kScale<T>, out);
                  });
}

/// From the text of a sum to its first value: reading it, its sampling weights, its program, machine code.
void firstValue(benchmark::State& state, const char* expression) {
  const std::array<double, 6> x{0.36, 0.48, 0.8, -0.6, 0, 0.8};
  const DirectionPairs<double> pair{{&x[0], &x[1], &x[2]}, {&x[3], &x[4], &x[5]}, 1};
  std::array<double, 3> value;
  double evaluations = 0;
  for (auto _ : state) {
    std::shared_ptr<const Brdf> material;
    const double make = secondsOf([&] { material = parseMaterialExpression(expression); });
    const double evaluate = secondsOf([&] { material->evaluate(pair, value.data(), nullptr); });
    state.SetIterationTime(make + evaluate);
    evaluations += evaluate;
  }
  state.counters["evaluate_us"] = benchmark::Counter(evaluations * 1e6, benchmark::Counter::kAvgIterations);
}

#define REGISTER(name)                                                                    \
  BENCHMARK(name<float>)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(15); \
  BENCHMARK(name<double>)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(15)
REGISTER(evaluateGgx);
REGISTER(evaluateWard);
REGISTER(evaluateCookTorrance);
REGISTER(evaluateAshikhminShirley);
REGISTER(evaluateSgd);

#define REGISTER_FIRST(name, expression) \
  BENCHMARK_CAPTURE(firstValue, name, expression)->Unit(benchmark::kMicrosecond)->UseManualTime()->Iterations(50)
REGISTER_FIRST(lambertian_ggx, "(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)");
REGISTER_FIRST(
    three_lobes,
    "(0.3,0.1,0.05)*Lambertian + (0.5,0.4,0.3)*GGX(alpha=0.12, ior=1.5) + 0.02*CookTorrance(m=0.4, ior=1.5)");
REGISTER_FIRST(sgd_of_each_channel, "SGD(alpha=(0.128,0.127,0.11), K=(5.9,5.8,7.1))");
REGISTER_FIRST(openpbr, "OpenPBR");

}  // namespace
