// Tables in GLSL: look-ups against the processor's in double, importance tables against brdf::TabulatedSampler, at the
// same rounded directions.
#include "ProbeSupport.h"

#include <brdf/check/Cases.h>
#include <brdf/formula/GlslPrinter.h>
#include <brdf/material/GridShader.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/sampling/DrawnTable.h>
#include <brdf/sampling/SamplerChecks.h>
#include <brdf/sampling/TabulatedSampler.h>
#include <vtkBRDFShaderText.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../sampling/FunctionBrdf.h"

namespace brdf {
namespace {

using Q = AxisQuantity;

GridLayout spherical(std::vector<GridAxis> axes, GridSymmetry symmetry = {}) {
  return {Parametrisation::Spherical, std::move(axes), symmetry};
}

struct LayoutCase {
  const char* name;
  GridLayout layout;
  GridBrdf::Lookup lookup = GridBrdf::Lookup::Interpolated;
};

/// Every parametrisation, scale, kind of centring, symmetry and number of axes.
std::vector<LayoutCase> layouts() {
  const double half = kPi / 2;
  GridAxis bounded = GridAxis::listedDegrees(Q::ThetaO, {0, 5, 12, 30, 31, 70});
  bounded.outside = Outside::Invalid;
  GridLayout transmitted{Parametrisation::Specular,
                         {GridAxis::listedDegrees(Q::ThetaI, {0, 20, 50, 80}),
                          GridAxis::uniformNodes(Q::SpecularTheta, 0, kPi, 15, AxisScale::SquareRoot),
                          GridAxis::uniformNodes(Q::SpecularPhi, 0, kPi, 7)},
                         {.mirror = true}};
  transmitted.specularOffsets = {0, 0.02, 0.1, 0.05};
  return {
      {"Merl", GridLayout::fromTable({18, 10, 12, true})},
      {"MerlNotReciprocal", GridLayout::fromTable({24, 10, 12, false})},
      {"MerlNearest", GridLayout::fromTable({18, 10, 12, true}), GridBrdf::Lookup::Nearest},
      {"AnisotropicHalf",
       {Parametrisation::HalfDifference,
        {GridAxis::uniformCells(Q::ThetaH, 0, half, 8, AxisScale::SquareRoot),
         GridAxis::uniformCells(Q::PhiH, 0, kPi, 6), GridAxis::uniformCells(Q::ThetaD, 0, half, 5),
         GridAxis::uniformCells(Q::PhiD, 0, kPi, 6).periodic(kPi)},
        {.mirror = true, .reciprocal = true}}},
      {"Utia", spherical({GridAxis::uniformNodes(Q::PhiO, 0, 2 * kPi * 11 / 12, 12).periodic(),
                          GridAxis::uniformNodes(Q::ThetaO, 0, radians(75), 6),
                          GridAxis::uniformNodes(Q::PhiI, 0, 2 * kPi * 11 / 12, 12).periodic(),
                          GridAxis::uniformNodes(Q::ThetaI, 0, radians(75), 6)})},
      {"Mirrored", spherical({GridAxis::uniformNodes(Q::ThetaI, 0, half, 7, AxisScale::Cosine), bounded,
                              GridAxis::listedDegrees(Q::PhiDifference, {0, 10, 90, 170, 180})},
                             {.mirror = true})},
      {"Reciprocal", spherical({GridAxis::uniformNodes(Q::ThetaO, 0, half, 9, AxisScale::Sine),
                                GridAxis::uniformNodes(Q::ThetaI, 0, half, 9),
                                GridAxis::uniformCells(Q::PhiDifference, 0, 2 * kPi, 10).periodic()},
                               {.reciprocal = true})},
      {"Transmitted", transmitted},
      {"OneAxis", {Parametrisation::HalfDifference, {GridAxis::listedDegrees(Q::ThetaH, {0, 1, 3, 10, 90})}}},
      {"OneCell", {Parametrisation::HalfDifference, {GridAxis::listedDegrees(Q::ThetaH, {0})}}},
  };
}

/// Noise in every cell, one in ten invalid, three channels.
std::shared_ptr<const GridBrdf> noise(const LayoutCase& test) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  GridData data{test.layout, Channels::rgb(), {}, {}};
  const std::size_t cells = test.layout.cells();
  for (std::size_t i = 0; i < 3 * cells; ++i) data.values.push_back(uniform(random));
  for (std::size_t i = 0; i < cells; ++i)
    data.states.push_back(cells > 1 && uniform(random) < 0.6 ? stateByte(CellState::Invalid)
                                                             : stateByte(CellState::Measured));
  return std::make_shared<const GridBrdf>(std::move(data), test.name, test.lookup);
}

std::vector<vtkBRDFShaderProbe::Column> columnsOf(const CheckPairs& set) {
  const DirectionPairBuffer<float> narrow = set.narrow();
  const char* const names[] = {"ix", "iy", "iz", "ox", "oy", "oz"};
  std::vector<vtkBRDFShaderProbe::Column> columns;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns.push_back({names[axis], narrow.wi[axis]});
    columns.push_back({names[3 + axis], narrow.wo[axis]});
  }
  return columns;
}

