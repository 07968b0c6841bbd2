// Tables and scattered data under environment light against the plain sum over all texels: converging mode, interactive
// mode and the reference renderer, pixel by pixel within their standard errors.
#include "BruteForce.h"
#include "ReferenceSphere.h"
#include "TableCases.h"

namespace {

using brdf::BrdfPointer;
using rendertest::BruteForce;
using rendertest::Render;
using rendertest::Rgb;

constexpr int kSize = 12;

/// Deviations over their standard errors.
struct Scores {
  double squares = 0, sum = 0, variance = 0, count = 0;
  void add(double found, double expected, double error) {
    squares += std::pow((found - expected) / error, 2);
    sum += found - expected;
    variance += error * error;
    ++count;
  }
  double mean() const { return squares / count; }
  /// Of the mean over all pixels.
  double together() const { return std::abs(sum) / std::sqrt(variance); }
};

class TableTruth : public Render, public testing::WithParamInterface<rendertest::TableCase> {
 protected:
  struct Map {
    const char* name;
    brdf::EnvironmentMap map;
  };
  struct Place {
    int x, y;
    Hit hit;
  };

  void SetUp() override {
    Render::SetUp();
    render_->SetSize(kSize, kSize);
    render_->SetEnvironment(environment_);
    render_->SetBackground(vtkBRDFRender::BACKGROUND_COLOR);
    environment_->SetRotation(200);
    brdf_ = GetParam().make();
    drawn_ = rendertest::drawnOf(brdf_);
    vtkNew<vtkBRDF> input;
    input->SetBrdf(brdf_);
    render_->SetInputData(input);
  }

  /// Pixels away from the silhouette, where the drawn sphere has facets.
  std::vector<Place> places() {
    std::vector<Place> result;
    for (int y = 1; y < kSize; y += 2)
      for (int x = 1; x < kSize; x += 2)
        if (const auto hit = this->hit(x, y); hit && hit->wo[2] > 0.3) result.push_back({x, y, *hit});
    return result;
  }

  double standardError(int x, int y) {
    return double(static_cast<const float*>(render_->GetStandardError()->GetScalarPointer(x, y, 0))[1]);
  }

  BrdfPointer brdf_;
  BrdfPointer drawn_;  ///< what the shader looks up
};

std::vector<brdf::EnvironmentMap> maps() {
  return {brdf::EnvironmentMap::constant({1, 1, 1}), rendertest::smoothMap(), rendertest::sunMap()};
}
const char* const kNames[] = {"white furnace", "smooth", "sun"};

// Green only: the three channels of a pixel share their points.

TEST_P(TableTruth, ConvergingModeAndTheReferenceAreTheSumOverTheMapWithinTheirStandardErrors) {
  render_->SetMode(vtkBRDFRender::MODE_CONVERGING);
  render_->SetTolerance(0.01);
  render_->SetMaximumSamples(2048);
  for (std::size_t k = 0; k < 3; ++k) {
    const brdf::EnvironmentMap map = maps()[k];
    environment_->SetMap(map);
    render_->Update();
    ASSERT_EQ(render_->GetErrorText(), "");
    const brdf::ReferencePicture traced = rendertest::referenceSphere(brdf_, map, kSize);
    const BruteForce truth(map, static_cast<int>(640 / map.width()), 200);
    Scores converging, tracing;
    for (const auto& [x, y, hit] : places()) {
      const double exact = truth.reflected(*brdf_, hit)[1];
      const double drawn = drawn_ == brdf_ ? exact : truth.reflected(*drawn_, hit)[1];
      const auto row = static_cast<std::size_t>(kSize - 1 - y), column = static_cast<std::size_t>(x);
      converging.add(pixel(x, y)[1], drawn, standardError(x, y));
      tracing.add(double(traced.radiance.pixel(column, row)[1]), exact,
                  double(traced.standardError.pixel(column, row)[1]));
    }
    ASSERT_GT(converging.count, 15) << kNames[k];
    RecordProperty(kNames[k], std::to_string(converging.mean()) + ' ' + std::to_string(converging.together()) + ' ' +
                                  std::to_string(tracing.mean()) + ' ' + std::to_string(tracing.together()) + ' ' +
                                  std::to_string(render_->GetRelativeError()));
    // Student's t of 7 degrees of freedom has the variance 7/5, its square the deviation 2.8.
    EXPECT_NEAR(converging.mean(), 1.4, 4 * 2.8 / std::sqrt(converging.count)) << kNames[k];
    EXPECT_LT(converging.together(), 4) << kNames[k];
    EXPECT_NEAR(tracing.mean(), 1, 4 * std::sqrt(2 / tracing.count)) << kNames[k];
    EXPECT_LT(tracing.together(), 4) << kNames[k];
    EXPECT_LT(render_->GetRelativeError(), 0.1) << kNames[k];
  }
}

TEST_P(TableTruth, InteractiveModeInTheMeanOfSeedsIsTheSumOverAnEvenAndASmoothMap) {
  constexpr int seeds = 8;
  render_->SetNumberOfSamples(256);
  render_->Update();  // the camera
  const auto where = places();
  for (std::size_t k = 0; k < 2; ++k) {
    const brdf::EnvironmentMap map = maps()[k];
    environment_->SetMap(map);
    const BruteForce truth(map, static_cast<int>(640 / map.width()), 200);
    std::vector<double> sum(where.size()), squares(where.size());
    for (int seed = 0; seed < seeds; ++seed) {
      render_->SetSeed(seed);
      render_->Update();
      ASSERT_EQ(render_->GetErrorText(), "");
      for (std::size_t i = 0; i < where.size(); ++i) {
        const double value = pixel(where[i].x, where[i].y)[1];
        sum[i] += value;
        squares[i] += value * value;
      }
    }
    Scores scores;
    double off = 0, whole = 0;
    for (std::size_t i = 0; i < where.size(); ++i) {
      const double mean = sum[i] / seeds, variance = std::max(0.0, squares[i] / seeds - mean * mean) / (seeds - 1);
      const double expected = truth.reflected(*drawn_, where[i].hit)[1];
      // Two thousandths for facets and float (WhiteFurnaceTest.cpp), and for the interpolation between viewers.
      scores.add(mean, expected, std::sqrt(variance + std::pow(2e-3 * expected, 2)));
      off += mean - expected;
      whole += expected;
    }
    RecordProperty(kNames[k], std::to_string(scores.mean()) + ' ' + std::to_string(scores.together()) + ' ' +
                                  std::to_string(off / whole));
    EXPECT_LT(scores.mean(), 1.4 + 4 * 2.8 / std::sqrt(scores.count)) << kNames[k];
    EXPECT_LT(std::abs(off), 5e-3 * whole) << kNames[k];
  }
}

INSTANTIATE_TEST_SUITE_P(Materials, TableTruth, testing::ValuesIn(rendertest::kTableCases),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
