#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/io/EnvironmentMap.h>
#include <brdf/io/ImageFile.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

namespace brdf {
namespace {

double texelSolidAngle(const Image& picture, std::size_t row) {
  const double step = kPi / static_cast<double>(picture.height), top = step * static_cast<double>(row);
  // cos(top) - cos(top + step), without cancellation.
  return 2 * std::sin(top + step / 2) * std::sin(step / 2) * 2 * kPi / static_cast<double>(picture.width);
}

Direction texelDirection(const Image& picture, double column, double row) {
  const double phi = (column / static_cast<double>(picture.width) - 0.5) * 2 * kPi;
  const double theta = row / static_cast<double>(picture.height) * kPi;
  return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

/// Bilinear interpolation at texture coordinates u, v in [0, 1]; across a pole the opposite meridian continues.
void interpolate(const Image& picture, double u, double v, double* rgb) {
  const auto width = static_cast<std::ptrdiff_t>(picture.width), height = static_cast<std::ptrdiff_t>(picture.height);
  const double x = u * static_cast<double>(width) - 0.5, y = v * static_cast<double>(height) - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  std::fill_n(rgb, 3, 0.0);
  for (int corner = 0; corner < 4; ++corner) {
    auto column = static_cast<std::ptrdiff_t>(left) + corner % 2, row = static_cast<std::ptrdiff_t>(top) + corner / 2;
    if (row < 0 || row >= height) {
      row = row < 0 ? 0 : height - 1;
      column += width / 2;
    }
    column = (column % width + width) % width;
    const double weight = (corner % 2 ? x - left : 1 - (x - left)) * (corner / 2 ? y - top : 1 - (y - top));
    const float* texel = picture.pixel(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
    for (std::size_t channel = 0; channel < 3; ++channel) rgb[channel] += weight * double(texel[channel]);
  }
}

void interpolateToward(const Image& picture, const Direction& d, double* rgb) {
  const double v = std::acos(std::clamp(d[1], -1.0, 1.0)) / kPi;
  interpolate(picture, 0.5 + std::atan2(d[0], -d[2]) / (2 * kPi), v, rgb);
}

/// Bilinear interpolation in an angular map between those of the four nearest pixels whose centres lie in the circle.
void interpolateAngular(const Image& picture, const Direction& d, float* rgb) {
  const auto side = static_cast<std::ptrdiff_t>(picture.width);
  const double across = std::hypot(d[0], d[1]), half = double(side) / 2;
  const double r = std::atan2(across, d[2]) / kPi;  // acos(d.z) / pi
  const double u = across > 0 ? r * d[0] / across : r, v = across > 0 ? r * d[1] / across : 0;
  const double x = half * (1 + u) - 0.5, y = half * (1 - v) - 0.5, left = std::floor(x), top = std::floor(y);
  double sum[3] = {}, weights = 0;
  const auto add = [&](std::ptrdiff_t column, std::ptrdiff_t row, double weight) {
    const float* texel = picture.pixel(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * double(texel[picture.channels == 1 ? 0 : c]);
    weights += weight;
  };
  for (int corner = 0; corner < 4; ++corner) {
    const auto column = static_cast<std::ptrdiff_t>(left) + corner % 2,
               row = static_cast<std::ptrdiff_t>(top) + corner / 2;
    if (column < 0 || row < 0 || column >= side || row >= side) continue;
    if (std::hypot(double(column) + 0.5 - half, double(row) + 0.5 - half) > half) continue;
    add(column, row, (corner % 2 ? x - left : 1 - (x - left)) * (corner / 2 ? y - top : 1 - (y - top)));
  }
  if (!(weights > 0)) {  // at the rim: a pixel further in
    const double inner = std::max(0.0, 1 - 1.5 / half) / std::max(r, 1e-30);
    const auto at = [&](double place) {
      return std::clamp(static_cast<std::ptrdiff_t>(half * (1 + inner * place)), std::ptrdiff_t{0}, side - 1);
    };
    add(at(u), at(-v), 1);
  }
  for (std::size_t c = 0; c < 3; ++c) rgb[c] = static_cast<float>(sum[c] / weights);
}

std::string sizeText(const Image& picture) {
  return std::to_string(picture.width) + " x " + std::to_string(picture.height);
}

/// Half the width and height, means weighted by solid angle. Both sides are even.
Image halved(const Image& fine) {
  Image coarse(fine.width / 2, fine.height / 2, 3);
  for (std::size_t y = 0; y < coarse.height; ++y) {
    const double upper = texelSolidAngle(fine, 2 * y), lower = texelSolidAngle(fine, 2 * y + 1);
    const double share[2] = {upper / (upper + lower) / 2, lower / (upper + lower) / 2};
    for (std::size_t x = 0; x < coarse.width; ++x) {
      float* out = coarse.pixel(x, y);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        double sum = 0;
        for (std::size_t child = 0; child < 4; ++child)
          sum += share[child / 2] * double(fine.pixel(2 * x + child % 2, 2 * y + child / 2)[channel]);
        out[channel] = static_cast<float>(sum);
      }
    }
  }
  return coarse;
}

/// Flux by direction, the picture summed over blocks: for each block and channel the vector sum of
/// radiance * solid angle * direction. The cosine with a normal above whose horizon the block lies is then exact,
/// however the light is spread in it; only blocks across the horizon are approximate.
std::vector<std::array<float, 9>> blockFluxes(const Image& picture) {
  constexpr std::size_t blocksAround = 128;  // 2.8 degrees a block
  const std::size_t side = std::max<std::size_t>(1, picture.width / blocksAround);
  const std::size_t across = (picture.width + side - 1) / side, down = (picture.height + side - 1) / side;
  std::vector<std::array<float, 9>> fluxes(across * down);
  parallelFor(down, 4, [&](std::size_t first, std::size_t last) {
    std::vector<std::array<double, 9>> sums;
    for (std::size_t block = first; block < last; ++block) {
      sums.assign(across, {});
      for (std::size_t y = block * side; y < std::min(picture.height, (block + 1) * side); ++y) {
        const double angle = texelSolidAngle(picture, y);
        for (std::size_t x = 0; x < picture.width; ++x) {
          const Direction d = texelDirection(picture, double(x) + 0.5, double(y) + 0.5);
          for (std::size_t channel = 0; channel < 3; ++channel)
            for (std::size_t axis = 0; axis < 3; ++axis)
              sums[x / side][3 * channel + axis] += double(picture.pixel(x, y)[channel]) * angle * d[axis];
        }
      }
      for (std::size_t x = 0; x < across; ++x)
        std::transform(sums[x].begin(), sums[x].end(), fluxes[block * across + x].begin(),
                       [](double value) { return static_cast<float>(value); });
    }
  });
  return fluxes;
}

}  // namespace

EnvironmentMap::EnvironmentMap(const Image& picture) {
  if (picture.height == 0 || picture.width != 2 * picture.height)
    throw Error(Error::Kind::Value,
                {"not an equirectangular environment map",
                 {},
                 sizeText(picture),
                 picture.width == picture.height
                     ? "twice as wide as high; a square one may be an angular map (a light probe): say so, with "
                       "angular:FILE or in a scene \"mapping\": \"angular\""
                     : "twice as wide as high"});
  picture_ = Image(picture.width, picture.height, 3);
  for (std::size_t pixel = 0; pixel < picture.width * picture.height; ++pixel) {
    const float* from = picture.values.data() + pixel * picture.channels;
    bool finite = true, negative = false;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const float value = from[picture.channels == 1 ? 0 : channel];
      finite = finite && std::isfinite(value);
      negative = negative || value < 0;
      picture_.values[3 * pixel + channel] = std::isfinite(value) && value > 0 ? value : 0;
    }
    defects_.notFinite += !finite;
    defects_.negative += negative;
  }
}

EnvironmentMap EnvironmentMap::constant(const Rgb& radiance) {
  Image picture(128, 64, 3);  // fine enough for the cosine at its texels
  for (std::size_t index = 0; index < picture.values.size(); ++index)
    picture.values[index] = static_cast<float>(radiance[index % 3]);
  return EnvironmentMap(picture);
}

EnvironmentMap::Mapping EnvironmentMap::mapping(std::string_view name) {
  if (name == "equirectangular") return Mapping::Equirectangular;
  if (name == "angular") return Mapping::Angular;
  throw Error(Error::Kind::Value, {"unknown mapping", {}, "\"" + std::string(name) + "\"", "equirectangular, angular"});
}

EnvironmentMap EnvironmentMap::fromAngular(const Image& picture) {
  if (picture.height == 0 || picture.width != picture.height)
    throw Error(Error::Kind::Value, {"not an angular map", {}, sizeText(picture), "as wide as high"});
  Image resampled(2 * picture.height, picture.height, 3);
  parallelFor(resampled.height, 8, [&](std::size_t first, std::size_t last) {
    for (std::size_t y = first; y < last; ++y)
      for (std::size_t x = 0; x < resampled.width; ++x)
        interpolateAngular(picture, texelDirection(resampled, double(x) + 0.5, double(y) + 0.5), resampled.pixel(x, y));
  });
  return EnvironmentMap(resampled);
}

EnvironmentMap EnvironmentMap::read(const std::filesystem::path& path, Mapping mapping) try {
  return mapping == Mapping::Angular ? fromAngular(readImage(path)) : EnvironmentMap(readImage(path));
} catch (const Error& error) {
  if (!error.details().where.empty()) throw;
  Error::Details details = error.details();
  details.where = path.string();
  throw Error(error.kind(), std::move(details));
}

EnvironmentMap::Rgb EnvironmentMap::radiance(const Direction& direction) const {
  Rgb rgb;
  interpolateToward(picture_, direction, rgb.data());
  return rgb;
}

Direction EnvironmentMap::direction(std::size_t column, std::size_t row) const {
  return texelDirection(picture_, double(column) + 0.5, double(row) + 0.5);
}

double EnvironmentMap::solidAngle(std::size_t row) const { return texelSolidAngle(picture_, row); }

EnvironmentMap::Rgb EnvironmentMap::totalPower() const {
  Rgb power{};
  for (std::size_t row = 0; row < height(); ++row)
    for (std::size_t column = 0; column < width(); ++column)
      for (std::size_t channel = 0; channel < 3; ++channel)
        power[channel] += solidAngle(row) * double(picture_.pixel(column, row)[channel]);
  return power;
}

EnvironmentMap::Rgb EnvironmentMap::irradiance(const Direction& normal) const {
  Rgb sum{};
  for (std::size_t row = 0; row < height(); ++row) {
    const double angle = solidAngle(row);
    for (std::size_t column = 0; column < width(); ++column) {
      const double weight = angle * std::max(0.0, dot(normal, direction(column, row)));
      for (std::size_t channel = 0; channel < 3; ++channel)
        sum[channel] += weight * double(picture_.pixel(column, row)[channel]);
    }
  }
  return sum;
}

std::size_t EnvironmentMap::mapSize(std::size_t maximum) const {
  const auto wanted = static_cast<std::size_t>(std::ceil(0.73 * static_cast<double>(width())));
  return std::min(std::bit_ceil(wanted), std::bit_floor(maximum));
}

OctahedralMap EnvironmentMap::radianceMap(std::size_t size) const {
  // A picture much finer than the map is brought near its resolution first, so that few samples a texel are enough.
  Image reduced;
  const Image* source = &picture_;
  while (source->width > 4 * size && source->height % 2 == 0) {
    reduced = halved(*source);
    source = &reduced;
  }
  std::vector<float> texels(3 * size * size);
  const std::size_t samples = source->width > size ? 4 : 2;  // along each side of a texel
  const double fine = static_cast<double>(size * samples);
  parallelFor(size, 8, [&](std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row)
      for (std::size_t column = 0; column < size; ++column) {
        double sum[3] = {}, weight = 0;
        for (std::size_t sample = 0; sample < samples * samples; ++sample) {
          const double u = (static_cast<double>(column * samples + sample % samples) + 0.5) / fine;
          const double v = (static_cast<double>(row * samples + sample / samples) + 0.5) / fine;
          const Direction d = OctahedralMap::direction(u, v);
          const double norm = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]), angle = norm * norm * norm;
          double rgb[3];
          interpolateToward(*source, d, rgb);
          for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += angle * rgb[channel];
          weight += angle;
        }
        for (std::size_t channel = 0; channel < 3; ++channel)
          texels[3 * (row * size + column) + channel] = static_cast<float>(sum[channel] / weight);
      }
  });
  return OctahedralMap(size, texels);
}

