#include "ScalarWaves.h"

#include <cmath>

namespace scalar {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = 3.14159265358979323846;

struct Angles {
  double thetaI, thetaS, phi, fx, fy;
};

Angles anglesOf(const WavePairs& p, std::size_t k, double wavelength) {
  Angles a;
  a.thetaI = std::acos(p.wiz[k]);
  a.thetaS = std::acos(p.woz[k]);
  a.phi = std::atan2(p.woy[k], p.wox[k]) - std::atan2(-p.wiy[k], -p.wix[k]);
  a.fx = (p.wix[k] + p.wox[k]) / wavelength;
  a.fy = (p.wiy[k] + p.woy[k]) / wavelength;
  return a;
}

double perturbation(const Angles& a, Complex index) {
  const Complex e = index * index;
  const double ci = std::cos(a.thetaI), si = std::sin(a.thetaI), cs = std::cos(a.thetaS), ss = std::sin(a.thetaS);
  const Complex qi = std::sqrt(e - si * si), qs = std::sqrt(e - ss * ss);
  const Complex sToS = (e - 1.0) * std::cos(a.phi) / ((ci + qi) * (cs + qs));
  const Complex pToS = -(e - 1.0) * qi * std::sin(a.phi) / ((e * ci + qi) * (cs + qs));
  const Complex sToP = -(e - 1.0) * qs * std::sin(a.phi) / ((ci + qi) * (e * cs + qs));
  const Complex pToP = (e - 1.0) * (e * si * ss - qi * qs * std::cos(a.phi)) / ((e * ci + qi) * (e * cs + qs));
  return 0.5 * (std::norm(sToS) + std::norm(pToS) + std::norm(sToP) + std::norm(pToP));
}

/// exp(-g) times the sum of g^m / m! `transform`(m).
template <class Transform>
double series(double g, Transform&& transform) {
  double sum = 0, weight = std::exp(-g);
  for (int m = 1; m < 1000; ++m) {
    weight *= g / m;
    const double term = weight * transform(m);
    sum += term;
    if (m > g && term < 1e-12 * sum) break;
  }
  return sum;
}

double gaussianPhi(const Angles& a, double g, double length) {
  const double x = std::pow(kPi * length, 2) * (a.fx * a.fx + a.fy * a.fy);
  return kPi * length * length * series(g, [&](int m) { return std::exp(-x / m) / m; });
}

double heightPhase(const Angles& a, double wavelength, double rms) {
  return std::pow(2 * kPi * rms * (std::cos(a.thetaI) + std::cos(a.thetaS)) / wavelength, 2);
}

}  // namespace

void rayleighRice(const WavePairs& pairs, Complex index, double wavelength, double a, double b, double c,
                  double* values) {
  for (std::size_t k = 0; k < pairs.count; ++k) {
    const Angles angles = anglesOf(pairs, k, wavelength);
    const double psd = a / std::pow(1 + b * b * (angles.fx * angles.fx + angles.fy * angles.fy), c / 2);
    values[k] = 16 * kPi * kPi / std::pow(wavelength, 4) * std::cos(angles.thetaI) * std::cos(angles.thetaS) *
                perturbation(angles, index) * psd;
  }
}

void harveyShackGaussian(const WavePairs& pairs, Complex index, double wavelength, double rms, double length,
                         double* values) {
  for (std::size_t k = 0; k < pairs.count; ++k) {
    const Angles angles = anglesOf(pairs, k, wavelength);
    values[k] = perturbation(angles, index) * gaussianPhi(angles, heightPhase(angles, wavelength, rms), length) /
                (wavelength * wavelength);
  }
}

void harveyShackExponential(const WavePairs& pairs, Complex index, double wavelength, double a, double b,
                            double* values) {
  const double length = b / (2 * kPi), rms = std::sqrt(2 * kPi * a) / b;
  for (std::size_t k = 0; k < pairs.count; ++k) {
    const Angles angles = anglesOf(pairs, k, wavelength);
    const double x = std::pow(2 * kPi * length, 2) * (angles.fx * angles.fx + angles.fy * angles.fy);
    const double phi = 2 * kPi * length * length * series(heightPhase(angles, wavelength, rms), [&](int m) {
                         return m / std::pow(m * m + x, 1.5);
                       });
    values[k] = perturbation(angles, index) * phi / (wavelength * wavelength);
  }
}

void beckmannKirchhoff(const WavePairs& pairs, Complex index, double wavelength, double rms, double length,
                       double* values) {
  for (std::size_t k = 0; k < pairs.count; ++k) {
    const Angles angles = anglesOf(pairs, k, wavelength);
    const double ci = std::cos(angles.thetaI), cs = std::cos(angles.thetaS);
    const double cosine = 1 + ci * cs - std::sin(angles.thetaI) * std::sin(angles.thetaS) * std::cos(angles.phi);
    const double half = std::sqrt(cosine / 2);
    const Complex q = std::sqrt(index * index - 1.0 + half * half);
    const Complex s = (half - q) / (half + q), p = (index * index * half - q) / (index * index * half + q);
    const double factor = cosine * cosine / (ci * cs * std::pow(ci + cs, 2));
    values[k] = 0.5 * (std::norm(s) + std::norm(p)) * factor *
                gaussianPhi(angles, heightPhase(angles, wavelength, rms), length) / (wavelength * wavelength);
  }
}

}  // namespace scalar