/// What a function of a pair, computed in double, is there, and over what range it varies within a few float roundings
/// of the directions: near poles the azimuths are rounding noise, and cells end somewhere.
struct Expected {
  std::vector<double> lowest, highest;
};
template <class Function>
Expected expectedOf(const CheckPairs& set, std::size_t channels, const Function& function) {
  constexpr double step = 4e-7;
  Expected result{std::vector<double>(channels * set.size(), 1e300),
                  std::vector<double>(channels * set.size(), -1e300)};
  std::vector<double> values(channels * set.size());
  std::mt19937 random(2);
  for (int move = 0; move < 25; ++move) {
    DirectionPairBuffer<double> pairs = set.pairs;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (auto* side : {&pairs.wi[axis], &pairs.wo[axis]})
        for (double& number : *side)
          number += move == 0 ? 0 : step * (static_cast<double>(random() % 3) - 1) * std::max(std::abs(number), 0.02);
    function(pairs.view(), values.data());
    for (std::size_t k = 0; k < values.size(); ++k) {
      result.lowest[k] = std::min(result.lowest[k], values[k]);
      result.highest[k] = std::max(result.highest[k], values[k]);
    }
  }
  return result;
}

class TableGlsl : public test::GlslTest, public testing::WithParamInterface<LayoutCase> {};

TEST_P(TableGlsl, LooksUpWhatTheProcessorDoes) {
  const auto grid = noise(GetParam());
  const GridShader shader = gridShader(*grid, "table");
  EXPECT_LE(shader.texels.size() / 4, gridShaderTexels(grid->layout()));
  const CheckPairs set = adversarialPairs(400, 51, false).rounded();
  const std::string call = "table(vec3(ix, iy, iz), vec3(ox, oy, oz))";
  const auto got = probe().Evaluate(formula::glslPrelude() + shader.glsl, columnsOf(set),
                                    {call + ".r", call + ".g", call + ".b"}, {{"table_cells", shader.texels}});
  const Expected expected =
      expectedOf(set, 3, [&](const auto& pairs, double* values) { grid->evaluate(pairs, values, nullptr); });
  std::size_t sharp = 0, zeros = 0;
  for (std::size_t k = 0; k < set.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = c * set.size() + k;
      ASSERT_GE(got[c][k], expected.lowest[at] - 3e-4) << directionText(set.wi(k), set.wo(k));
      ASSERT_LE(got[c][k], expected.highest[at] + 3e-4) << directionText(set.wi(k), set.wo(k));
      sharp += expected.highest[at] - expected.lowest[at] < 1e-3;
      zeros += got[c][k] == 0;
    }
  EXPECT_GT(sharp, set.size());  // at most pairs the range is a point
  EXPECT_LT(zeros, 3 * set.size() * 3 / 4);
}

TEST_P(TableGlsl, DrawnCellsAverageToTheLookUp) {
  // Without invalid cells, which only the look-up leaves out.
  GridData data = noise(GetParam())->data();
  data.states.clear();
  const GridBrdf grid(std::move(data), "test", GetParam().lookup);
  const GridShader shader = gridShader(grid, "table");
  constexpr std::size_t draws = 4000;
  std::mt19937 random(6);
  std::uniform_real_distribution<float> uniform(0, 1);
  const CheckPairs all = adversarialPairs(1, 53, false).rounded();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Direction wi = all.wi(k), wo = all.wo(k);
    std::vector<vtkBRDFShaderProbe::Column> columns;
    const double numbers[] = {wi[0], wi[1], wi[2], wo[0], wo[1], wo[2]};
    for (std::size_t c = 0; c < 6; ++c)
      columns.push_back({std::string("ix iy iz ox oy oz").substr(3 * c, 2),
                         std::vector<float>(draws, static_cast<float>(numbers[c]))});
    for (const char* name : {"u0", "u1", "u2", "u3"}) {
      columns.push_back({name, {}});
      for (std::size_t i = 0; i < draws; ++i)
        columns.back().Values.push_back(std::min(uniform(random), 0x1.fffffep-1f));
    }
    const auto got = probe().Evaluate(formula::glslPrelude() + shader.glsl, columns,
                                      {"table_drawn(vec3(ix, iy, iz), vec3(ox, oy, oz), vec4(u0, u1, u2, u3)).r",
                                       "table(vec3(ix, iy, iz), vec3(ox, oy, oz)).r"},
                                      {{"table_cells", shader.texels}});
    double sum = 0, squares = 0;
    for (const float value : got[0]) sum += double(value), squares += double(value) * double(value);
    const double mean = sum / draws, deviation = std::sqrt(std::max(0.0, squares / draws - mean * mean) / draws);
    // Coarse angles may draw the neighbours of the cells that the look-up mixes only where azimuths mean nothing.
    if (std::hypot(wi[0] + wo[0], wi[1] + wo[1]) < 1e-2 || std::hypot(wi[0] - wo[0], wi[1] - wo[1]) < 1e-2) continue;
    EXPECT_NEAR(mean, double(got[1][0]), 5 * deviation + 2e-3) << directionText(wi, wo);
  }
}

