#pragma once
#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/Format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "MeasuredSupport.h"

/// What the tests of the lighting programs' formats share. Angles in degrees.
namespace lightingtest {

using brdf::Direction;
using brdf::radians;

inline std::filesystem::path handWritten(const std::string& name) {
  return std::filesystem::path(BRDF_SOURCE_DIR) / "tests/data/lighting" / name;
}

inline brdf::ReadResult readHandWritten(const std::string& name, const brdf::ReadOptions& options = {}) {
  return brdf::readMeasured(handWritten(name), options);
}

inline brdf::ReadResult readText(const std::string& name, const std::string& text,
                                 const brdf::ReadOptions& options = {}) {
  const auto path = measuredtest::folder("lighting") / name;
  brdf::writeFile(path, text);
  return brdf::readMeasured(path, options);
}

inline Direction polar(double theta, double phi) {
  const double t = radians(theta), p = radians(phi);
  return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

/// The viewer at an angle from the mirror direction of the light (polar angle raised by `offset`), by vectors alone:
/// the mirror direction s, e towards the normal in the plane of incidence, and s x e, which is where a turn of 90
/// degrees counter-clockwise about s takes e.
inline Direction aboutMirror(double thetaI, double phiI, double angle, double azimuth, double offset = 0) {
  const Direction light = polar(thetaI + offset, phiI), normal{0, 0, 1};
  const double cosine = brdf::dot(normal, light);
  Direction s, e;
  for (std::size_t x = 0; x < 3; ++x) s[x] = 2 * cosine * normal[x] - light[x];
  for (std::size_t x = 0; x < 3; ++x) e[x] = normal[x] - cosine * s[x];
  // At normal incidence every direction across s leads away from the normal: towards the light's azimuth.
  e = brdf::dot(e, e) < 1e-20 ? polar(90, phiI) : brdf::normalized(e);
  const Direction side = brdf::cross(s, e);
  Direction viewer;
  for (std::size_t x = 0; x < 3; ++x)
    viewer[x] = std::cos(radians(angle)) * s[x] +
                std::sin(radians(angle)) * (std::cos(radians(azimuth)) * e[x] + std::sin(radians(azimuth)) * side[x]);
  return viewer;
}

inline double valueAt(const brdf::Brdf& brdf, const Direction& wi, const Direction& wo, std::size_t channel = 0) {
  return brdf.evaluate(wi, wo)[channel];
}

inline bool isValid(const brdf::Brdf& brdf, const Direction& wi, const Direction& wo) {
  brdf::DirectionPairBuffer<double> pairs(1);
  pairs.set(0, wi, wo);
  std::vector<double> values(brdf.channels().count());
  std::uint8_t valid = 2;
  brdf.evaluate(pairs.view(), values.data(), &valid);
  return valid == 1;
}

/// Whether one of the sentences holds `part`.
inline bool mentions(const std::vector<std::string>& sentences, const std::string& part) {
  for (const std::string& sentence : sentences)
    if (sentence.find(part) != std::string::npos) return true;
  return false;
}

/// Every text gives an error of one line that names the file, a line, and `expected`.
struct Broken {
  std::string text, expected;
};
inline void expectErrors(const std::string& name, const std::vector<Broken>& cases) {
  for (const Broken& broken : cases) {
    const std::string error = measuredtest::errorOf([&] { readText(name, broken.text); });
    EXPECT_NE(error.find(broken.expected), std::string::npos) << broken.text << "\ngave: " << error;
    EXPECT_NE(error.find(name + ", line "), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

/// `text` with the first `from` replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace lightingtest
