// All ways to draw environment light against the plain sum over all texels: isotropic, anisotropic and retro-reflective
// materials under a smooth map and under one bright texel.
#include "BruteForce.h"
#include "ReferenceSphere.h"

namespace {

using rendertest::BruteForce;
using rendertest::Render;
using rendertest::Rgb;

constexpr int kSize = 12;

}  // namespace

TEST_F(Render, AllWaysToDrawAgreeWithTheSumOverTheMap) {
  render_->SetSize(kSize, kSize);
  render_->SetEnvironment(environment_);
  render_->SetBackground(vtkBRDFRender::BACKGROUND_COLOR);
  render_->SetTolerance(0.01);
  render_->SetMaximumSamples(1024);
  render_->SetNumberOfSamples(1024);
  environment_->SetRotation(200);
  const std::pair<const char*, brdf::EnvironmentMap> maps[] = {{"smooth", rendertest::smoothMap()},
                                                               {"sun", rendertest::sunMap()}};
  for (const auto& [name, map] : maps) {
    environment_->SetMap(map);
    const BruteForce truth(map, 10, 200);
    for (const char* expression :
         {"(0.2,0.1,0.05)*Lambertian + GGX(alpha=0.3, ior=1.5)", "0.1*Lambertian + 0.5*Ward(ax=0.2, ay=0.5)",
          "0.1*Lambertian + Lafortune(Cx=1, Cy=1, Cz=1, n=40)"}) {
      render_->SetMode(vtkBRDFRender::MODE_INTERACTIVE);
      draw(expression);
      vtkNew<vtkImageData> filtered, error;
      filtered->DeepCopy(render_->GetOutput());
      render_->SetMode(vtkBRDFRender::MODE_CONVERGING);
      render_->Update();
      error->DeepCopy(render_->GetStandardError());
      const brdf::ReferencePicture traced = rendertest::referenceSphere(material_, map, kSize);
      double biased = 0, square = 0, converging = 0, tracing = 0, count = 0;
      for (int y = 1; y < kSize; y += 2)
        for (int x = 1; x < kSize; x += 2) {
          const auto hit = this->hit(x, y);
          if (!hit || hit->wo[2] < 0.3) continue;
          const double expected = truth.reflected(*material_, *hit)[1];
          const auto row = static_cast<std::size_t>(kSize - 1 - y), column = static_cast<std::size_t>(x);
          biased += std::pow(double(static_cast<const float*>(filtered->GetScalarPointer(x, y, 0))[1]) - expected, 2);
          square += expected * expected;
          converging += std::pow(
              (pixel(x, y)[1] - expected) / double(static_cast<const float*>(error->GetScalarPointer(x, y, 0))[1]), 2);
          tracing += std::pow((double(traced.radiance.pixel(column, row)[1]) - expected) /
                                  double(traced.standardError.pixel(column, row)[1]),
                              2);
          ++count;
        }
      ASSERT_GT(count, 15);
      const std::string what = std::string(name) + ", " + expression;
      // Squares of Student's t with 7 and with 1023 degrees of freedom.
      EXPECT_LT(converging / count, 1.4 + 4 * 2.8 / std::sqrt(count)) << what;
      EXPECT_LT(tracing / count, 1 + 4 * std::sqrt(2 / count)) << what;
      // Filtering: docs/rendering-accuracy.md says how much for which map.
      EXPECT_LT(std::sqrt(biased / square), std::string(name) == "sun" ? 0.03 : 0.005) << what;
      RecordProperty(what, std::to_string(converging / count) + ' ' + std::to_string(tracing / count) + ' ' +
                               std::to_string(std::sqrt(biased / square)));
    }
  }
}
