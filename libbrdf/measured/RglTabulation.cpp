#include <brdf/base/Parallel.h>
#include <brdf/material/ChannelView.h>
#include <brdf/measured/RglTabulation.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr double kSteepest = radians(89);
/// Part of the distribution that is even over the hemisphere: no direction is left out.
constexpr double kGround = 0.05;

double xOf(std::size_t k, std::size_t n) { return static_cast<double>(k) / static_cast<double>(n - 1); }
double thetaOf(double x) { return x * x * (kPi / 2); }
double phiOf(double y) { return (2 * y - 1) * kPi; }

/// Nodes of a square of half vectors or viewers.
Direction node(std::size_t x, std::size_t y, const RglData::Grid& grid) {
  return fromSpherical(thetaOf(xOf(x, grid.width)), phiOf(xOf(y, grid.height)));
}

/// Slope of facets from f near the mirror pairs about a half vector: D is f 4 cos_i cos_o/(F G), and in f(m, m) cos^2
/// and f(n, reflected in m) the last factors change slowly.
std::vector<float> distribution(const Brdf& luminance, const RglData::Grid& grid) {
  DirectionPairBuffer<double> pairs;
  for (std::size_t y = 0; y < grid.height; ++y)
    for (std::size_t x = 0; x < grid.width; ++x) {
      const Direction m = node(x, y, grid);
      pairs.push(m, m);
      const Direction mirrored{2 * m[2] * m[0], 2 * m[2] * m[1], 2 * m[2] * m[2] - 1};
      pairs.push(mirrored, {0, 0, 1});
    }
  std::vector<double> values(pairs.size());
  luminance.evaluateParallel(pairs.view(), values.data(), nullptr);
  std::vector<float> result(grid.width * grid.height);
  std::vector<double> shape(result.size());
  double total = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double c = std::max(pairs.wi[2][2 * i], 0.0);
    shape[i] = std::max({values[2 * i] * c * c, values[2 * i + 1] * std::max(pairs.wi[2][2 * i + 1], 0.0), 0.0});
    const double x = xOf(i % grid.width, grid.width), theta = thetaOf(x);
    const double area = 2 * kPi * kPi * x * std::sin(theta) / static_cast<double>((grid.width - 1) * (grid.height - 1));
    total += shape[i] * std::cos(theta) * area;
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = static_cast<float>((total > 0 ? (1 - kGround) * shape[i] / total : 0) + kGround / kPi);
  return result;
}

/// Integral of D max(0, v.m) d omega for a viewer: its projected area.
double projectedArea(const Direction& viewer, const RglData::Grid& ndf, const std::vector<Direction>& nodes,
                     const std::vector<double>& areas) {
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) sum += ndf.values[i] * std::max(0.0, dot(viewer, nodes[i])) * areas[i];
  return sum;
}

std::vector<float> viewerAngles(std::size_t count) {
  // Even in sqrt(90 degrees - theta): fine towards grazing, where lobes change fastest.
  std::vector<float> theta;
  const double all = std::sqrt(kPi / 2), last = std::sqrt(kPi / 2 - kSteepest);
  for (std::size_t k = 0; k < count; ++k) {
    const double r = all + (last - all) * xOf(k, count);
    theta.push_back(static_cast<float>(std::max(0.0, kPi / 2 - r * r)));
  }
  theta[0] = 0;
  return theta;
}

}  // namespace

