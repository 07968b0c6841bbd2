// Converging mode against the plain sum over all texels, and what it says of its own error.
#include "BruteForce.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>

namespace {

using rendertest::BruteForce;
using rendertest::Render;
using rendertest::Rgb;

class Converging : public Render {
 protected:
  static constexpr int kSize = 12;

  void SetUp() override {
    Render::SetUp();
    render_->SetMode(vtkBRDFRender::MODE_CONVERGING);
    render_->SetSize(kSize, kSize);
    render_->SetEnvironment(environment_);
    render_->SetBackground(vtkBRDFRender::BACKGROUND_COLOR);
  }

  double standardError(int x, int y, std::size_t channel) {
    return double(static_cast<const float*>(render_->GetStandardError()->GetScalarPointer(x, y, 0))[channel]);
  }

  /// Pixels whose values are compared: away from the silhouette, where the drawn sphere has facets.
  struct Place {
    int x, y;
    Hit hit;
  };
  std::vector<Place> places(int step) {
    std::vector<Place> result;
    for (int y = 1; y < kSize; y += step)
      for (int x = 1; x < kSize; x += step)
        if (const auto hit = this->hit(x, y); hit && hit->wo[2] > 0.3) result.push_back({x, y, *hit});
    return result;
  }
};

/// Slope of a straight line through points by least squares, and half the width of its 95 % confidence interval.
struct Slope {
  double value, margin;
};
Slope fitted(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = double(x.size());
  double mx = 0, my = 0, xx = 0, xy = 0, rest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mx += x[i] / n;
    my += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mx) * (x[i] - mx);
    xy += (x[i] - mx) * (y[i] - my);
  }
  for (std::size_t i = 0; i < x.size(); ++i) rest += std::pow(y[i] - my - xy / xx * (x[i] - mx), 2);
  constexpr double t = 2.365;  // Student's 97.5 % for the 7 degrees of freedom of 9 points
  return {xy / xx, t * std::sqrt(rest / (n - 2) / xx)};
}

}  // namespace

TEST_F(Converging, IsTheSumOverTheMapWithinItsStandardError) {
  render_->SetEdgeSamples(1);
  render_->SetTolerance(0.01);
  render_->SetMaximumSamples(2048);
  environment_->SetRotation(200);
  const brdf::EnvironmentMap maps[] = {rendertest::smoothMap(), rendertest::sunMap()};
  for (const auto& map : maps) {
    environment_->SetMap(map);
    const BruteForce truth(map, 10, 200);
    for (const char* expression :
         {"(0.5,0.3,0.2)*Lambertian", "(0.2,0.1,0.05)*Lambertian + GGX(alpha=0.3, ior=1.5)",
          "0.5*Ward(ax=0.15, ay=0.4) + 0.01*Lambertian", "0.5*GGX(alpha=(0.2,0.3,0.5), ior=2)"}) {
      draw(expression);
      double score = 0, difference = 0, variance = 0, count = 0;
      for (const auto& [x, y, hit] : places(1)) {
        const Rgb expected = truth.reflected(*material_, hit), found = pixel(x, y);
        // One channel: the three of a pixel share their points.
        const double error = standardError(x, y, 1), off = found[1] - expected[1];
        score += off * off / (error * error);
        difference += off;
        variance += error * error;
        ++count;
      }
      ASSERT_GT(count, 30);
      RecordProperty(std::string(&map == maps ? "smooth " : "sun ") + expression,
                     std::to_string(score / count) + ' ' + std::to_string(difference / std::sqrt(variance)) + ' ' +
                         std::to_string(render_->GetRelativeError()) + ' ' +
                         std::to_string(render_->GetSamplesDrawn()));
      // Student's t of 7 degrees of freedom has the variance 7/5, its square the deviation 2.8.
      EXPECT_NEAR(score / count, 1.4, 4 * 2.8 / std::sqrt(count)) << expression;
      EXPECT_LT(std::abs(difference), 4 * std::sqrt(variance)) << expression;
      EXPECT_LT(render_->GetRelativeError(), 0.1) << expression;
    }
  }
}

