#include <brdf/geometry/Directions.h>
#include <brdf/simulate/surfaces/PlaneWaves.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace brdf {
namespace {

constexpr long kMostSpacings = 64;

/// The period along one axis of waves of `frequencies` (1/um, 0 for those that do not vary along it), and how often
/// each repeats in it; 0 where none varies.
double periodOf(std::span<const double> frequencies, std::vector<long>& turns) {
  turns.assign(frequencies.size(), 0);
  const double highest = *std::ranges::max_element(frequencies, {}, [](double f) { return std::abs(f); });
  if (highest == 0) return 0;
  long best = 1;
  double bestError = INFINITY;
  for (long m = 1; m <= kMostSpacings && bestError > 1e-12; ++m) {
    double error = 0;
    for (const double frequency : frequencies) {
      if (frequency == 0) continue;
      const double exact = frequency / std::abs(highest) * static_cast<double>(m);
      const double whole = std::round(exact);
      error = std::max(error, whole == 0 ? INFINITY : std::abs(whole - exact) / static_cast<double>(m));
    }
    if (error < bestError) {
      best = m;
      bestError = error;
    }
  }
  const double period = static_cast<double>(best) / std::abs(highest);
  for (std::size_t k = 0; k < frequencies.size(); ++k) {
    turns[k] = std::lround(frequencies[k] * period);
    if (turns[k] == 0 && frequencies[k] != 0) turns[k] = frequencies[k] > 0 ? 1 : -1;
  }
  return period;
}

/// Cosine of an angle in degrees, exactly 0 where it is.
double cosineOf(double azimuth) {
  const double turn = std::remainder(azimuth, 360);
  return std::abs(turn) == 90 ? 0 : std::cos(radians(turn));
}

}  // namespace

double PlaneWaves::spacing(std::size_t k) const {
  const double fx = periodX > 0 ? static_cast<double>(turns[k][0]) / periodX : 0;
  const double fy = periodY > 0 ? static_cast<double>(turns[k][1]) / periodY : 0;
  return 1 / std::hypot(fx, fy);
}

double PlaneWaves::azimuth(std::size_t k) const {
  const double fx = periodX > 0 ? static_cast<double>(turns[k][0]) / periodX : 0;
  const double fy = periodY > 0 ? static_cast<double>(turns[k][1]) / periodY : 0;
  return degrees(std::atan2(fy, fx));
}

std::size_t PlaneWaves::lines(std::size_t k) const {
  return static_cast<std::size_t>(std::gcd(std::abs(turns[k][0]), std::abs(turns[k][1])));
}

PlaneWaves commensurateTile(double spacing, std::span<const double> azimuths, std::size_t leastLines) {
  std::vector<double> fx, fy;
  for (const double azimuth : azimuths) {
    fx.push_back(cosineOf(azimuth) / spacing);
    fy.push_back(cosineOf(azimuth - 90) / spacing);
  }
  PlaneWaves waves;
  std::vector<long> x, y;
  waves.periodX = periodOf(fx, x);
  waves.periodY = periodOf(fy, y);
  for (std::size_t k = 0; k < azimuths.size(); ++k) waves.turns.push_back({x[k], y[k]});
  long repeats = 1;
  for (std::size_t k = 0; k < azimuths.size(); ++k) {
    const auto lines = static_cast<long>(waves.lines(k)), least = static_cast<long>(leastLines);
    repeats = std::max(repeats, (least + lines - 1) / lines);
  }
  waves.periodX *= static_cast<double>(repeats);
  waves.periodY *= static_cast<double>(repeats);
  for (auto& [m, n] : waves.turns) {
    m *= repeats;
    n *= repeats;
  }
  return waves;
}

}  // namespace brdf
