#pragma once
// What other programs compute from the files we write for them: plain scalar code from the formulas of their
// documentation, sharing nothing with the library, and readers of their files are built on it.
#include <brdf/exports/Exporter.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <functional>

namespace brdf::test {

using Colour = std::array<double, 3>;
using Shading = std::function<Colour(const Direction& light, const Direction& viewer)>;

inline Colour operator*(double s, const Colour& c) { return {s * c[0], s * c[1], s * c[2]}; }
inline Colour operator*(const Colour& a, const Colour& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
inline Colour operator+(const Colour& a, const Colour& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

inline Direction halfVector(const Direction& l, const Direction& v) {
  return normalized({l[0] + v[0], l[1] + v[1], l[2] + v[2]});
}
inline double ggx(const Direction& m, double ax, double ay) {
  const double e = m[0] * m[0] / (ax * ax) + m[1] * m[1] / (ay * ay) + m[2] * m[2];
  return 1 / (kPi * ax * ay * e * e);
}
inline double beckmann(const Direction& m, double ax, double ay) {
  const double c2 = m[2] * m[2], t = m[0] * m[0] / (ax * ax) + m[1] * m[1] / (ay * ay);
  return std::exp(-t / c2) / (kPi * ax * ay * c2 * c2);
}
/// tan^2 of the polar angle times the squared roughness in its azimuth.
inline double roughTangent2(const Direction& w, double ax, double ay) {
  return (w[0] * w[0] * ax * ax + w[1] * w[1] * ay * ay) / (w[2] * w[2]);
}
inline double lambdaGgx(const Direction& w, double ax, double ay) {
  return (std::sqrt(1 + roughTangent2(w, ax, ay)) - 1) / 2;
}
inline double g1Walter(const Direction& w, double ax, double ay) {
  const double a = 1 / std::sqrt(roughTangent2(w, ax, ay));
  return a >= 1.6 ? 1 : (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
}
/// Fresnel's equations with complex numbers: eta + i k, or a dielectric with k = 0.
inline double fresnel(double eta, double k, double cosine) {
  const std::complex<double> n(eta, k), sine2 = 1 - cosine * cosine;
  const std::complex<double> t = std::sqrt(n * n - sine2);
  const std::complex<double> s = (cosine - t) / (cosine + t), p = (n * n * cosine - t) / (n * n * cosine + t);
  return (std::norm(s) + std::norm(p)) / 2;
}
inline double schlick(double f0, double cosine) { return f0 + (1 - f0) * std::pow(1 - cosine, 5); }

/// A BRDF from what a reader made of a file.
class ReadBack : public Brdf {
 public:
  ReadBack(Shading shading, Channels channels) : shading_(std::move(shading)), channels_(std::move(channels)) {}
  const Channels& channels() const override { return channels_; }
  Symmetry symmetry() const override { return Symmetry::Anisotropic; }
  bool reciprocal() const override { return false; }
  std::string description() const override { return "read back"; }
  using Brdf::evaluate;
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      const Direction wo{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      const Colour colour = wi[2] > 0 && wo[2] > 0 ? shading_(wi, wo) : Colour{};
      for (std::size_t c = 0; c < channels_.count(); ++c) values[c * pairs.count + i] = colour[c];
      if (valid) valid[i] = 1;
    }
  }

 private:
  Shading shading_;
  Channels channels_;
};

inline std::vector<DirectionPair> somePairs() {
  std::vector<DirectionPair> pairs;
  for (const double ti : {0.0, 20.0, 55.0, 80.0})
    for (const double to : {0.0, 35.0, 54.0, 75.0})
      for (const double phi : {0.0, 70.0, 180.0, 250.0})
        pairs.push_back({fromSpherical(radians(ti), radians(13)), fromSpherical(radians(to), radians(13 + phi))});
  return pairs;
}

/// Every channel at every pair within `relative`.
inline void expectSame(const Shading& got, const Brdf& expected, double relative) {
  for (const DirectionPair& pair : somePairs()) {
    const std::vector<double> want = expected.evaluate(pair.wi, pair.wo);
    const Colour have = got(pair.wi, pair.wo);
    for (std::size_t c = 0; c < want.size(); ++c)
      EXPECT_NEAR(have[c], want[c], relative * want[c] + 1e-12)
          << "channel " << c << " at light z " << pair.wi[2] << ", viewer z " << pair.wo[2];
  }
}

/// The error stated with an approximation is that of the file read back, to `relative`.
inline void expectStatedError(const Shading& got, const ExportResult& result, const Brdf& material, double relative) {
  EXPECT_FALSE(result.exact);
  const Comparison own = compare(ReadBack(got, result.evaluated->channels()), material, 80);
  for (const char* metric : {"rms", "rms_cos", "log"})
    EXPECT_NEAR(own.metrics.at(metric), result.error.comparison.metrics.at(metric),
                relative * result.error.comparison.metrics.at(metric))
        << metric;
  const ExportError& e = result.error;
  const Colour worst = got(e.wi, e.wo);
  const std::vector<double> there = material.evaluate(e.wi, e.wo);
  double difference = 0;
  for (std::size_t c = 0; c < there.size(); ++c) difference = std::max(difference, std::abs(worst[c] - there[c]));
  EXPECT_NEAR(difference, e.worstDifference, 10 * relative * e.worstDifference);
}

inline ExportResult exported(const char* format, const BrdfPointer& material) {
  return exportMaterial(material, findExporter(format));
}

}  // namespace brdf::test
