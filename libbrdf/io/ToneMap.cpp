#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/io/ToneMap.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

double applied(ToneCurve curve, double x) {
  switch (curve) {
    case ToneCurve::Reinhard:
      return std::isinf(x) ? 1 : x / (1 + x);
    case ToneCurve::Aces:
      return std::isinf(x) ? 1 : x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    default:
      return x;
  }
}

/// Linear values at which the 8-bit code changes: code k begins at the decoded value of (k - 1/2) / 255.
const std::array<float, 255>& codeEdges() {
  static const std::array<float, 255> edges = [] {
    std::array<float, 255> table{};
    for (std::size_t k = 0; k < table.size(); ++k) {
      const double encoded = (static_cast<double>(k) + 0.5) / 255;
      table[k] = static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
    }
    return table;
  }();
  return edges;
}

}  // namespace

ToneCurve toneCurve(std::string_view name) {
  if (name == "clamp") return ToneCurve::Clamp;
  if (name == "reinhard") return ToneCurve::Reinhard;
  if (name == "aces") return ToneCurve::Aces;
  throw Error(Error::Kind::Value, {"unknown tone curve", {}, "'" + std::string(name) + "'", "clamp, reinhard, aces"});
}

double srgbEncoded(double linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 1;
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

std::vector<std::uint8_t> toneMapped(const Image& image, double exposure, ToneCurve curve) {
  std::vector<std::uint8_t> out(image.values.size());
  const double gain = std::exp2(exposure);
  const auto& edges = codeEdges();
  parallelFor(out.size(), 65536 * image.channels, [&](std::size_t first, std::size_t last) {
    for (std::size_t index = first; index < last; ++index) {
      const double value = image.values[index];
      if (image.channels == 4 && index % 4 == 3) {
        out[index] = static_cast<std::uint8_t>(value > 0 ? std::min(value, 1.0) * 255 + 0.5 : 0);
      } else {
        const auto linear = static_cast<float>(value > 0 ? applied(curve, gain * value) : 0);
        out[index] = static_cast<std::uint8_t>(std::upper_bound(edges.begin(), edges.end(), linear) - edges.begin());
      }
    }
  });
  return out;
}

}  // namespace brdf
