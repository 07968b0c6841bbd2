// How long fits take: the full MERL layout by metric, with and without reading the file, and by number of samples,
// lobes and threads. `benchmarks/plot_fit.py` draws the scaling.
#include <brdf/base/Parallel.h>
#include <brdf/fit/Fit.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/SaveMaterial.h>
#include <brdf/material/TableBrdf.h>

#include <benchmark/benchmark.h>

#include <unistd.h>

#include <filesystem>

namespace {

using namespace brdf;

/// A table in MERL's layout (1.458 million cells, RGB) that Lambertian + GGX does not describe exactly.
const TableBrdf& merlLayout() {
  static const auto table = TableBrdf::tabulate(*parseMaterialExpression(
      "(0.3,0.1,0.05)*Lambertian + (0.5,0.4,0.3)*GGX(alpha=0.12, ior=1.5) + 0.02*CookTorrance(m=0.4, ior=1.5)"));
  return *table;
}

/// Lambertian and `specular` lobes GGX.
std::vector<LobeRequest> requests(std::size_t specular) {
  std::vector<LobeRequest> lobes{{findModel("Lambertian"), {}, {}, {}}};
  lobes.resize(1 + specular, {findModel("GGX"), {}, {}, {}});
  return lobes;
}

void fitAndCount(benchmark::State& state, const Brdf& target, const FitOptions& options, std::size_t specular = 1) {
  FitReport report;
  for (auto _ : state) {
    report = fit(target, requests(specular), options);
    benchmark::DoNotOptimize(report.error);
  }
  state.counters["samples"] = static_cast<double>(report.samples);
  state.counters["passes"] = static_cast<double>(report.evaluations);
}

void merlLayoutByMetric(benchmark::State& state) {
  FitOptions options;
  options.metric = metricNames()[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(options.metric);
  fitAndCount(state, merlLayout(), options);
}
BENCHMARK(merlLayoutByMetric)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->UseRealTime();

/// As `brdf fit FILE` does: the file is read each time (from the system's cache).
void merlFile(benchmark::State& state) {
  const auto path = std::filesystem::temp_directory_path() / ("benchmark_fit." + std::to_string(getpid()) + ".binary");
  saveMaterial({BrdfPointer(BrdfPointer(), &merlLayout()), "measured", {}, {}}, path, "merl", "benchmark");
  for (auto _ : state) {
    const LoadedMaterial target = loadMaterial(path.string());
    benchmark::DoNotOptimize(fit(*target.brdf, requests(1), {}).error);
  }
  std::filesystem::remove(path);
}
BENCHMARK(merlFile)->Unit(benchmark::kMillisecond)->UseRealTime();

void merlLayoutByLobes(benchmark::State& state) {
  fitAndCount(state, merlLayout(), {}, static_cast<std::size_t>(state.range(0)) - 1);
}
BENCHMARK(merlLayoutByLobes)->DenseRange(2, 5)->Unit(benchmark::kMillisecond)->UseRealTime();

void merlLayoutByThreads(benchmark::State& state) {
  setThreadCount(static_cast<std::size_t>(state.range(0)));
  fitAndCount(state, merlLayout(), {});
  setThreadCount(0);
}
BENCHMARK(merlLayoutByThreads)->RangeMultiplier(2)->Range(1, 8)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Tables with theta_h, theta_d and phi_d as fine as the argument's part of MERL's.
void tablesBySize(benchmark::State& state) {
  TableLayout layout;
  const auto divisor = static_cast<std::size_t>(state.range(0));
  layout.thetaH /= divisor;
  layout.thetaD /= divisor;
  layout.phiD /= divisor;
  const auto table = TableBrdf::tabulate(merlLayout(), layout);
  fitAndCount(state, *table, {});
}
BENCHMARK(tablesBySize)->RangeMultiplier(3)->Range(1, 9)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