Image EnvironmentMap::diffuseMap() const {
  const auto fluxes = blockFluxes(picture_);
  Image map(128, 65, 4);
  constexpr std::size_t lanes = 32;  // texels at a time: the innermost loop, vectorised
  parallelFor(map.width * map.height, lanes * 4, [&](std::size_t first, std::size_t last) {
    for (; first < last; first += lanes) {
      float normal[3][lanes] = {}, sum[3][lanes] = {};
      const std::size_t used = std::min(lanes, last - first);
      for (std::size_t lane = 0; lane < used; ++lane) {
        const std::size_t index = first + lane;
        const double phi = 2 * kPi * static_cast<double>(index % map.width) / static_cast<double>(map.width) - kPi;
        const double theta = kPi * static_cast<double>(index / map.width) / static_cast<double>(map.height - 1);
        normal[0][lane] = static_cast<float>(std::sin(theta) * std::sin(phi));
        normal[1][lane] = static_cast<float>(std::cos(theta));
        normal[2][lane] = static_cast<float>(-std::sin(theta) * std::cos(phi));
      }
      for (const auto& flux : fluxes)
        for (std::size_t channel = 0; channel < 3; ++channel) {
          const float x = flux[3 * channel], y = flux[3 * channel + 1], z = flux[3 * channel + 2];
          for (std::size_t lane = 0; lane < lanes; ++lane) {
            const float cosine = normal[0][lane] * x + normal[1][lane] * y + normal[2][lane] * z;
            sum[channel][lane] += cosine > 0 ? cosine : 0;
          }
        }
      for (std::size_t lane = 0; lane < used; ++lane) {
        float* out = map.values.data() + 4 * (first + lane);
        for (std::size_t channel = 0; channel < 3; ++channel)
          out[channel] = sum[channel][lane] * static_cast<float>(1 / kPi);
        out[3] = 1;
      }
    }
  });
  return map;
}

}  // namespace brdf
