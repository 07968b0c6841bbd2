// One thread, 1e6 random pairs, RGB: look-ups in a table of MERL's size beside straightforward scalar code of the same
// look-up, and loading a MERL file.
#include <brdf/base/File.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/measured/Format.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>

#include "Measuring.h"

namespace {

using namespace brdf;

std::shared_ptr<const TableBrdf> merlTable() {
  static const auto table =
      TableBrdf::tabulate(*parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + (0.5,0.4,0.3)*GGX(alpha=0.1)"));
  return table;
}

/// What one writes first: angles by the book, eight corners, one pair at a time.
void scalarLookup(const TableData& table, const DirectionPairs<double>& pairs, double* values) {
  const TableLayout& layout = table.layout;
  const std::size_t cells = layout.cells();
  for (std::size_t i = 0; i < pairs.count; ++i) {
    const HalfDifference angles = toHalfDifference({pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]},
                                                   {pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]});
    const double phi = angles.phiD < 0 ? angles.phiD + kPi : angles.phiD;
    double p = phi / kPi * static_cast<double>(layout.phiD) - 0.5;
    if (p < 0) p += static_cast<double>(layout.phiD);
    const auto clamped = [](double x, std::size_t n) { return std::clamp(x, 0.0, static_cast<double>(n - 1)); };
    const double d = clamped(angles.thetaD / (kPi / 2) * static_cast<double>(layout.thetaD) - 0.5, layout.thetaD);
    const double h =
        clamped(std::sqrt(angles.thetaH / (kPi / 2)) * static_cast<double>(layout.thetaH) - 0.5, layout.thetaH);
    const auto p0 = std::min(static_cast<std::size_t>(p), layout.phiD - 1), d0 = static_cast<std::size_t>(d),
               h0 = static_cast<std::size_t>(h);
    double sum[3] = {}, total = 0;
    for (int k = 0; k < 8; ++k) {
      const std::size_t pk = (k & 1) ? (p0 + 1) % layout.phiD : p0,
                        dk = std::min(d0 + ((k & 2) ? 1 : 0), layout.thetaD - 1),
                        hk = std::min(h0 + ((k & 4) ? 1 : 0), layout.thetaH - 1);
      const double wp = p - static_cast<double>(p0), wd = d - static_cast<double>(d0), wh = h - static_cast<double>(h0);
      const double weight = ((k & 1) ? wp : 1 - wp) * ((k & 2) ? wd : 1 - wd) * ((k & 4) ? wh : 1 - wh);
      const std::size_t cell = pk + layout.phiD * (dk + layout.thetaD * hk);
      if (!table.valid[cell]) continue;
      total += weight;
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * table.values[c * cells + cell];
    }
    for (std::size_t c = 0; c < 3; ++c) values[c * pairs.count + i] = total > 0 ? sum[c] / total : 0;
  }
}

template <class T>
void lookUp(benchmark::State& state, const Brdf& brdf, bool beside) {
  const auto pairs = randomPairs<T>().view();
  std::vector<T> ours(3 * kPairs);
  std::vector<double> plain(3 * kPairs);
  brdf.evaluate(pairs, ours.data(), nullptr);
  double ourSeconds = 1e30, plainSeconds = 1e30;
  for (auto _ : state) {
    const double seconds = secondsOf([&] { brdf.evaluate(pairs, ours.data(), nullptr); });
    state.SetIterationTime(seconds);
    ourSeconds = std::min(ourSeconds, seconds);
    if (beside)
      plainSeconds =
          std::min(plainSeconds,
                   secondsOf([&] { scalarLookup(merlTable()->data(), randomPairs<double>().view(), plain.data()); }));
  }
  state.counters["Mpairs/s"] = kPairs / ourSeconds * 1e-6;
  if (!beside) return;
  double worst = 0;
  for (std::size_t i = 0; i < 3 * kPairs; ++i)
    worst = std::max(worst, std::abs(static_cast<double>(ours[i]) - plain[i]) / (std::abs(plain[i]) + 1e-3));
  state.counters["scalar Mpairs/s"] = kPairs / plainSeconds * 1e-6;
  state.counters["ratio"] = plainSeconds / ourSeconds;
  state.counters["difference"] = worst;
}

template <class T>
void interpolateTable(benchmark::State& state) {
  lookUp<T>(state, *merlTable(), true);
}
void nearestTable(benchmark::State& state) {
  lookUp<double>(state, *merlTable()->with(TableBrdf::Lookup::Nearest), false);
}
void interpolateGrid(benchmark::State& state) {
  static const auto grid = GridBrdf::tabulate(*merlTable(), GridLayout::fromTable({}));
  lookUp<double>(state, *grid, true);
}
/// UTIA's size: 6 x 48 x 6 x 48.
void interpolateAnisotropicGrid(benchmark::State& state) {
  using Q = AxisQuantity;
  static const auto grid =
      GridBrdf::tabulate(*merlTable(), {Parametrisation::Spherical,
                                        {GridAxis::uniformNodes(Q::PhiO, 0, radians(352.5), 48).periodic(),
                                         GridAxis::uniformNodes(Q::ThetaO, 0, radians(75), 6),
                                         GridAxis::uniformNodes(Q::PhiI, 0, radians(352.5), 48).periodic(),
                                         GridAxis::uniformNodes(Q::ThetaI, 0, radians(75), 6)}});
  lookUp<double>(state, *grid, false);
}

/// The file's bytes in the page cache: reading, scaling, validity.
void loadMerl(benchmark::State& state) {
  const auto path = std::filesystem::temp_directory_path() / "brdf_benchmark.binary";
  writeMeasured(*merlTable(), path);
  for (auto _ : state) benchmark::DoNotOptimize(readMeasured(path).brdf);
  std::filesystem::remove(path);
}

BENCHMARK(interpolateTable<float>)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(7);
BENCHMARK(interpolateTable<double>)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(7);
BENCHMARK(nearestTable)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(7);
BENCHMARK(interpolateGrid)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(7);
BENCHMARK(interpolateAnisotropicGrid)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(7);
BENCHMARK(loadMerl)->Unit(benchmark::kMillisecond)->Iterations(7);

}  // namespace