INSTANTIATE_TEST_SUITE_P(Layouts, TableGlsl, testing::ValuesIn(layouts()),
                         [](const auto& test) { return std::string(test.param.name); });

/// The text of a table's shader with its uniforms as constants, for the probe.
struct SamplerShader {
  std::string glsl;
  std::vector<vtkBRDFShaderProbe::Buffer> buffers;
};
SamplerShader shaderOf(const BrdfPointer& grid, const TabulatedSampler& sampler) {
  const vtkBRDFShaderText text(drawnTable(grid), sampler);
  SamplerShader shader{text.Text(vtkBRDFShaderText::Environment::None), {}};
  const std::vector<int>& shapes = text.SamplerShapes();
  std::string list;
  for (const int number : shapes) list += (list.empty() ? "" : ", ") + std::to_string(number);
  const std::string declaration = "uniform int brdfSamplerShapes[4];";
  const std::size_t at = shader.glsl.find(declaration);
  if (at == std::string::npos) return shader;
  shader.glsl.replace(at, declaration.size(), "const int brdfSamplerShapes[4] = int[4](" + list + ");");
  for (const auto& buffer : text.Buffers()) shader.buffers.push_back({buffer.Name, buffer.Texels});
  return shader;
}

struct SamplerCase {
  const char* name;
  BrdfPointer (*make)();
  TabulatedSampler::Kind kind;
};

const SamplerCase kSamplerCases[] = {
    {"Glossy",
     [] { return BrdfPointer(TableBrdf::tabulate(*parseMaterialExpression("0.3*Lambertian + 0.5*GGX(alpha=0.1)"))); },
     TabulatedSampler::Kind::Half},
    {"Sharp", [] { return BrdfPointer(parseMaterialExpression("GGX(alpha=0.01)")); }, TabulatedSampler::Kind::Half},
    {"Retro", [] { return BrdfPointer(std::make_shared<test::FunctionBrdf>(test::retroReflector())); },
     TabulatedSampler::Kind::HalfAndRetro},
    {"Broad", [] { return BrdfPointer(parseMaterialExpression("OrenNayar")); }, TabulatedSampler::Kind::Light},
    {"Brushed", [] { return BrdfPointer(std::make_shared<test::FunctionBrdf>(test::brushed())); },
     TabulatedSampler::Kind::Half},
};

class SamplerGlsl : public test::GlslTest, public testing::WithParamInterface<SamplerCase> {
 protected:
  void SetUp() override {
    test::GlslTest::SetUp();
    if (IsSkipped()) return;
    const BrdfPointer brdf = GetParam().make();
    sampler_ = std::make_unique<TabulatedSampler>(*brdf, GetParam().kind);
    // The table itself does not matter here.
    shader_ = shaderOf(
        GridBrdf::tabulate(*brdf, {Parametrisation::HalfDifference, {GridAxis::listedDegrees(Q::ThetaH, {0, 45, 90})}}),
        *sampler_);
  }

  std::unique_ptr<TabulatedSampler> sampler_;
  SamplerShader shader_;
};

