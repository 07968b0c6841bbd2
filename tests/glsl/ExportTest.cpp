// The GLSL that `brdf export` writes, run by itself: value, density and draw of whole materials against the processor.
#include "../TestFolder.h"
#include "ProbeSupport.h"

#include <brdf/check/Cases.h>
#include <brdf/exports/Exporter.h>
#include <brdf/sampling/Sequence.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

namespace brdf {
namespace {

class GlslExport : public test::GlslTest {
 protected:
  static std::string exported(const BrdfPointer& material, ExportOptions options = {}) {
    return exportMaterial(material, findExporter("glsl"), options).text;
  }

  std::vector<vtkBRDFShaderProbe::Column> columns(const CheckPairs& set) const {
    const DirectionPairBuffer<float> narrow = set.narrow();
    const char* const names[] = {"ix", "iy", "iz", "ox", "oy", "oz"};
    std::vector<vtkBRDFShaderProbe::Column> result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.push_back({names[axis], narrow.wi[axis]});
      result.push_back({names[3 + axis], narrow.wo[axis]});
    }
    return result;
  }

  /// Each component of the value and the density, of `text`, against `material`.
  void expectAgreement(const Brdf& material, const std::string& text, const std::vector<std::string>& components) {
    const CheckPairs set = adversarialPairs(300, 41, false).rounded();
    std::vector<double> values(material.channels().count() * set.size()), density(set.size());
    material.evaluate(set.pairs.view(), values.data(), nullptr);
    material.pdf(set.pairs.view(), density.data());
    const auto inputs = columns(set);
    for (std::size_t c = 0; c < components.size(); ++c) {
      const auto got = probe().Evaluate(text, inputs,
                                        {"material_evaluate(vec3(ix, iy, iz), vec3(ox, oy, oz))" + components[c],
                                         "material_pdf(vec3(ix, iy, iz), vec3(ox, oy, oz))"});
      std::size_t positive = 0;
      for (std::size_t k = 0; k < set.size(); ++k) {
        EXPECT_NEAR(got[0][k], values[c * set.size() + k], 1e-30 + 1e-5 * values[c * set.size() + k])
            << "component " << c << ", " << directionText(set.wi(k), set.wo(k));
        EXPECT_NEAR(got[1][k], density[k], 1e-30 + 1e-5 * density[k]) << directionText(set.wi(k), set.wo(k));
        positive += values[c * set.size() + k] > 0;
      }
      EXPECT_GT(positive, set.size() / 2);
    }
  }
};

const std::vector<std::string> kColour = {".x", ".y", ".z"};

// A float rounds the parameters too: those here are floats.
TEST_F(GlslExport, AgreesWithTheProcessorForASumOfLobes) {
  const auto material =
      parseMaterialExpression("(0.25,0.125,0.0625)*Lambertian + 0.5*GGX(alpha=0.25, alpha_y=0.125, ior=1.5)");
  expectAgreement(*material, exported(material), kColour);
}

TEST_F(GlslExport, AgreesForLobesThatDifferBetweenTheChannels) {
  const auto material = parseMaterialExpression(
      "0.25*OrenNayar(sigma=(0.25,0.5,0.75)) + (0.5,0.25,0.125)*GGXConductor(alpha=0.25, eta=(0.25,0.5,1.5), "
      "k=(3,2.5,2))");
  expectAgreement(*material, exported(material), kColour);
}

TEST_F(GlslExport, AgreesForOneChannelAndForUniforms) {
  const auto material = parseMaterialExpression("0.25*Lambertian + 0.5*Ward(ax=0.25, ay=0.5)");
  expectAgreement(*material, exported(material), {""});
  ExportOptions options;
  options.uniforms = true;
  const std::string text = exported(material, options);
  EXPECT_NE(text.find("uniform float material_1_Ward_ax = 0.25;"), std::string::npos);
  EXPECT_EQ(text.find("const float material_1"), std::string::npos);
  expectAgreement(*material, text, {""});
}

TEST_F(GlslExport, AgreesForASpectrumWithATable) {
  const auto material = parseMaterialExpression(
      "(0.25,0.5,0.125,0.0625)*GGXMultiscatter(alpha=0.5, F0=0.5) + "
      "(0.5,0.25,0.75,0.125)*GGX(alpha=(0.25,0.5,0.5,0.75))",
      Channels::spectral({450, 500, 550, 600}));
  expectAgreement(*material, exported(material), {"[0]", "[1]", "[2]", "[3]"});
}

TEST_F(GlslExport, DrawsWhatTheProcessorDraws) {
  const auto material = parseMaterialExpression(
      "0.25*Lambertian + (0.5,0.25,0.125)*GGXConductor(alpha=0.25, eta=(0.25,0.5,1.5), k=(3,2.5,2))");
  constexpr std::size_t count = 4000;
  std::mt19937_64 random(42);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> wo[3], u[2];
  std::vector<double> wideWo[3], wideU[2], wi[3];
  for (std::size_t k = 0; k < count; ++k) {
    const double first = std::generate_canonical<double, 53>(random),
                 second = std::generate_canonical<double, 53>(random);
    const Direction v = cosineDirection(first, second);
    for (std::size_t axis = 0; axis < 3; ++axis) wo[axis].push_back(static_cast<float>(v[axis]));
    for (auto& numbers : u) numbers.push_back(std::min(uniform(random), 0x1.fffffep-1f));
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    wideWo[axis].assign(wo[axis].begin(), wo[axis].end()), wi[axis].resize(count);
  for (std::size_t k = 0; k < 2; ++k) wideU[k].assign(u[k].begin(), u[k].end());
  material->sample({wideWo[0].data(), wideWo[1].data(), wideWo[2].data()}, {wideU[0].data(), wideU[1].data()},
                   {wi[0].data(), wi[1].data(), wi[2].data()}, count);
  std::vector<vtkBRDFShaderProbe::Column> inputs = {{"x", wo[0]}, {"y", wo[1]}, {"z", wo[2]}, {"u", u[0]}, {"v", u[1]}};
  const std::string call = "material_sample(vec3(x, y, z), vec2(u, v))";
  const auto got = probe().Evaluate(exported(material), inputs, {call + ".x", call + ".y", call + ".z"});
  // A number within rounding of a boundary between components may fall on its other side, and stretching a short
  // interval magnifies the rounding of the number: almost all draws are the same, not every one.
  std::size_t same = 0;
  for (std::size_t k = 0; k < count; ++k)
    same += std::hypot(got[0][k] - wi[0][k], got[1][k] - wi[1][k], got[2][k] - wi[2][k]) < 1e-4;
  EXPECT_GE(same, count - 8);
}

TEST_F(GlslExport, TwoMaterialsFitIntoOneShader) {
  const auto a = parseMaterialExpression("0.5*GGX(alpha=0.25)"), b = parseMaterialExpression("0.25*GGX(alpha=0.5)");
  ExportOptions first, second;
  first.name = "paint";
  second.name = "metal";
  const auto got = probe().Evaluate(
      exported(a, first) + exported(b, second), {{"z", {1.0f}}},
      {"paint_evaluate(vec3(0.0, 0.0, z), vec3(0.0, 0.0, z))", "metal_evaluate(vec3(0.0, 0.0, z), vec3(0.0, 0.0, z))"});
  // At the normal: D/4 F = 0.04/(4 pi alpha^2).
  EXPECT_NEAR(got[0][0], 0.5 * 0.04 / (4 * kPi * 0.0625), 1e-7);
  EXPECT_NEAR(got[1][0], 0.25 * 0.04 / (4 * kPi * 0.25), 1e-7);
}

TEST_F(GlslExport, PassesTheReferenceCompilerWhereThereIsOne) {
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no glslangValidator";
  const auto material = parseMaterialExpression("(0.25,0.125,0.0625)*Lambertian + 0.5*GGX(alpha=0.25)");
  const auto path = testFolder("glsl") / "export.frag";
  std::ofstream(path) << "#version 330 core\n"
                      << exported(material)
                      << "out vec4 colour;\nvoid main() { colour = vec4(material_evaluate(vec3(0.0, 0.0, 1.0), "
                         "material_sample(vec3(0.0, 0.0, 1.0), vec2(0.5))), 1.0); }\n";
  EXPECT_EQ(std::system(("glslangValidator " + path.string()).c_str()), 0);
}

}  // namespace
}  // namespace brdf
