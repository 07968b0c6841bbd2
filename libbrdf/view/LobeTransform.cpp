#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/view/LobeTransform.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::array<std::pair<std::string_view, LobeTransform>, 4> kTransforms{{
    {"none", LobeTransform::None},
    {"cuberoot", LobeTransform::CubeRoot},
    {"log", LobeTransform::Log},
    {"logfloor", LobeTransform::LogFloor},
}};

}  // namespace

double transformed(const LobeScale& scale, double value) {
  const double positive = std::max(value, 0.0);
  switch (scale.transform) {
    case LobeTransform::CubeRoot:
      return std::cbrt(positive);
    case LobeTransform::Log:
      return std::log1p(positive);
    case LobeTransform::LogFloor:
      return std::log10(std::max(positive / scale.floor, 1.0));
    default:
      return positive;
  }
}

LobeTransform parseLobeTransform(std::string_view name) {
  for (const auto& [known, transform] : kTransforms)
    if (known == name) return transform;
  throw Error(Error::Kind::Value, {"unknown transform", "transform", std::string(name), joined(lobeTransformNames())});
}

std::vector<std::string> lobeTransformNames() {
  std::vector<std::string> names;
  for (const auto& [name, transform] : kTransforms) names.emplace_back(name);
  return names;
}

std::string lobeScaleLabel(const LobeScale& scale) {
  switch (scale.transform) {
    case LobeTransform::CubeRoot:
      return "cube root of f_r (sr^-1/3)";
    case LobeTransform::Log:
      return "ln(1 + f_r), f_r in 1/sr";
    case LobeTransform::LogFloor:
      return "log10(f_r / " + formatNumber(scale.floor) + "/sr), at least 0";
    default:
      return "f_r (1/sr)";
  }
}

}  // namespace brdf
