// Formats that are grids of numbers: files made here byte by byte from the format's facts, looked up at directions
// whose cell is worked out by hand.
#include <brdf/io/ImageFile.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/measured/Format.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "MeasuredSupport.h"

namespace {

using brdf::Direction;
using brdf::fromSpherical;
using brdf::radians;
using measuredtest::errorOf;
using measuredtest::folder;

template <class T>
std::string bytesOf(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), sizeof(T) * numbers.size()};
}

brdf::ReadResult readBytes(const std::string& name, const std::string& bytes, const brdf::ReadOptions& options = {}) {
  const auto path = folder("grid_files") / name;
  brdf::writeFile(path, bytes);
  return brdf::readMeasured(path, options);
}

std::vector<double> at(const brdf::Brdf& brdf, double thetaI, double phiI, double thetaO, double phiO) {
  return brdf.evaluate(fromSpherical(radians(thetaI), radians(phiI)), fromSpherical(radians(thetaO), radians(phiO)));
}

/// A number for each cell and colour of a UTIA file that tells which one it is: the index of the light's theta (15
/// degrees) and phi (7.5), and the viewer's.
double utiaCode(std::size_t ti, std::size_t pi, std::size_t to, std::size_t po, std::size_t colour) {
  return static_cast<double>(ti) + 1e-2 * static_cast<double>(pi) + 1e-3 * static_cast<double>(to) +
         1e-6 * static_cast<double>(po) + 10 * static_cast<double>(colour);
}

std::vector<double> utiaCodes() {
  std::vector<double> raw;
  for (std::size_t colour = 0; colour < 3; ++colour)
    for (std::size_t ti = 0; ti < 6; ++ti)
      for (std::size_t pi = 0; pi < 48; ++pi)
        for (std::size_t to = 0; to < 6; ++to)
          for (std::size_t po = 0; po < 48; ++po) raw.push_back(utiaCode(ti, pi, to, po, colour));
  return raw;
}

brdf::ReadOptions linear() {
  brdf::ReadOptions options;
  options.colour = brdf::ColourSpace::LinearSrgb;
  return options;
}

}  // namespace

TEST(Utia, LooksUpTheCellOfItsAngles) {
  const auto result = readBytes("a.whatever", bytesOf(utiaCodes()), linear());
  EXPECT_EQ(result.report.format, "utia");
  EXPECT_EQ(result.report.samples, 288u * 288u);
  EXPECT_FALSE(result.report.warnings.empty()) << "the scale is not calibrated";
  const struct { std::size_t ti, pi, to, po; } cells[] = {{1, 0, 2, 24}, {5, 47, 5, 1}, {3, 12, 1, 40}, {2, 46, 4, 47}};
  for (const auto& [ti, pi, to, po] : cells) {
    const auto values = at(*result.brdf, 15.0 * static_cast<double>(ti), 7.5 * static_cast<double>(pi),
                           15.0 * static_cast<double>(to), 7.5 * static_cast<double>(po));
    for (std::size_t colour = 0; colour < 3; ++colour)
      EXPECT_NEAR(values[colour], utiaCode(ti, pi, to, po, colour), 1e-9) << ti << pi << to << po;
  }
  // Half way between two azimuths of the viewer, and beyond the last polar angle.
  EXPECT_NEAR(at(*result.brdf, 30, 15, 45, 3.75)[1], 0.5 * (utiaCode(2, 2, 3, 0, 1) + utiaCode(2, 2, 3, 1, 1)), 1e-9);
  EXPECT_NEAR(at(*result.brdf, 85, 15, 45, 7.5)[2], utiaCode(5, 2, 3, 1, 2), 1e-9);
  EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Anisotropic);
}

TEST(Utia, DecodesSrgbUnlessToldNotTo) {
  std::vector<double> raw(3 * 288 * 288, 0.5);
  raw[0] = 2;      // measured values go beyond 1
  raw[1] = 0.02;   // the straight piece
  raw[2] = -0.02;  // noise
  const auto result = readBytes("b.bin", bytesOf(raw));
  const auto& values = dynamic_cast<const brdf::GridBrdf&>(*result.brdf).data().values;
  EXPECT_NEAR(values[5], 0.21404114048223255, 1e-12);  // ((0.5 + 0.055)/1.055)^2.4, IEC 61966-2-1
  EXPECT_NEAR(values[0], std::pow(2.055 / 1.055, 2.4), 1e-12);
  EXPECT_NEAR(values[1], 0.02 / 12.92, 1e-15);
  EXPECT_NEAR(values[2], -0.02 / 12.92, 1e-15);
  EXPECT_EQ(result.report.negative, 1u);
}

TEST(Utia, WhatIsWrittenReadsBack) {
  const auto dir = folder("utia_round_trip");
  const auto original = readBytes("c.bin", bytesOf(utiaCodes()), linear());
  for (const auto& [name, tolerance] : {std::pair{"utia", 1e-13}, std::pair{"utia-exr", 2e-6}}) {
    const auto path = dir / name;
    brdf::writeMeasured(*original.brdf, path, name);
    const auto again = brdf::readMeasured(path);
    EXPECT_EQ(again.report.format, name);
    const auto& a = dynamic_cast<const brdf::GridBrdf&>(*original.brdf).data().values;
    const auto& b = dynamic_cast<const brdf::GridBrdf&>(*again.brdf).data().values;
    ASSERT_EQ(a.size(), b.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]) / 25);
    EXPECT_LT(worst, tolerance) << name;
  }
}