TEST_F(Converging, TheStandardErrorIsHonest) {
  render_->SetEdgeSamples(1);
  render_->SetTolerance(0);
  environment_->SetMap(rendertest::smoothMap());
  const BruteForce truth(environment_->GetMap(), 10);
  draw("0.2*Lambertian + GGX(alpha=0.3, ior=1.5)");
  const auto where = places(1);
  std::vector<double> expected;
  for (const auto& place : where) expected.push_back(truth.reflected(*material_, place.hit)[1]);
  for (const int sequence : {vtkBRDFRender::SEQUENCE_RANDOM, vtkBRDFRender::SEQUENCE_LOW_DISCREPANCY}) {
    render_->SetSequence(sequence);
    for (const int samples : {64, 256}) {
      render_->SetMaximumSamples(samples);
      double score = 0, made = 0, claimed = 0, count = 0, together = 0, pairs = 0;
      for (int seed = 0; seed < 4; ++seed) {
        render_->SetSeed(seed);
        render_->Update();
        double before = 0;
        for (std::size_t i = 0; i < where.size(); ++i) {
          const auto& [x, y, hit] = where[i];
          const double error = standardError(x, y, 1), off = pixel(x, y)[1] - expected[i];
          score += off * off / (error * error);
          made += off * off;
          claimed += error * error;
          if (i > 0 && where[i - 1].x == x - 1) {
            together += before * off;
            ++pairs;
          }
          before = off;
          ++count;
        }
      }
      // Neighbours have points of their own: their errors have nothing to do with each other.
      EXPECT_LT(std::abs(together / pairs), 4 / std::sqrt(pairs) * made / count) << sequence << ' ' << samples;
      // Squares of Student's t with 7 degrees of freedom: mean 7/5, deviation 2.8. The ratio of the sums has the
      // deviation sqrt(2 / count + 2 / (7 count)) where all pixels are alike; they are not, so twice that.
      EXPECT_NEAR(score / count, 1.4, 4 * 2.8 / std::sqrt(count)) << sequence << ' ' << samples;
      EXPECT_NEAR(made / claimed, 1, 8 * std::sqrt(16.0 / 7 / count)) << sequence << ' ' << samples;
    }
  }
}

TEST_F(Converging, TheErrorFallsAsTheSequencePredicts) {
  render_->SetEdgeSamples(1);
  render_->SetTolerance(0);
  environment_->SetMap(rendertest::smoothMap());
  const BruteForce truth(environment_->GetMap(), 10);
  draw("0.2*Lambertian + GGX(alpha=0.3, ior=1.5)");
  const auto where = places(1);
  std::vector<double> expected;
  for (const auto& place : where) expected.push_back(truth.reflected(*material_, place.hit)[1]);
  Slope slopes[2];
  for (const int sequence : {vtkBRDFRender::SEQUENCE_RANDOM, vtkBRDFRender::SEQUENCE_LOW_DISCREPANCY}) {
    render_->SetSequence(sequence);
    std::vector<double> points, errors;
    for (int n = 1; n <= 256; n *= 2) {
      render_->SetMaximumSamples(8 * n);
      render_->SetSeed(n);  // nothing in common with the others
      render_->Update();
      ASSERT_EQ(render_->GetSamplesDrawn(), 8 * n);
      double sum = 0;
      for (std::size_t i = 0; i < where.size(); ++i) sum += std::pow(pixel(where[i].x, where[i].y)[1] - expected[i], 2);
      points.push_back(std::log(n));
      errors.push_back(std::log(sum) / 2);
    }
    slopes[sequence] = fitted(points, errors);
    RecordProperty(sequence == vtkBRDFRender::SEQUENCE_RANDOM ? "random" : "low-discrepancy",
                   std::to_string(slopes[sequence].value) + " +- " + std::to_string(slopes[sequence].margin));
  }
  const Slope& random = slopes[vtkBRDFRender::SEQUENCE_RANDOM];
  const Slope& spread = slopes[vtkBRDFRender::SEQUENCE_LOW_DISCREPANCY];
  EXPECT_NEAR(random.value, -0.5, random.margin);
  EXPECT_LT(random.margin, 0.1);
  EXPECT_LT(spread.value + spread.margin, -0.75);
}