TEST_P(SamplerGlsl, HasTheDensityOfTheProcessor) {
  const CheckPairs set = adversarialPairs(300, 52, false).rounded();
  const auto got = probe().Evaluate(shader_.glsl, columnsOf(set), {"brdfTerm0_pdf(vec3(ix, iy, iz), vec3(ox, oy, oz))"},
                                    shader_.buffers)[0];
  const Expected expected =
      expectedOf(set, 1, [&](const auto& pairs, double* values) { sampler_->pdf(pairs, values); });
  std::size_t sharp = 0, coarse = 0;
  for (std::size_t k = 0; k < set.size(); ++k) {
    // Shares are differences of floats up to 1: of a cell of share 1e-5 they keep two to three digits, and 6e-8 may
    // move from one cell to the next.
    ASSERT_GE(got[k], expected.lowest[k] * (1 - 2e-2) - 2e-7) << directionText(set.wi(k), set.wo(k));
    ASSERT_LE(got[k], expected.highest[k] * (1 + 2e-2) + 2e-7) << directionText(set.wi(k), set.wo(k));
    coarse += got[k] < expected.lowest[k] * (1 - 1e-3) - 2e-7 || got[k] > expected.highest[k] * (1 + 1e-3) + 2e-7;
    sharp += expected.highest[k] - expected.lowest[k] < 2e-3 * expected.highest[k];
  }
  EXPECT_GT(sharp, set.size() / 2);
  EXPECT_LT(coarse, set.size() / 100);
}

TEST_P(SamplerGlsl, DrawsAsTheProcessorsDensitySays) {
  const DirectionSampler sampler{
      [&](const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
          const std::array<double*, 3>& wi, std::size_t count) {
        std::vector<vtkBRDFShaderProbe::Column> columns;
        const char* const names[] = {"ox", "oy", "oz", "u", "v"};
        for (std::size_t k = 0; k < 5; ++k) {
          const double* from = k < 3 ? wo[k] : u[k - 3];
          auto& column = columns.emplace_back(vtkBRDFShaderProbe::Column{names[k], {}});
          for (std::size_t i = 0; i < count; ++i)
            column.Values.push_back(k < 3 ? static_cast<float>(from[i])
                                          : std::min(static_cast<float>(from[i]), 0x1.fffffep-1f));
        }
        const std::string call = "brdfTerm0_sample(vec3(ox, oy, oz), vec2(u, v))";
        const auto got =
            probe().Evaluate(shader_.glsl, columns, {call + ".x", call + ".y", call + ".z"}, shader_.buffers);
        for (std::size_t i = 0; i < count; ++i) {
          Direction d{got[0][i], got[1][i], got[2][i]};
          if (d[2] > 0) d = normalized(d);  // unit in double
          for (std::size_t axis = 0; axis < 3; ++axis) wi[axis][i] = d[axis];
        }
      },
      [&](const DirectionPairs<double>& pairs, double* density) { sampler_->pdf(pairs, density); }};
  for (const double angle : {0.0, 40.0, 80.0}) {
    const SamplerTest test = testSampler(sampler, fromSpherical(radians(angle), 0.7));
    EXPECT_GT(test.chiSquare.probability, sidakSignificance(1e-3, 15)) << angle;
    EXPECT_LT(std::fabs(test.deviation), 5) << angle << ": integral " << test.integral << ", failed " << test.failed;
    EXPECT_EQ(test.bad, 0u);
    EXPECT_EQ(test.uncovered, 0u);
  }
}

TEST_P(SamplerGlsl, WarpsDrawEveryDirectionWithItsSolidAngle) {
  // The mean of cos(theta) times the solid angle that a draw stands for is the integral of the cosine over the
  // hemisphere, whatever the density: it fails where directions are left out or charts overlap unweighted.
  const std::string text = shader_.glsl +
                           "float weight(vec3 wo, vec2 u)\n{\n  float solid;\n"
                           "  vec3 wi = brdfTerm0_warped(brdfTerm0_warps(wo), u, solid);\n"
                           "  return wi.z > 0.0 ? solid * wi.z : 0.0;\n}\n";
  constexpr std::size_t draws = 1 << 18;
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (const double angle : {0.0, 25.0, 60.0, 85.0}) {
    const Direction wo = fromSpherical(radians(angle), 0.7);
    std::vector<vtkBRDFShaderProbe::Column> columns;
    for (std::size_t axis = 0; axis < 3; ++axis)
      columns.push_back({std::string("o") + "xyz"[axis], std::vector<float>(draws, static_cast<float>(wo[axis]))});
    for (const char* name : {"u", "v"}) {
      columns.push_back({name, {}});
      for (std::size_t i = 0; i < draws; ++i)
        columns.back().Values.push_back(std::min(uniform(random), 0x1.fffffep-1f));
    }
    const auto got = probe().Evaluate(text, columns, {"weight(vec3(ox, oy, oz), vec2(u, v))"}, shader_.buffers)[0];
    double sum = 0, squares = 0;
    for (const float value : got) sum += double(value), squares += double(value) * double(value);
    const double mean = sum / draws, deviation = std::sqrt((squares / draws - mean * mean) / draws);
    EXPECT_NEAR(mean, kPi, 5 * deviation) << angle;
    EXPECT_LT(deviation, 0.03 * kPi) << angle;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SamplerGlsl, testing::ValuesIn(kSamplerCases),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace brdf
