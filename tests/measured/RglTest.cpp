// RGL and KAIST tensor files: bytes put together here from the format's facts, values from closed forms, the sampler by
// its chi-square, and what our writer makes of a material read back.
#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/fit/Fit.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <brdf/measured/Format.h>
#include <brdf/measured/RglBrdf.h>
#include <brdf/measured/RglTabulation.h>
#include <brdf/measured/Warp2D.h>
#include <brdf/sampling/SamplerChecks.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <map>
#include <random>

#include "MeasuredSupport.h"

namespace brdf {
namespace {

struct RawField {
  std::string name;
  std::uint8_t type;
  std::vector<std::uint64_t> shape;
  std::string data;
};

template <class T>
std::string raw(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}
RawField floats(std::string name, std::vector<std::uint64_t> shape, const std::vector<float>& values) {
  return {std::move(name), 10, std::move(shape), raw(values)};
}

/// A tensor file, its data one after the other without padding.
std::string tensorFile(const std::vector<RawField>& fields) {
  std::size_t offset = 18;
  for (const RawField& f : fields) offset += 2 + f.name.size() + 3 + 8 + 8 * f.shape.size();
  std::string out("tensor_file\0\x01\0", 14), data;
  out += raw(std::vector<std::uint32_t>{static_cast<std::uint32_t>(fields.size())});
  for (const RawField& f : fields) {
    out += raw(std::vector<std::uint16_t>{static_cast<std::uint16_t>(f.name.size())}) + f.name;
    out += raw(std::vector<std::uint16_t>{static_cast<std::uint16_t>(f.shape.size())});
    out += static_cast<char>(f.type);
    out += raw(std::vector<std::uint64_t>{offset + data.size()}) + raw(f.shape);
    data += f.data;
  }
  return out + data;
}

std::filesystem::path written(const std::string& bytes, const char* name = "small.bsdf") {
  const auto folder = measuredtest::folder(name);
  writeFile(folder / name, bytes);
  return folder / name;
}
ReadResult readBytes(const std::string& bytes) { return readMeasured(written(bytes)); }

/// A file whose warps are the identity: densities are even, so the square of lights is the square of half vectors,
/// where rgb is 1 + 2 x + 3 y (times 1, 2, 4 by channel, and by `factor` of each slice).
std::vector<RawField> evenFile(const std::vector<float>& phi, const std::vector<float>& theta, std::uint8_t jacobian,
                               const std::vector<float>& factor) {
  const std::uint64_t p = phi.size(), t = theta.size();
  std::vector<float> rgb;
  for (std::size_t s = 0; s < p * t; ++s)
    for (const float channel : {1.0f, 2.0f, 4.0f})
      for (const float value : {1.0f, 3.0f, 4.0f, 6.0f}) rgb.push_back(factor[s] * channel * value);
  const std::vector<float> even(p * t * 4, 0.25f);
  return {{"description", 1, {4}, "even"},     {"jacobian", 1, {1}, std::string(1, static_cast<char>(jacobian))},
          floats("phi_i", {p}, phi),           floats("theta_i", {t}, theta),
          floats("ndf", {2, 2}, {2, 4, 2, 4}), floats("sigma", {2, 2}, {1, 3, 1, 3}),
          floats("vndf", {p, t, 2, 2}, even),  floats("luminance", {p, t, 2, 2}, even),
          floats("rgb", {p, t, 3, 2, 2}, rgb)};
}

double xOf(double theta) { return std::sqrt(2 * theta / kPi); }

/// f of an even file by hand. Isotropic: phi of the half vector from the viewer's.
double evenValue(const Direction& light, const Direction& viewer, bool isotropic) {
  const Direction m = normalized({light[0] + viewer[0], light[1] + viewer[1], light[2] + viewer[2]});
  const Spherical h = toSpherical(m), v = toSpherical(viewer);
  double y = (h.phi - (isotropic ? v.phi : 0) + kPi) / (2 * kPi);
  y -= std::floor(y);
  return (1 + 2 * xOf(h.theta) + 3 * y) / light[2];
}

const Direction kLight = fromSpherical(0.7, 0.3), kViewer = fromSpherical(0.4, 1.9);

TEST(Rgl, ReadsAHandMadeFile) {
  const ReadResult read = readBytes(tensorFile(evenFile({0}, {0, 1.5f}, 0, {1, 1})));
  EXPECT_EQ(read.report.format, "rgl");
  EXPECT_EQ(read.report.metadata.at("description"), "even");
  EXPECT_EQ(read.brdf->channels(), Channels::rgb());
  const double expected = evenValue(kLight, kViewer, true);
  const std::vector<double> got = read.brdf->evaluate(kLight, kViewer);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got[c], std::pow(2, c) * expected, 1e-6 * got[c]);
  // Turned by any angle: the same.
  const std::vector<double> turned = read.brdf->evaluate(fromSpherical(0.7, 2.8), fromSpherical(0.4, 4.4));
  EXPECT_NEAR(turned[0], got[0], 1e-9);
}

TEST(Rgl, MultipliesByTheVisibleNormalsWhereTheFileSaysSo) {
  const ReadResult read = readBytes(tensorFile(evenFile({0}, {0, 1.5f}, 1, {1, 1})));
  const Direction m = normalized({kLight[0] + kViewer[0], kLight[1] + kViewer[1], kLight[2] + kViewer[2]});
  const double ndf = 2 + 2 * xOf(toSpherical(m).theta), sigma = 1 + 2 * xOf(toSpherical(kViewer).theta);
  EXPECT_NEAR(read.brdf->evaluate(kLight, kViewer)[0], evenValue(kLight, kViewer, true) * ndf / (4 * sigma), 1e-6);
}

TEST(Rgl, InterpolatesBetweenViewersAndHoldsTheLast) {
  const ReadResult read = readBytes(tensorFile(evenFile({0}, {0.2f, 0.6f, 1.0f}, 0, {1, 3, 7})));
  for (const auto& [theta, factor] : std::map<double, double>{{0.1, 1}, {0.3, 1.5}, {0.6, 3}, {0.9, 6}, {1.3, 7}}) {
    const Direction viewer = fromSpherical(theta, 0.8);
    EXPECT_NEAR(read.brdf->evaluate(kLight, viewer)[0], factor * evenValue(kLight, viewer, true), 1e-5) << theta;
  }
}

TEST(Rgl, DividesByNoCosineBelowThatOf85Degrees) {
  const ReadResult read = readBytes(tensorFile(evenFile({0}, {0, 1.5f}, 0, {1, 1})));
  const Direction light = fromSpherical(radians(89), 0.3);
  EXPECT_NEAR(read.brdf->evaluate(light, kViewer)[0],
              evenValue(light, kViewer, true) * light[2] / std::cos(radians(85)), 1e-5);
  EXPECT_EQ(read.brdf->evaluate({0.8, 0, -0.6}, kViewer)[0], 0);
}

// Azimuths over half a turn and a quarter: as the documents of the format say, -180 to 0 and -180 to -90 degrees; and
// one that starts elsewhere.
TEST(Rgl, TurnsAndMirrorsViewersIntoTheMeasuredAzimuths) {
  const auto f = [](const Brdf& brdf, double phiI, double phiO) {
    return brdf.evaluate(fromSpherical(0.7, phiI), fromSpherical(0.4, phiO))[0];
  };
  const auto inside = [](double phiI, double phiO) {
    return evenValue(fromSpherical(0.7, phiI), fromSpherical(0.4, phiO), false);
  };
  constexpr auto pi = static_cast<float>(kPi);
  const ReadResult full = readBytes(tensorFile(evenFile({-pi, 0, pi}, {0.4f}, 0, {1, 1, 1})));
  EXPECT_EQ(full.brdf->symmetry(), Symmetry::Anisotropic);
  EXPECT_NEAR(f(*full.brdf, 0.3, 1.9), inside(0.3, 1.9), 1e-6);

  const ReadResult half = readBytes(tensorFile(evenFile({-pi, -pi / 2, 0}, {0.4f}, 0, {1, 1, 1})));
  EXPECT_EQ(dynamic_cast<const RglBrdf&>(*half.brdf).reduction(), 2);
  EXPECT_NEAR(f(*half.brdf, 0.3, -1.9), inside(0.3, -1.9), 1e-6);
  EXPECT_NEAR(f(*half.brdf, 0.3, 1.9), inside(0.3 - kPi, 1.9 - kPi), 1e-6);

  const ReadResult quarter = readBytes(tensorFile(evenFile({-pi, -0.75f * pi, -pi / 2}, {0.4f}, 0, {1, 1, 1})));
  EXPECT_EQ(dynamic_cast<const RglBrdf&>(*quarter.brdf).reduction(), 4);
  const double expected = inside(0.3, -2.5);
  EXPECT_NEAR(f(*quarter.brdf, 0.3, -2.5), expected, 1e-6);
  EXPECT_NEAR(f(*quarter.brdf, 0.3 + kPi, -2.5 + kPi), expected, 1e-6) << "turned by half a turn";
  EXPECT_NEAR(f(*quarter.brdf, -0.3, 2.5), expected, 1e-6) << "mirrored in the xz plane";
  EXPECT_NEAR(f(*quarter.brdf, kPi - 0.3, kPi + 2.5), expected, 1e-6) << "mirrored in the yz plane";

  const ReadResult other = readBytes(tensorFile(evenFile({0, pi / 2, pi}, {0.4f}, 0, {1, 1, 1})));
  EXPECT_NEAR(f(*other.brdf, 0.3, 1.9), inside(0.3, 1.9), 1e-6);
  EXPECT_NEAR(f(*other.brdf, 0.3, -1.9), inside(0.3 + kPi, -1.9 + kPi), 1e-6);
}

TEST(Rgl, ReadsSpectra) {
  std::vector<RawField> fields = evenFile({0}, {0, 1.5f}, 0, {1, 1});
  fields.back().name = "spectra";
  fields.push_back(floats("wavelengths", {3}, {400, 550, 700}));
  const ReadResult read = readBytes(tensorFile(fields));
  EXPECT_EQ(read.brdf->channels(), Channels::spectral({400, 550, 700}));
  EXPECT_NEAR(read.brdf->evaluate(kLight, kViewer)[2], 4 * evenValue(kLight, kViewer, true), 1e-5);
}

TEST(Rgl, RefusesDamage) {
  const std::vector<RawField> good = evenFile({0}, {0, 1.5f}, 0, {1, 1});
  const std::string bytes = tensorFile(good);
  EXPECT_NO_THROW(readBytes(bytes));
  const auto refused = [](const std::string& damaged, const char* word) {
    try {
      readBytes(damaged);
      ADD_FAILURE() << "accepted: " << word;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Format) << error.what();
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  for (std::size_t length = 12; length < bytes.size(); length += 7) refused(bytes.substr(0, length), "");
  const auto with = [&](std::size_t index, const auto& change) {
    std::vector<RawField> fields = good;
    change(fields[index]);
    return tensorFile(fields);
  };
  refused(with(8, [](RawField& f) { f.name = "xyz"; }), "rgb");
  refused(with(6, [](RawField& f) { f.shape = {1, 2, 4, 1}; }), "too small");
  refused(with(6, [](RawField& f) { f.shape = {2, 1, 2, 2}; }), "vndf");
  refused(with(6, [](RawField& f) { f.shape = {1, 2, std::uint64_t{1} << 62, 4}; }), "vndf");
  refused(with(6, [](RawField& f) { f.shape[0] = 0; }), "vndf");
  refused(with(4, [](RawField& f) { f.type = 11; }), "ndf");
  refused(with(4, [](RawField& f) { f.type = 12; }), "type");
  refused(with(6, [](RawField& f) { f.data = raw(std::vector<float>(8, -1.0f)); }), "negative");
  refused(with(8, [](RawField& f) { f.data = raw(std::vector<float>(24, std::numeric_limits<float>::quiet_NaN())); }),
          "finite");
  refused(with(3, [](RawField& f) { f.data = raw(std::vector<float>{1, 0}); }), "order");
  std::string version = bytes;
  version[12] = 2;
  refused(version, "version");
}

TEST(Warp2D, DrawsALinearDensityByItsSquareRoot) {
  // 4 x y: each number's square root, and back.
  const Warp2D warp(2, 2, {}, {}, {0, 0, 0, 1}, true);
  const auto condition = warp.locate(0, 0);
  const Warp2D::Drawn drawn = warp.draw({0.49, 0.16}, condition);
  EXPECT_NEAR(drawn.at.x, 0.7, 1e-7);
  EXPECT_NEAR(drawn.at.y, 0.4, 1e-7);
  EXPECT_NEAR(drawn.density, 4 * 0.7 * 0.4, 1e-6);
  const Warp2D::Drawn back = warp.invert({0.7, 0.4}, condition);
  EXPECT_NEAR(back.at.x, 0.49, 1e-7);
  EXPECT_NEAR(back.at.y, 0.16, 1e-7);
}

TEST(Warp2D, InvertsItselfForAnyDensityAndCondition) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<float> values(3 * 2 * 5 * 7);
  for (float& v : values) v = static_cast<float>(std::pow(uniform(random), 4));
  const Warp2D warp(7, 5, {-1, 0, 2}, {0, 1}, values, true);
  for (int k = 0; k < 2000; ++k) {
    const auto condition = warp.locate(4 * uniform(random) - 1.5, 1.4 * uniform(random) - 0.2);
    const Warp2D::Point u{uniform(random), uniform(random)};
    const Warp2D::Drawn drawn = warp.draw(u, condition), back = warp.invert(drawn.at, condition);
    EXPECT_NEAR(back.at.x, u.x, 1e-9);
    EXPECT_NEAR(back.at.y, u.y, 1e-9);
    EXPECT_NEAR(back.density, drawn.density, 1e-9 * drawn.density);
    EXPECT_NEAR(drawn.density, warp.evaluate(drawn.at, condition), 1e-9 * drawn.density);
  }
}

struct Material {
  const char* name;
  const char* expression;
  double rms;  ///< share of the zero model's that the round trip may lose, lights and viewers up to 80 degrees
};
const Material kMaterials[] = {
    {"Diffuse", "(0.5,0.3,0.1)*Lambertian", 0.01},
    {"Plastic", "(0.3,0.1,0.05)*Lambertian + GGX(alpha=0.2, ior=1.5)", 0.03},
    {"Metal", "GGXConductor(alpha=0.1, eta=(0.2,0.4,1.4), k=(3.9,2.4,1.6))", 0.01},
    {"Brushed", "0.1*Lambertian + GGXConductor(alpha=0.3, alpha_y=0.6)", 0.03},
};

class RglRoundTrip : public testing::TestWithParam<Material> {
 protected:
  BrdfPointer material_ = parseMaterialExpression(GetParam().expression);
  ReadResult again() {
    const auto path = measuredtest::folder("rgl") / (std::string(GetParam().name) + ".bsdf");
    writeMeasured(*material_, path);
    return readMeasured(path);
  }
};

TEST_P(RglRoundTrip, ComesBackWithinItsErrorAndDrawsWhatItsDensitySays) {
  const ReadResult read = again();
  EXPECT_EQ(read.brdf->symmetry() == Symmetry::Anisotropic, material_->symmetry() == Symmetry::Anisotropic);
  const BrdfPointer seen = read.brdf;
  const Comparison error = compare(*seen, *material_, 80);
  EXPECT_LT(error.metrics.at("rms"), GetParam().rms * error.zeroModel.at("rms"));

  const DirectionSampler sampler = samplerOf(*seen);
  for (const double theta : {5.0, 40.0, 75.0}) {
    const SamplerTest test = testSampler(sampler, fromSpherical(radians(theta), 0.4));
    EXPECT_GT(test.chiSquare.probability, sidakSignificance(1e-4, 12)) << theta;
    EXPECT_LT(std::abs(test.deviation), 5) << theta;
    EXPECT_EQ(test.bad, 0u);
    EXPECT_EQ(test.uncovered, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Materials, RglRoundTrip, testing::ValuesIn(kMaterials),
                         [](const auto& material) { return material.param.name; });

// What is lost is resolution: half the steps in all directions, less than half of the error. (A quarter in the limit,
// but for the cells that the horizon crosses.)
TEST(RglWriter, LosesLessWithMoreNodes) {
  const auto material = parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + GGX(alpha=0.3, ior=1.5)");
  const auto loss = [&](const RglResolution& resolution) {
    return compare(RglBrdf(tabulateRgl(*material, resolution), ""), *material, 80).metrics.at("rms_cos");
  };
  EXPECT_LT(loss({41, 1, 161, 65, 65}), loss({21, 1, 81, 33, 33}) / 2);
}

TEST(RglWriter, WritesWhatTheReadersOfRenderersDemand) {
  const auto path = measuredtest::folder("rgl") / "fields.bsdf";
  const auto material =
      parseMaterialExpression("(0.1,0.2,0.3,0.4)*Lambertian", Channels::spectral({400, 500, 600, 700}));
  writeMeasured(*material, path);
  const std::string bytes = readFile(path);
  ASSERT_EQ(bytes.substr(0, 14), std::string("tensor_file\0\x01\0", 14));
  const auto number = [&]<class T>(std::size_t& at, T) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
  };
  std::size_t at = 14;
  const auto count = number(at, std::uint32_t{});
  std::map<std::string, std::pair<int, std::vector<std::uint64_t>>> fields;
  for (std::uint32_t f = 0; f < count; ++f) {
    const auto length = number(at, std::uint16_t{});
    const std::string name = bytes.substr(at, length);
    at += length;
    const auto dimensions = number(at, std::uint16_t{});
    const auto type = number(at, std::uint8_t{});
    EXPECT_EQ(number(at, std::uint64_t{}) % 8, 0u) << name << " is not aligned";
    std::vector<std::uint64_t> shape;
    for (int d = 0; d < dimensions; ++d) shape.push_back(number(at, std::uint64_t{}));
    fields[name] = {type, shape};
  }
  for (const char* name : {"theta_i", "phi_i", "ndf", "sigma", "vndf", "luminance", "spectra", "wavelengths"})
    EXPECT_EQ(fields.at(name).first, 10) << name << " is float32";
  EXPECT_EQ(fields.at("description").first, 1);
  EXPECT_EQ(fields.at("jacobian"), (std::pair<int, std::vector<std::uint64_t>>{1, {1}}));
  const std::uint64_t p = fields.at("phi_i").second.at(0), t = fields.at("theta_i").second.at(0);
  EXPECT_LE(p, 2u) << "isotropic";
  const auto& luminance = fields.at("luminance").second;
  const auto& spectra = fields.at("spectra").second;
  ASSERT_EQ(luminance.size(), 4u);
  ASSERT_EQ(spectra.size(), 5u);
  EXPECT_EQ(fields.at("vndf").second.size(), 4u);
  EXPECT_EQ(fields.at("vndf").second[0], p);
  EXPECT_EQ(fields.at("vndf").second[1], t);
  EXPECT_EQ(luminance[2], luminance[3]);
  EXPECT_EQ(spectra, (std::vector<std::uint64_t>{p, t, 4, luminance[2], luminance[3]}));
  EXPECT_EQ(fields.at("wavelengths").second, std::vector<std::uint64_t>{4});
}

TEST(Kaist, ReadsTheUnpolarisedElement) {
  const std::vector<float> thetaH = {0, 0.8f, 1.5707964f}, thetaD = {0, 1.5707964f},
                           phiD = {-3.1415927f, 0, 3.1415927f};
  std::vector<float> m;
  for (int p = 0; p < 3; ++p)
    for (int d = 0; d < 2; ++d)
      for (int h = 0; h < 3; ++h)
        for (int w = 0; w < 2; ++w)
          for (int e = 0; e < 16; ++e)
            m.push_back(e == 0 ? (h == 2 && d == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                   : static_cast<float>(1 + h + 10 * d + 100 * w))
                               : -5.0f);
  const std::vector<RawField> fields = {floats("theta_h", {1, 3}, thetaH),
                                        floats("theta_d", {1, 2}, thetaD),
                                        floats("phi_d", {1, 3}, phiD),
                                        {"wvls", 3, {2}, raw(std::vector<std::uint16_t>{450, 650})},
                                        floats("M", {3, 2, 3, 2, 4, 4}, m)};
  const ReadResult read = readBytes(tensorFile(fields));
  EXPECT_EQ(read.report.format, "kaist");
  EXPECT_EQ(read.brdf->channels(), Channels::spectral({450, 650}));
  // theta_h = 0.4 and theta_d = 0.5: bilinear in the angles.
  const DirectionPair pair = fromHalfDifference({0.4, 0.3, 0.5, 1.0});
  const double expected = 1 + 0.5 + 10 * 0.5 / (kPi / 2);
  const std::vector<double> got = read.brdf->evaluate(pair.wi, pair.wo);
  EXPECT_NEAR(got[0], expected, 1e-6);
  EXPECT_NEAR(got[1], expected + 100, 1e-5);
  EXPECT_GT(read.report.notFinite, 0u);
  EXPECT_FALSE(read.report.warnings.empty());
}

}  // namespace
}  // namespace brdf