RglData tabulateRgl(const Brdf& brdf, const RglResolution& resolution) {
  const bool isotropic = brdf.symmetry() != Symmetry::Anisotropic;
  const BrdfPointer borrowed(BrdfPointer(), &brdf), grey = asLuminance(borrowed);
  RglData data;
  data.channels = brdf.channels();
  data.theta = viewerAngles(resolution.theta);
  if (isotropic)
    data.phi = {0};
  else
    for (std::size_t k = 0; k < resolution.phi; ++k)
      data.phi.push_back(static_cast<float>(phiOf(xOf(k, resolution.phi))));
  const std::size_t slices = data.phi.size() * data.theta.size(), channels = data.channels.count();

  data.ndf = {resolution.microfacets, resolution.azimuths, {}};
  data.ndf.values = distribution(*grey, data.ndf);
  if (isotropic)  // the mean over azimuths, which no viewer can tell apart
    for (std::size_t x = 0; x < data.ndf.width; ++x) {
      double mean = 0;
      for (std::size_t y = 0; y < data.ndf.height; ++y) mean += data.ndf.values[y * data.ndf.width + x];
      for (std::size_t y = 0; y < data.ndf.height; ++y)
        data.ndf.values[y * data.ndf.width + x] = static_cast<float>(mean / static_cast<double>(data.ndf.height));
    }
  std::vector<Direction> nodes;
  std::vector<double> areas;
  for (std::size_t y = 0; y < data.ndf.height; ++y)
    for (std::size_t x = 0; x < data.ndf.width; ++x) {
      nodes.push_back(node(x, y, data.ndf));
      const double u = xOf(x, data.ndf.width);
      const double edge = y == 0 || y + 1 == data.ndf.height ? 0.5 : 1;  // the trapezoid rule
      areas.push_back(edge * 2 * kPi * kPi * u * std::sin(thetaOf(u)) /
                      static_cast<double>((data.ndf.width - 1) * (data.ndf.height - 1)));
    }

  data.sigma = {64, isotropic ? std::size_t{2} : std::size_t{33}, {}};
  data.sigma.values.resize(data.sigma.width * data.sigma.height);
  parallelFor(data.sigma.values.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      data.sigma.values[i] = static_cast<float>(std::max(
          projectedArea(node(i % data.sigma.width, i / data.sigma.width, data.sigma), data.ndf, nodes, areas), 1e-6));
  });

  data.vndf = {data.ndf.width, data.ndf.height, std::vector<float>(slices * nodes.size())};
  data.luminance = {resolution.lights, resolution.lights,
                    std::vector<float>(slices * resolution.lights * resolution.lights, 1.0f)};
  data.spectra = {resolution.lights, resolution.lights,
                  std::vector<float>(slices * channels * resolution.lights * resolution.lights)};
  const auto viewerOf = [&](std::size_t slice) {
    return fromSpherical(data.theta[slice % data.theta.size()], data.phi[slice / data.theta.size()]);
  };
  for (std::size_t s = 0; s < slices; ++s) {
    const Direction viewer = viewerOf(s);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      data.vndf.values[s * nodes.size() + i] =
          static_cast<float>(data.ndf.values[i] * std::max(0.0, dot(viewer, nodes[i])) * areas[i]);
    // The trapezoid's halves belong to the rule, not to the density.
    for (const std::size_t y : {std::size_t{0}, data.vndf.height - 1})
      for (std::size_t x = 0; x < data.vndf.width; ++x)
        data.vndf.values[(s * data.vndf.height + y) * data.vndf.width + x] *= 2;
  }

  // What the reader will make of the tables so far is what the values are placed and scaled by.
  const RglBrdf frame(data, "");
  const std::size_t lights = resolution.lights * resolution.lights;
  parallelFor(slices, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t s = first; s < last; ++s) {
      const Direction viewer = viewerOf(s);
      DirectionPairBuffer<double> pairs(lights);
      std::vector<double> scale(lights, 0), values(lights * channels), grays(lights);
      for (std::size_t i = 0; i < lights; ++i) {
        const Direction m = frame.halfVector(
            {xOf(i % resolution.lights, resolution.lights), xOf(i / resolution.lights, resolution.lights)}, viewer);
        const double c = dot(m, viewer);
        const Direction light =
            normalized({2 * c * m[0] - viewer[0], 2 * c * m[1] - viewer[1], 2 * c * m[2] - viewer[2]});
        pairs.set(i, light, viewer);
        if (c > 0 && light[2] > 0) scale[i] = light[2] / frame.factor(m, viewer);
      }
      brdf.evaluate(pairs.view(), values.data(), nullptr);
      grey->evaluate(pairs.view(), grays.data(), nullptr);
      double mean = 0;
      for (std::size_t i = 0; i < lights; ++i) mean += std::max(0.0, grays[i] * scale[i]) / static_cast<double>(lights);
      for (std::size_t i = 0; i < lights; ++i) {
        // A little everywhere: what the luminance misses is drawn, too.
        data.luminance.values[s * lights + i] =
            mean > 0 ? static_cast<float>(std::max(grays[i] * scale[i], 0.0) + 0.01 * mean) : 1.0f;
        for (std::size_t c = 0; c < channels; ++c)
          data.spectra.values[(s * channels + c) * lights + i] = static_cast<float>(values[c * lights + i] * scale[i]);
      }
    }
  });
  return data;
}

}  // namespace brdf
