#pragma once
#include <brdf/simulate/wave/WaveModels.h>

#include <cmath>
#include <numbers>
#include <random>

namespace brdf {

constexpr double kDegree = std::numbers::pi / 180;

inline std::array<double, 3> directionOf(double thetaDegrees, double phiDegrees) {
  const double theta = thetaDegrees * kDegree, phi = phiDegrees * kDegree;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// wi on the side of -x, wo at azimuth phi from the forward direction.
struct PairOfDirections {
  std::array<double, 3> wi, wo;
  PairOfDirections(double thetaI, double thetaS, double phi)
      : wi(directionOf(thetaI, 180)), wo(directionOf(thetaS, phi)) {}
  DirectionPairs<double> view() const { return {{&wi[0], &wi[1], &wi[2]}, {&wo[0], &wo[1], &wo[2]}, 1}; }
};

inline double valueOf(const WaveBrdf& brdf, const PairOfDirections& pair) { return brdf.evaluate(pair.wi, pair.wo)[0]; }
inline double valueOf(std::string_view expression, const PairOfDirections& pair) {
  return valueOf(*makeWaveBrdf(expression), pair);
}
inline wave::Mueller muellerOf(const WaveBrdf& brdf, const PairOfDirections& pair) {
  wave::Mueller matrix;
  brdf.mueller(pair.view(), 0, &matrix);
  return matrix;
}

/// Integral of value cos(theta_s) over the hemisphere by Gauss-Legendre in cos^2 and the trapezoidal rule in azimuth.
template <class Value>
double hemisphereIntegral(Value&& value, int rings = 200, int azimuths = 180) {
  double sum = 0;
  for (int r = 0; r < rings; ++r) {
    // u = sin^2 theta by the midpoint rule after u = v^2 (3 - 2 v), which is flat at both ends.
    const double v = (r + 0.5) / rings, u = v * v * (3 - 2 * v), weight = 6 * v * (1 - v) / rings;
    const double sine = std::sqrt(u), cosine = std::sqrt(1 - u);
    for (int a = 0; a < azimuths; ++a) {
      const double phi = 2 * std::numbers::pi * (a + 0.5) / azimuths;
      sum += weight * value({sine * std::cos(phi), sine * std::sin(phi), cosine}) * std::numbers::pi / azimuths;
    }
  }
  return sum;
}

}  // namespace brdf
