#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/io/OctahedralMap.h>
#include <brdf/render/RayCaster.h>
#include <brdf/render/ShadowCaster.h>
#include <brdf/sampling/PathRandom.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

namespace brdf {
namespace {

constexpr std::size_t kWordsPerLayer = 4, kBitsPerLayer = 32 * kWordsPerLayer;

}  // namespace

namespace {

/// Directions of an environment by its luminance, cell by cell of the octahedral square.
class CellLight {
 public:
  CellLight(const SceneEnvironment& environment, std::size_t cells)
      : cells_(cells),
        texels_(kMapSize / cells),
        cosine_(std::cos(radians(environment.rotation))),
        sine_(std::sin(radians(environment.rotation))) {
    const OctahedralMap map = environment.map->radianceMap(kMapSize);
    sums_.resize(kMapSize * kMapSize);
    for (std::size_t cell = 0; cell < cells * cells; ++cell) {
      double* sums = sums_.data() + cell * texels_ * texels_;
      double total = 0;
      for (std::size_t k = 0; k < texels_ * texels_; ++k) {
        const auto [column, row] = texel(cell, k);
        const float* rgb = map.texel(0, static_cast<std::ptrdiff_t>(column), static_cast<std::ptrdiff_t>(row));
        const double luminance = 0.2126 * double(rgb[0]) + 0.7152 * double(rgb[1]) + 0.0722 * double(rgb[2]);
        total += luminance * OctahedralMap::solidAngle(kMapSize, column, row);
        sums[k] = total;
      }
      for (std::size_t k = 0; k < texels_ * texels_; ++k)  // a black cell is as good anywhere
        sums[k] = total > 0 ? sums[k] / total : double(k + 1) / double(texels_ * texels_);
    }
  }

  std::size_t cells() const { return cells_; }

  /// A direction of the world in a cell.
  Direction draw(std::size_t cell, PathRandom& random) const {
    const auto first = sums_.begin() + static_cast<std::ptrdiff_t>(cell * texels_ * texels_);
    const auto found =
        std::upper_bound(first, first + static_cast<std::ptrdiff_t>(texels_ * texels_) - 1, random.next());
    const auto [column, row] = texel(cell, static_cast<std::size_t>(found - first));
    const Direction d =
        OctahedralMap::direction((double(column) + random.next()) / kMapSize, (double(row) + random.next()) / kMapSize);
    return {cosine_ * d[0] + sine_ * d[2], d[1], -sine_ * d[0] + cosine_ * d[2]};
  }

 private:
  static constexpr std::size_t kMapSize = 256;  // texels of about a degree

  std::array<std::size_t, 2> texel(std::size_t cell, std::size_t k) const {
    return {cell % cells_ * texels_ + k % texels_, cell / cells_ * texels_ + k / texels_};
  }

  std::size_t cells_, texels_;
  double cosine_, sine_;
  std::vector<double> sums_;  ///< running, cell by cell, up to 1
};

}  // namespace

struct ShadowCaster::Parts {
  RayCaster caster;
  std::vector<SceneLight> lights;
  std::optional<CellLight> light;
};

struct ShadowCaster::Pixel {
  SurfacePoint point;
  std::uint32_t* words;  ///< of its first layer
  PathRandom random;
};

ShadowCaster::ShadowCaster(const Scene& scene, std::size_t cells)
    : parts_(new Parts{RayCaster(scene), scene.lights, {}}) {
  if (scene.lights.size() > 32)
    throw Error(Error::Kind::Value,
                {"too many lights for shadows", "scene", std::to_string(scene.lights.size()), "at most 32"});
  if (cells > 64 || !std::has_single_bit(std::max<std::size_t>(cells, 1)))
    throw Error(Error::Kind::Value,
                {"cells for shadows", "", std::to_string(cells), "a power of two up to 64 a side, or 0"});
  if (scene.environment && cells > 0) parts_->light.emplace(*scene.environment, cells);
}

ShadowCaster::~ShadowCaster() = default;

void ShadowCaster::castLights(Pixel& pixel) const {
  std::uint32_t lit = 0;
  for (std::size_t k = 0; k < parts_->lights.size(); ++k) {
    const SceneLight& light = parts_->lights[k];
    Direction to = light.position;
    double distance = std::numeric_limits<double>::infinity();
    if (light.kind == SceneLight::Kind::Point) {
      for (std::size_t axis = 0; axis < 3; ++axis) to[axis] -= pixel.point.position[axis];
      distance = std::sqrt(dot(to, to)) * (1 - 1e-6);
    }
    to = normalized(to);
    const bool facing = dot(to, pixel.point.normal) > 0;
    if (facing && !parts_->caster.blocked({parts_->caster.leaving(pixel.point, to), to}, distance))
      lit |= std::uint32_t{1} << k;
  }
  pixel.words[0] = lit;
}

void ShadowCaster::castEnvironment(Pixel& pixel, std::size_t stride) const {
  constexpr int tries = 4;  // to find a direction that faces the surface in a cell that its horizon cuts
  const CellLight& light = *parts_->light;
  for (std::size_t cell = 0; cell < light.cells() * light.cells(); ++cell) {
    Direction to{};
    bool facing = false;
    for (int attempt = 0; attempt < tries && !facing; ++attempt) {
      to = light.draw(cell, pixel.random);
      facing = dot(to, pixel.point.normal) > 0;
    }
    std::uint32_t& word = pixel.words[(1 + cell / kBitsPerLayer) * stride + cell / 32 % kWordsPerLayer];
    const std::uint32_t bit = std::uint32_t{1} << cell % 32;
    const bool seen = facing && !parts_->caster.blocked({parts_->caster.leaving(pixel.point, to), to});
    word = seen ? word | bit : word & ~bit;
  }
}

void ShadowCaster::cast(const ShadowOptions& options, ShadowMask& mask) const {
  const std::size_t pixels = options.width * options.height, cells = parts_->light ? parts_->light->cells() : 0;
  const std::size_t layers = 1 + (cells * cells + kBitsPerLayer - 1) / kBitsPerLayer;
  if (mask.width != options.width || mask.height != options.height || mask.cells != cells) {
    mask.width = options.width;
    mask.height = options.height;
    mask.cells = cells;
    mask.layers = layers;
    mask.words.assign(layers * pixels * kWordsPerLayer, ~std::uint32_t{0});
  }
  const std::size_t stride = pixels * kWordsPerLayer;
  parallelFor(pixels, 256, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      if (options.wanted && (*options.wanted)[k] == 0) continue;
      const Ray ray = options.through(double(k % options.width) + 0.5, double(k / options.width) + 0.5);
      Pixel pixel{{}, mask.words.data() + k * kWordsPerLayer, PathRandom(options.seed << 32 | k)};
      if (!parts_->caster.meet(ray, pixel.point)) {
        for (std::size_t layer = 0; layer < layers; ++layer)
          std::fill_n(pixel.words + layer * stride, kWordsPerLayer, ~std::uint32_t{0});
        continue;
      }
      if (dot(pixel.point.geometricNormal, ray.direction) > 0)  // seen from behind
        for (std::size_t axis = 0; axis < 3; ++axis) {
          pixel.point.normal[axis] = -pixel.point.normal[axis];
          pixel.point.geometricNormal[axis] = -pixel.point.geometricNormal[axis];
        }
      castLights(pixel);
      if (cells > 0) castEnvironment(pixel, stride);
    }
  });
}

}  // namespace brdf