TEST_F(Converging, StopsAtTheToleranceAndSaysHowFarItCame) {
  environment_->SetMap(rendertest::smoothMap());
  render_->SetTolerance(0.02);
  draw("GGX(alpha=0.3, ior=1.5)");
  EXPECT_TRUE(render_->GetConverged());
  EXPECT_LE(render_->GetRelativeError(), 0.02);
  const int needed = render_->GetSamplesDrawn();
  EXPECT_EQ(needed % 16, 0);
  // The figure is that of the standard errors of the picture.
  double square = 0, total = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      square += std::pow(standardError(x, y, 0), 2);  // grey: any channel's is the luminance's
      total += pixel(x, y)[0];
    }
  // The map is coloured, so that red's differs from the luminance's, but not by much.
  EXPECT_NEAR(std::sqrt(square) * kSize / total, render_->GetRelativeError(), 0.5 * render_->GetRelativeError());
  auto* array = render_->GetOutput()->GetPointData()->GetArray("standard error");
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->GetComponent(kSize * 6 + 6, 1), standardError(6, 6, 1));

  render_->SetMaximumSamples(needed / 2);
  render_->Update();
  EXPECT_FALSE(render_->GetConverged());
  EXPECT_EQ(render_->GetSamplesDrawn(), needed / 2);
  EXPECT_GT(render_->GetRelativeError(), 0.02);

  render_->SetMode(vtkBRDFRender::MODE_INTERACTIVE);
  render_->Update();
  EXPECT_EQ(render_->GetStandardError()->GetNumberOfPoints(), 0);
  EXPECT_EQ(render_->GetOutput()->GetPointData()->GetArray("standard error"), nullptr);
}

TEST_F(Converging, AbortKeepsThePictureSoFar) {
  environment_->SetMap(rendertest::smoothMap());
  render_->SetTolerance(0);
  render_->SetMaximumSamples(1 << 20);
  int frames = 0;
  double last = -1;
  vtkNew<vtkCallbackCommand> command;
  struct State {
    vtkBRDFRender* render;
    int* frames;
    double* last;
  } state{render_, &frames, &last};
  command->SetClientData(&state);
  command->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
    auto& found = *static_cast<State*>(data);
    EXPECT_GE(found.render->GetProgress(), *found.last);
    *found.last = found.render->GetProgress();
    if (++*found.frames == 30) found.render->SetAbortExecute(1);
  });
  render_->AddObserver(vtkCommand::ProgressEvent, command);
  draw("GGX(alpha=0.3, ior=1.5)");
  EXPECT_GE(frames, 30);
  EXPECT_LT(render_->GetSamplesDrawn(), 1000);
  EXPECT_GT(pixel(6, 6)[0], 0.01);
  EXPECT_GT(standardError(6, 6, 0), 0);
  EXPECT_TRUE(std::isfinite(render_->GetRelativeError()));
}

TEST_F(Converging, SeedsAndModesLeaveEachOtherAlone) {
  environment_->SetMap(rendertest::smoothMap());
  render_->SetTolerance(0);
  render_->SetMaximumSamples(64);
  draw("GGX(alpha=0.3, ior=1.5)");
  const Rgb first = pixel(6, 6);
  render_->SetSeed(1);
  render_->Update();
  EXPECT_NE(pixel(6, 6), first);
  EXPECT_NEAR(pixel(6, 6)[0], first[0], 6 * std::hypot(standardError(6, 6, 0), 0.02 * first[0]));
  const int builds = render_->GetNumberOfShaderBuilds();
  render_->SetSeed(0);
  render_->Update();
  EXPECT_EQ(pixel(6, 6), first) << "the same picture for the same seed";
  EXPECT_EQ(render_->GetNumberOfShaderBuilds(), builds);
}

TEST_F(Converging, TheBackgroundIsTheMapItself) {
  environment_->SetMap(rendertest::sunMap());
  render_->SetBackground(vtkBRDFRender::BACKGROUND_ENVIRONMENT);
  render_->SetEdgeSamples(1);
  render_->SetMaximumSamples(16);
  for (const double rotation : {0.0, 70.0, 140.0, 250.0}) {
    environment_->SetRotation(rotation);
    draw("Lambertian");
    int seen = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        if (hit(x, y)) continue;
        const auto d = ray(x, y);
        Rgb expected;
        environment_->GetRadiance(d.data(), expected.data());
        // Directions in float, to 1e-6 of a texel's 11 degrees, in front of a sun of 1000.
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(pixel(x, y)[c], expected[c], 2e-5 * expected[c] + 5e-3);
        ++seen;
      }
    EXPECT_GT(seen, 30);
  }
}
