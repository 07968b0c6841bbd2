#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/color/CieTables.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

using nlohmann::json;

namespace {

using Colour = std::array<double, 3>;

double planck(double nanometres) {  // illuminant A, ISO/CIE 11664-2
  return std::pow(560 / nanometres, 5) * std::expm1(1.435e7 / (2848 * 560)) / std::expm1(1.435e7 / (2848 * nanometres));
}

Colour times(const double (&m)[3][3], const Colour& v) {
  Colour result{};
  for (std::size_t r = 0; r < 3; ++r) result[r] = m[r][0] * v[0] + m[r][1] * v[1] + m[r][2] * v[2];
  return result;
}

/// The colour of redReflectance() at 400, 410, ... 700 nm under a light, through the rounded matrices of the standards:
/// XYZ relative to the white of the light, Bradford to D65, linear sRGB.
template <class Light>
Colour redUnder(Light light, const Colour& white) {
  constexpr double cones[3][3] = {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}};
  constexpr double back[3][3] = {
      {0.9869929, -0.1470543, 0.1599627}, {0.4323053, 0.5183603, 0.0492912}, {-0.0085287, 0.0400428, 0.9684867}};
  constexpr double srgb[3][3] = {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
  Colour sum{}, all{};
  for (int w = 400; w <= 700; w += 10) {
    const auto line = brdf::cieAt(w);
    const double matching[3] = {line.xBar, line.yBar, line.zBar};
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += light(w) * matching[k] * redReflectance(w);
      all[k] += light(w) * matching[k];
    }
  }
  for (std::size_t k = 0; k < 3; ++k) sum[k] *= white[k] / all[k];
  Colour seen = times(cones, sum);
  const Colour from = times(cones, white), to = times(cones, {0.95047, 1, 1.08883});
  for (std::size_t k = 0; k < 3; ++k) seen[k] *= to[k] / from[k];
  return times(srgb, times(back, seen));
}

Colour redUnderA() { return redUnder(planck, {1.09850, 1, 0.35585}); }
Colour redUnderD65() {
  return redUnder([](double w) { return brdf::cieAt(w).d65; }, {0.95047, 1, 1.08883});
}

/// The value of a diffuse material times pi.
Colour diffuseColour(const std::filesystem::path& folder, const std::string& file) {
  const json value = reportOf(folder, {"eval", file, "--at", "30,0,20,50"})["values"][0]["value"];
  EXPECT_EQ(value.size(), 3u) << file;
  Colour colour{};
  for (std::size_t c = 0; c < 3; ++c) colour[c] = std::numbers::pi * value[c].get<double>();
  return colour;
}

void expectColour(const Colour& found, const Colour& expected) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-3) << "channel " << c;
}

}  // namespace

TEST(Spectral, ConvertingToColoursFollowsTheIlluminant) {
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  const json plain = reportOf(folder, {"convert", "spectral.xml", "d65.binary"});
  const json lamp = reportOf(folder, {"convert", "spectral.xml", "a.binary", "--illuminant", "A"});
  EXPECT_EQ(plain["losses"][0], "spectrum: reduced to linear sRGB under D65");
  EXPECT_EQ(lamp["losses"][0], "spectrum: reduced to linear sRGB under A, adapted to D65 (Bradford)");
  expectColour(diffuseColour(folder, "d65.binary"), redUnderD65());
  expectColour(diffuseColour(folder, "a.binary"), redUnderA());
  EXPECT_GT(redUnderA()[0] - redUnderD65()[0], 0.05);
}

TEST(Spectral, EveryFormatOfColoursFollowsTheIlluminant) {
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  for (const char* format : {"utia", "zemax", "lighttools", "radiance"}) {
    const std::string file = std::string("lamp.") + format;
    const json report = reportOf(folder, {"convert", "spectral.xml", file, "--format", format, "--illuminant", "A"});
    EXPECT_EQ(report["losses"][0], "spectrum: reduced to linear sRGB under A, adapted to D65 (Bradford)") << format;
    SCOPED_TRACE(format);
    expectColour(diffuseColour(folder, file), redUnderA());
  }
}

TEST(Spectral, InfoSaysTheColourUnderTheLightAskedFor) {
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  std::string lamp;
  for (int w = 380; w <= 780; w += 5) lamp += std::to_string(w) + "," + std::to_string(planck(w)) + "\n";
  brdf::writeFile(folder / "lamp.csv", lamp);
  const auto colourOf = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"info", "spectral.xml"};
    words.insert(words.end(), options.begin(), options.end());
    return reportOf(folder, words)["colour"];
  };
  const json d65 = colourOf({}), a = colourOf({"--illuminant", "A"});
  expectColour(d65["linear_srgb"], redUnderD65());
  expectColour(a["linear_srgb"], redUnderA());
  EXPECT_EQ(d65["illuminant"], "D65");
  // A table of A's is A, but for summing line by line instead of at the data's wavelengths.
  const json own = colourOf({"--illuminant", "lamp.csv"});
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(own["linear_srgb"][c].get<double>(), a["linear_srgb"][c].get<double>(), 0.01);
  EXPECT_NE(colourOf({"--observer", "10"})["linear_srgb"], d65["linear_srgb"]);
  EXPECT_GT(colourOf({"--illuminant", "A", "--adaptation", "none"})["linear_srgb"][0],
            1.2 * a["linear_srgb"][0].get<double>());
}

