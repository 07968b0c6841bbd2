#include <brdf/geometry/Frame.h>
#include <brdf/material/ChannelView.h>
#include <brdf/render/PathIntegrator.h>
#include <brdf/sampling/SampledBrdf.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// The frame for shading, on the side that the viewer sees. Interpolated normals can turn away from the viewer at a
/// silhouette: they are tilted back to 89.94 degrees, as shaders/brdf_surface.glsl does.
Frame frameFor(SurfacePoint& point, const Direction& viewer) {
  constexpr double grazing = 1e-3;
  if (dot(point.geometricNormal, viewer) < 0)
    for (std::size_t k = 0; k < 3; ++k) {
      point.geometricNormal[k] = -point.geometricNormal[k];
      point.normal[k] = -point.normal[k];
    }
  if (const double facing = dot(point.normal, viewer); facing < grazing && point.normal != point.geometricNormal) {
    for (std::size_t k = 0; k < 3; ++k) point.normal[k] += (grazing - facing) * viewer[k];
    point.normal = normalized(point.normal);
    const double part = dot(point.tangent, point.normal);
    for (std::size_t k = 0; k < 3; ++k) point.tangent[k] -= part * point.normal[k];
    point.tangent = normalized(point.tangent);
  }
  return {point.tangent, cross(point.normal, point.tangent), point.normal};
}

void addScaled(Rgb& sum, const Rgb& a, const Rgb& b, double factor) {
  for (std::size_t c = 0; c < 3; ++c) sum[c] += a[c] * b[c] * factor;
}

}  // namespace

struct PathIntegrator::Path {
  std::size_t index;  ///< of the camera ray
  Ray ray;
  Rgb throughput{1, 1, 1};
  double density = 0;  ///< that the BRDF drew the ray's direction with; 0: the camera's ray
  SurfacePoint point{};
  Frame frame{};
  Direction wo{};  ///< local
  PathRandom random{};
};

/// Arrays for a batch of pairs of one material, reused.
struct PathIntegrator::Batch {
  DirectionPairBuffer<double> pairs;
  std::vector<double> values, density;
  std::vector<std::uint8_t> valid;
  std::vector<Direction> light;  ///< world directions to the light, or zero
  std::array<std::vector<double>, 2> random;
  const Brdf* brdf = nullptr;
  std::uint64_t evaluations = 0, invalid = 0;

  void resize(std::size_t count) {
    pairs.resize(count);
    values.resize(3 * count);
    density.resize(count);
    valid.resize(count);
    light.resize(count);
    for (auto& numbers : random) numbers.resize(count);
  }
  void evaluate() {
    brdf->evaluate(pairs.view(), values.data(), valid.data());
    evaluations += pairs.size();
    invalid += static_cast<std::uint64_t>(std::ranges::count(valid, std::uint8_t{0}));
  }
  Rgb value(std::size_t k) const { return {values[k], values[pairs.size() + k], values[2 * pairs.size() + k]}; }
};

PathIntegrator::PathIntegrator(const Scene& scene, std::size_t bounces)
    : caster_(scene),
      lights_(scene.lights),
      environmentVisible_(scene.background.kind == SceneBackground::Kind::Environment),
      bounces_(bounces) {
  for (const BrdfPointer& material : scene.materials) materials_.push_back(withSampler(asRgb(material)));
  if (scene.environment) lighting_.emplace(*scene.environment);
}

void PathIntegrator::addLight(const SceneLight& light, std::span<Path> paths, Batch& batch, Rgb* radiance) const {
  const bool near = light.kind == SceneLight::Kind::Point;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    Direction to = light.position;
    if (near)
      for (std::size_t axis = 0; axis < 3; ++axis) to[axis] -= paths[k].point.position[axis];
    batch.density[k] = std::sqrt(dot(to, to));  // the distance, for a point
    batch.light[k] = normalized(to);
    batch.pairs.set(k, paths[k].frame.local(batch.light[k]), paths[k].wo);
  }
  batch.evaluate();
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const double cosine = batch.pairs.wi[2][k], distance = batch.density[k];
    const Rgb value = batch.value(k);
    if (!(cosine > 0) || value == Rgb{} || !(distance > 0)) continue;
    const Ray shadow{caster_.leaving(paths[k].point, batch.light[k]), batch.light[k]};
    if (caster_.blocked(shadow, near ? distance * (1 - 1e-6) : std::numeric_limits<double>::infinity())) continue;
    Rgb reflected{};
    addScaled(reflected, value, light.rgb, cosine / (near ? distance * distance : 1.0));
    addScaled(radiance[paths[k].index], paths[k].throughput, reflected, 1);
  }
}

