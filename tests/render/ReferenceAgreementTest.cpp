// The shaders against the reference renderer of libbrdf.
#include "RenderScene.h"

#include <brdf/render/ReferenceRenderer.h>

namespace {

using brdf::Direction;
using rendertest::Render;

/// What the reference renderer draws of the same sphere through the centres of the pixels.
brdf::ReferencePicture reference(const std::shared_ptr<const brdf::LobeSum>& material, const std::string& map,
                                 double rotation, std::size_t size, std::size_t samples) {
  brdf::Scene scene;
  scene.materials = {material};
  scene.objects.push_back({"sphere", nullptr, {}, 0});
  scene.environment = brdf::SceneEnvironment{
      std::make_shared<const brdf::EnvironmentMap>(brdf::EnvironmentMap::read(map)), rotation, 1};
  scene.camera = brdf::cameraAround({0, 0, 0}, 1, 0, 0, 30, 1);
  scene.width = scene.height = size;
  brdf::ReferenceOptions options;
  options.samples = samples;
  options.pixelCentres = true;
  return brdf::renderReference(scene, options);
}

}  // namespace

TEST_F(Render, AgreesWithTheReferenceRendererUnderMaps) {
  constexpr int size = 28;
  render_->SetSize(size, size);
  render_->SetEnvironment(environment_);
  render_->SetNumberOfSamples(1024);
  environment_->SetRotation(70);
  for (const char* name : {"venice", "studio"}) {
    ASSERT_TRUE(environment_->ReadFile(rendertest::shippedMap(name)));
    for (const char* expression : {"(0.5,0.3,0.2)*Lambertian", "(0.2,0.1,0.05)*Lambertian + GGX(alpha=0.3, ior=1.5)",
                                   "0.5*Ward(ax=0.15, ay=0.4)"}) {
      draw(expression);
      const auto truth = reference(material_, rendertest::shippedMap(name), 70, size, 1024);
      double difference = 0, claimed = 0, square = 0;
      std::size_t count = 0;
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
          const auto hit = this->hit(x, y);
          if (!hit || hit->wo[2] < 0.2) continue;  // the drawn sphere has facets at its silhouette
          const auto rgb = pixel(x, y);
          const auto row = static_cast<std::size_t>(size - 1 - y), column = static_cast<std::size_t>(x);
          for (std::size_t c = 0; c < 3; ++c) {
            const double expected = double(truth.radiance.pixel(column, row)[c]);
            difference += (rgb[c] - expected) * (rgb[c] - expected);
            claimed += std::pow(double(truth.standardError.pixel(column, row)[c]), 2);
            square += expected * expected;
            ++count;
          }
        }
      ASSERT_GT(count, 1000u);
      // What the reference's own noise does not explain: filtering and the shared samples of the shader.
      const double own = std::sqrt(std::max(0.0, difference - claimed) / square);
      // An anisotropic lobe is filtered most: the texels that a sample averages are round, the lobe is not.
      EXPECT_LT(own, material_->symmetry() == brdf::Symmetry::Isotropic ? 0.02 : 0.04) << name << ", " << expression;
    }
  }
}