TEST(Spectral, ExportsSeeTheMaterialUnderTheLightAskedFor) {
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  // A diffuse material is exact in OSL: what the report says it evaluates is the colour itself.
  const auto exported = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"export", "spectral.xml", "--format", "osl", "--out", "red.osl"};
    words.insert(words.end(), options.begin(), options.end());
    const json report = reportOf(folder, words);
    EXPECT_TRUE(report["exact"]);
    const json value =
        reportOf(folder, {"eval", report["evaluated"].get<std::string>(), "--at", "30,0,20,50"})["values"][0]["value"];
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c) colour[c] = value[c].get<double>() * std::numbers::pi;
    return std::pair(colour, report);
  };
  expectColour(exported({}).first, redUnderD65());
  const auto [lamp, report] = exported({"--illuminant", "A"});
  expectColour(lamp, redUnderA());
  EXPECT_EQ(report["colour"]["illuminant"], "A");
  EXPECT_NE(report["notes"].dump().find("under A"), std::string::npos);
  EXPECT_NE(exported({"--observer", "10"}).first, exported({}).first);
}

TEST(Spectral, WrongLightsAreWrongUsage) {
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  for (const auto& [option, value, allowed] : {std::array<const char*, 3>{"--illuminant", "lamp", "D65"},
                                               {"--observer", "5", "10"},
                                               {"--adaptation", "cat", "none"}}) {
    const Outcome run = runBrdf(folder, {"info", "spectral.xml", option, value});
    EXPECT_EQ(run.exitCode, 2) << option;
    EXPECT_NE(run.err.find(allowed), std::string::npos) << run.err;
  }
  const Outcome missing = runBrdf(folder, {"convert", "spectral.xml", "x.binary", "--illuminant", "./missing.csv"});
  EXPECT_EQ(missing.exitCode, 1);
  EXPECT_NE(missing.err.find("missing.csv"), std::string::npos) << missing.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "x.binary"));
}

TEST(Spectral, NothingReducesSpectraButDisplay) {
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  // Reading, containers, text: the same 31 wavelengths.
  reportOf(folder, {"convert", "spectral.csv", "kept.vtkhdf"});
  reportOf(folder, {"convert", "kept.vtkhdf", "again.csv"});
  const json wavelengths = reportOf(folder, {"info", "spectral.csv"})["wavelengths_nm"];
  ASSERT_EQ(wavelengths.size(), 31u);
  for (const char* file : {"kept.vtkhdf", "again.csv", "spectral.xml"})
    EXPECT_EQ(reportOf(folder, {"info", file})["wavelengths_nm"], wavelengths) << file;
  // Values at directions.
  const json value = reportOf(folder, {"eval", "again.csv", "--at", "30,0,30,180"})["values"][0]["value"];
  ASSERT_EQ(value.size(), 31u);
  for (int c = 0; c < 31; ++c)
    EXPECT_NEAR(value[static_cast<std::size_t>(c)].get<double>(), redReflectance(400 + 10 * c) / std::numbers::pi,
                1e-12);
  // A fit finds each wavelength's own factor.
  const json fit = reportOf(folder, {"fit", "spectral.csv", "--lobes", "Lambertian", "--out", "fit.vtkhdf"});
  EXPECT_EQ(fit["channels"].is_number() ? fit["channels"].get<std::size_t>() : fit["channels"].size(), 31u);
  EXPECT_EQ(reportOf(folder, {"info", "fit.vtkhdf"})["wavelengths_nm"], wavelengths);
  const json fitted = reportOf(folder, {"eval", "fit.vtkhdf", "--at", "50,0,10,0"})["values"][0]["value"];
  ASSERT_EQ(fitted.size(), 31u);
  for (int c = 0; c < 31; ++c)
    EXPECT_NEAR(fitted[static_cast<std::size_t>(c)].get<double>(), redReflectance(400 + 10 * c) / std::numbers::pi,
                1e-6);
}

TEST(Spectral, ComparisonsSeeWhatColoursHide) {
  // Two materials that differ at one wavelength out of 31: the mean over channels is that wavelength's error alone.
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  std::string other = brdf::readFile(folder / "spectral.xml");
  const std::size_t scale = other.find("<scale>") + 7, end = other.find(' ', scale);
  other.replace(scale, end - scale, "0.9");  // at 400 nm
  brdf::writeFile(folder / "other.xml", other);
  const json report = reportOf(folder, {"compare", "other.xml", "spectral.xml"});
  const double difference = (0.9 - redReflectance(400)) / std::numbers::pi;
  EXPECT_NEAR(report["metrics"]["rms"].get<double>(), difference / std::sqrt(31.0), 1e-9);
}