void PathIntegrator::addEnvironment(std::span<Path> paths, Batch& batch, Rgb* radiance) const {
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const double u = paths[k].random.next(), v = paths[k].random.next();
    batch.light[k] = lighting_->sample(u, v);
    batch.pairs.set(k, paths[k].frame.local(batch.light[k]), paths[k].wo);
  }
  batch.evaluate();
  batch.brdf->pdf(batch.pairs.view(), batch.density.data());
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const double cosine = batch.pairs.wi[2][k];
    const Rgb value = batch.value(k);
    if (!(cosine > 0) || value == Rgb{}) continue;
    const double together = lighting_->pdf(batch.light[k]) + batch.density[k];
    if (!(together > 0) || caster_.blocked({caster_.leaving(paths[k].point, batch.light[k]), batch.light[k]})) continue;
    Rgb reflected{};
    addScaled(reflected, value, lighting_->radiance(batch.light[k]), cosine / together);
    addScaled(radiance[paths[k].index], paths[k].throughput, reflected, 1);
  }
}

/// Each path goes on in a direction that its material draws; a path that ends gets a throughput of 0.
void PathIntegrator::scatter(std::span<Path> paths, Batch& batch) const {
  for (std::size_t k = 0; k < paths.size(); ++k) {
    for (auto& numbers : batch.random) numbers[k] = paths[k].random.next();
    for (std::size_t axis = 0; axis < 3; ++axis) batch.pairs.wo[axis][k] = paths[k].wo[axis];
  }
  auto& wi = batch.pairs.wi;
  const auto view = batch.pairs.view();
  batch.brdf->sample(view.wo, {batch.random[0].data(), batch.random[1].data()},
                     {wi[0].data(), wi[1].data(), wi[2].data()}, paths.size());
  batch.evaluate();
  batch.brdf->pdf(view, batch.density.data());
  for (std::size_t k = 0; k < paths.size(); ++k) {
    Path& path = paths[k];
    const double cosine = wi[2][k], density = batch.density[k];
    const Rgb value = batch.value(k);
    const bool goesOn = cosine > 0 && density > 0 && std::isfinite(density);
    for (std::size_t c = 0; c < 3; ++c) path.throughput[c] *= goesOn ? value[c] * cosine / density : 0.0;
    if (!goesOn) continue;
    path.ray.direction = normalized(path.frame.world({wi[0][k], wi[1][k], wi[2][k]}));
    path.ray.origin = caster_.leaving(path.point, path.ray.direction);
    path.density = density;
  }
}

/// All light that reaches the paths' points, for paths whose points have the same material.
void PathIntegrator::shade(std::span<Path> paths, bool last, Batch& batch, Rgb* radiance) const {
  batch.resize(paths.size());
  for (const SceneLight& light : lights_) addLight(light, paths, batch, radiance);
  if (lighting_) addEnvironment(paths, batch, radiance);
  if (lighting_ || !last)
    scatter(paths, batch);
  else
    for (Path& path : paths) path.throughput = {};
}

void PathIntegrator::trace(std::span<const Ray> rays, std::span<PathRandom> randoms, Rgb* radiance,
                           std::uint8_t* covered, std::uint64_t& evaluations, std::uint64_t& invalid) const {
  constexpr std::size_t kRouletteAfter = 3;
  Batch batch;
  std::vector<Path> paths;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    radiance[k] = {};
    covered[k] = 1;
    Path& path = paths.emplace_back(Path{k, rays[k]});
    path.random = randoms[k];
  }
  for (std::size_t depth = 0; !paths.empty(); ++depth) {
    for (Path& path : paths) {
      if (caster_.meet(path.ray, path.point)) {
        if (depth == bounces_) path.throughput = {};
        const Direction back{-path.ray.direction[0], -path.ray.direction[1], -path.ray.direction[2]};
        path.frame = frameFor(path.point, back);
        path.wo = path.frame.local(back);
        continue;
      }
      if (depth == 0) covered[path.index] = 0;
      if (lighting_ && (depth > 0 || environmentVisible_)) {
        const double share = depth > 0 ? path.density / (path.density + lighting_->pdf(path.ray.direction)) : 1.0;
        addScaled(radiance[path.index], path.throughput, lighting_->radiance(path.ray.direction), share);
      }
      path.throughput = {};
    }
    std::erase_if(paths, [](const Path& path) { return path.throughput == Rgb{}; });
    const auto material = [&](const Path& path) { return caster_.material(path.point.object); };
    std::ranges::stable_sort(paths, {}, material);
    for (std::size_t first = 0; first < paths.size();) {
      std::size_t last = first + 1;
      while (last < paths.size() && material(paths[last]) == material(paths[first])) ++last;
      batch.brdf = materials_[material(paths[first])].get();
      shade(std::span(paths).subspan(first, last - first), depth + 1 == bounces_, batch, radiance);
      first = last;
    }
    if (depth + 1 >= kRouletteAfter)
      for (Path& path : paths) {
        const double survival = std::min(0.95, std::ranges::max(path.throughput));
        const bool survives = path.random.next() < survival;
        for (double& value : path.throughput) value = survives ? value / survival : 0.0;
      }
    std::erase_if(paths, [](const Path& path) { return path.throughput == Rgb{}; });
  }
  evaluations += batch.evaluations;
  invalid += batch.invalid;
}

}  // namespace brdf
