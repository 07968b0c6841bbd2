// Every model of the library in a white furnace: the radiance of a pixel is the directional albedo.
#include "RenderScene.h"

#include <brdf/models/Registry.h>
#include <brdf/sampling/DirectionalAlbedo.h>

namespace {

using brdf::DirectionPairs;

/// A material turned by an azimuth about its normal, light and viewer exchanged: its albedo for "light" from theta is
/// what a viewer at theta and that azimuth sees under even light, for materials that are not reciprocal too.
class SeenFrom : public brdf::Brdf {
 public:
  SeenFrom(std::shared_ptr<const brdf::Brdf> material, double phi)
      : material_(std::move(material)), cosine_(std::cos(phi)), sine_(std::sin(phi)) {}
  const brdf::Channels& channels() const override { return material_->channels(); }
  brdf::Symmetry symmetry() const override { return material_->symmetry(); }
  bool reciprocal() const override { return material_->reciprocal(); }
  std::string description() const override { return material_->description(); }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    const Turned wi(*this, pairs.wo, pairs.count), wo(*this, pairs.wi, pairs.count);
    material_->evaluate({wi.view(), wo.view(), pairs.count}, values, valid);
  }
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const override {
    const Turned turned(*this, wo, count);
    material_->sample(turned.view(), u, wi, count);
    for (std::size_t k = 0; k < count; ++k) {
      const double x = wi[0][k], y = wi[1][k];
      wi[0][k] = cosine_ * x + sine_ * y;
      wi[1][k] = cosine_ * y - sine_ * x;
    }
  }
  void pdf(const DirectionPairs<double>& pairs, double* density) const override {
    const Turned wi(*this, pairs.wi, pairs.count), wo(*this, pairs.wo, pairs.count);
    material_->pdf({wi.view(), wo.view(), pairs.count}, density);
  }
  using brdf::Brdf::evaluate;

 private:
  struct Turned {
    std::array<std::vector<double>, 3> values;
    Turned(const SeenFrom& by, const std::array<const double*, 3>& d, std::size_t count) {
      for (auto& axis : values) axis.resize(count);
      for (std::size_t k = 0; k < count; ++k) {
        values[0][k] = by.cosine_ * d[0][k] - by.sine_ * d[1][k];
        values[1][k] = by.sine_ * d[0][k] + by.cosine_ * d[1][k];
        values[2][k] = d[2][k];
      }
    }
    std::array<const double*, 3> view() const { return {values[0].data(), values[1].data(), values[2].data()}; }
  };

  std::shared_ptr<const brdf::Brdf> material_;
  double cosine_, sine_;
};

class WhiteFurnace : public rendertest::Render, public testing::WithParamInterface<std::string> {
 protected:
  static constexpr int kSize = 12;

  void SetUp() override {
    Render::SetUp();
    render_->SetSize(kSize, kSize);
    render_->SetEnvironment(environment_);
    render_->SetBackground(vtkBRDFRender::BACKGROUND_COLOR);
  }

  struct Place {
    int x, y;
    brdf::Albedo albedo;
  };
  std::vector<Place> places() {
    std::vector<Place> result;
    for (int y = 1; y < kSize; y += 3)
      for (int x = 1; x < kSize; x += 2)
        if (const auto hit = this->hit(x, y); hit && hit->wo[2] > 0.25)
          result.push_back({x, y,
                            brdf::directionalAlbedo(SeenFrom(material_, std::atan2(hit->wo[1], hit->wo[0])),
                                                    std::acos(hit->wo[2]), 1024)});
    return result;
  }

  /// Both modes on the material drawn last.
  void check(const std::string& what) {
    render_->SetMode(vtkBRDFRender::MODE_CONVERGING);
    render_->SetTolerance(0.01);
    render_->SetMaximumSamples(256);
    render_->Update();
    const auto where = places();
    ASSERT_GT(where.size(), 10u);
    // Mean and standard error of both modes: the converging one says them, of the other they are those of 8 seeds.
    constexpr int seeds = 8;
    std::vector<double> sum(where.size()), squares(where.size());
    double converging = 0, interactive = 0, noise = 0;
    const auto score = [&](std::size_t i, double mean, double error) {
      // Two thousandths for the drawn sphere's facets and for float, which large exponents raise.
      const brdf::Albedo& albedo = where[i].albedo;
      const double margin = 2e-3 * albedo.value[0] + 1e-12;
      return std::pow(mean - albedo.value[0], 2) / (error * error + std::pow(albedo.error[0], 2) + margin * margin);
    };
    for (std::size_t i = 0; i < where.size(); ++i) {
      const int x = where[i].x, y = where[i].y;
      const double error = double(static_cast<const float*>(render_->GetStandardError()->GetScalarPointer(x, y, 0))[0]);
      converging += score(i, pixel(x, y)[0], error) / double(where.size());
      noise = std::max(noise, error / std::max(where[i].albedo.value[0], 1e-12));
    }
    render_->SetMode(vtkBRDFRender::MODE_INTERACTIVE);
    render_->SetNumberOfSamples(128);
    for (int seed = 0; seed < seeds; ++seed) {
      render_->SetSeed(seed);
      render_->Update();
      for (std::size_t i = 0; i < where.size(); ++i) {
        const double value = pixel(where[i].x, where[i].y)[0];
        sum[i] += value;
        squares[i] += value * value;
      }
    }
    render_->SetSeed(0);
    for (std::size_t i = 0; i < where.size(); ++i) {
      const double mean = sum[i] / seeds, variance = std::max(0.0, squares[i] / seeds - mean * mean) / (seeds - 1);
      interactive += score(i, mean, std::sqrt(variance)) / double(where.size());
    }
    // Squares of Student's t with 7 degrees of freedom: mean 7/5, deviation 2.8.
    const double most = 1.4 + 4 * 2.8 / std::sqrt(double(where.size()));
    EXPECT_LT(converging, most) << what;
    EXPECT_LT(interactive, most) << what;
    EXPECT_LT(noise, 0.1) << what;
    RecordProperty(what, std::to_string(converging) + ' ' + std::to_string(interactive) + ' ' + std::to_string(noise));
  }
};

}  // namespace

TEST_P(WhiteFurnace, ShowsTheDirectionalAlbedo) {
  const brdf::ModelPointer model = brdf::findModel(GetParam());
  // Each model's first parameter in logarithms is its roughness or sharpness, if it has one.
  std::vector<std::string> settings{""};
  for (const brdf::Parameter& parameter : model->parameters())
    if (parameter.scale == brdf::Parameter::Scale::Logarithmic) {
      for (const double value : {parameter.softMinimum, parameter.softMaximum})
        settings.push_back("(" + parameter.name + "=" + std::to_string(value) + ")");
      break;
    }
  for (const std::string& setting : settings) {
    draw(GetParam() + setting);
    check(GetParam() + setting);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryModel, WhiteFurnace, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& model : brdf::allModels()) names.push_back(model->name());
                           return names;
                         }()),
                         [](const auto& entry) { return entry.param; });