TEST(Utia, OtherMaterialsAreResampledAndItIsSaid) {
  const auto dir = folder("utia_resampled");
  const measuredtest::FunctionBrdf glossy(measuredtest::glossy);
  const auto report = brdf::writeMeasured(glossy, dir / "g.bin", "utia");
  ASSERT_FALSE(report.losses.empty());
  const auto again = brdf::readMeasured(dir / "g.bin");
  const Direction wi = fromSpherical(radians(30), radians(15)), wo = fromSpherical(radians(45), radians(180));
  EXPECT_NEAR(again.brdf->evaluate(wi, wo)[1], measuredtest::glossy(wi, wo, 1), 1e-12);
}

TEST(Utia, APictureOfAnotherShapeIsNotOne) {
  const auto dir = folder("utia_shape");
  brdf::Image image(288, 287, 3);
  brdf::writeExr(image, dir / "p.exr");
  EXPECT_NE(errorOf([&] { brdf::readMeasured(dir / "p.exr"); }), "");
  const auto bytes = bytesOf(utiaCodes());
  EXPECT_NE(errorOf([&] { readBytes("short.bin", bytes.substr(8)); }).find("1990656 bytes"), std::string::npos);
}

namespace {

/// 3 x 4 x 8 x 5 cells: theta_i, theta_o, phi_difference, phi_i.
std::string csailBytes(std::int32_t half = 0) {
  std::vector<std::int32_t> header(16, 7);  // what is not established may be anything
  header[0] = 3, header[1] = 4, header[2] = 8, header[3] = 5;
  header[6] = 1, header[7] = 0, header[9] = half, header[10] = 3;
  std::vector<float> values;
  for (int colour = 0; colour < 3; ++colour)
    for (int ti = 0; ti < 3; ++ti)
      for (int to = 0; to < 4; ++to)
        for (int pd = 0; pd < 8; ++pd)
          for (int pi = 0; pi < 5; ++pi)
            values.push_back(static_cast<float>(1000 * colour + 200 * ti + 50 * to + 6 * pd + pi));
  values[7] = -1;
  return bytesOf(header) + bytesOf(values);
}

}  // namespace

TEST(Csail, LooksUpTheBinOfItsAngles) {
  const auto result = readBytes("d.brdf", csailBytes());
  EXPECT_EQ(result.report.format, "csail");
  EXPECT_EQ(result.report.samples, 3u * 4 * 8 * 5);
  EXPECT_EQ(result.report.negative, 1u);
  // Bins of 30, 22.5, 45 and 72 degrees: theta_i 45 is in bin 1, theta_o 56.25 in 2, phi_i 108 in 1, and
  // phi_o - phi_i = 112.5 in 2; all at their centres.
  const auto values = at(*result.brdf, 45, 108, 56.25, 220.5);
  for (int colour = 0; colour < 3; ++colour) EXPECT_NEAR(values[colour], 1000 * colour + 200 + 100 + 12 + 1, 1e-6);
  // phi_i 324, in the last bin, 4; phi_o - phi_i = 22.5 - 360.
  EXPECT_NEAR(at(*result.brdf, 15, 324, 11.25, 346.5)[0], 4, 1e-6);
}

TEST(Csail, BeyondHalfATurnNothingIsKnown) {
  const auto result = readBytes("e.brdf", csailBytes(1));
  const Direction wi = fromSpherical(radians(45), radians(108));
  brdf::DirectionPairBuffer<double> pairs(2);
  pairs.set(0, wi, fromSpherical(radians(56.25), radians(108 + 56.25)));  // bins of 22.5 degrees: bin 2
  pairs.set(1, wi, fromSpherical(radians(56.25), radians(108 + 236.25)));
  std::vector<double> values(6);
  std::vector<std::uint8_t> valid(2);
  result.brdf->evaluate(pairs.view(), values.data(), valid.data());
  EXPECT_EQ(valid[0], 1);
  EXPECT_NEAR(values[0], 200 + 100 + 12 + 1, 1e-6);
  EXPECT_EQ(valid[1], 0);
}

TEST(Csail, BrokenFilesAreErrors) {
  const std::string good = csailBytes();
  EXPECT_NE(errorOf([&] { readBytes("f.brdf", good.substr(0, good.size() - 4)); }).find("5824 bytes"),
            std::string::npos);
  std::string huge = good;
  const std::int32_t most = 10000;
  for (std::size_t axis = 0; axis < 4; ++axis) std::memcpy(huge.data() + 4 * axis, &most, 4);
  EXPECT_NE(errorOf([&] { readBytes("g.brdf", huge); }), "");
}

TEST(CarPaint, ReordersItsCells) {
  constexpr std::size_t cells = 180 * 90 * 90;
  std::string bytes(84 + 12 * cells, '\0');
  const auto put = [&](std::size_t p, std::size_t h, std::size_t d, float red) {
    for (std::size_t colour = 0; colour < 3; ++colour) {
      const float value = red * static_cast<float>(colour + 1);
      std::memcpy(bytes.data() + 84 + 4 * (3 * (d + 90 * (h + 90 * p)) + colour), &value, 4);
    }
  };
  put(0, 0, 0, 3);
  put(17, 30, 40, 5);
  put(179, 2, 8, -1);
  const auto result = readBytes("paint.whatever", bytes);
  EXPECT_EQ(result.report.format, "carpaint");
  EXPECT_EQ(result.report.negative, 1u);
  const auto& data = dynamic_cast<const brdf::TableBrdf&>(*result.brdf).data();
  const auto cell = [](std::size_t p, std::size_t h, std::size_t d) { return p + 180 * (d + 90 * h); };
  EXPECT_EQ(data.values[cell(0, 0, 0)], 3);
  EXPECT_EQ(data.values[2 * cells + cell(17, 30, 40)], 15);
  EXPECT_EQ(data.valid[cell(179, 2, 8)], 0);
  EXPECT_EQ(data.valid[cell(178, 2, 8)], 1);
}
