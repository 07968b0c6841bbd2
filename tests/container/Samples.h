#pragma once
#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/ScatteredBrdf.h>

#include <filesystem>
#include <limits>
#include <string>

#include "../TestFolder.h"

/// What the container tests share: small materials with awkward numbers, and a folder of their own.
namespace samples {

inline std::filesystem::path freshFolder(const std::string& name) { return testFolder(name); }

/// The text of the brdf::Error that `action` throws; empty when it throws none.
template <class Action>
std::string errorOf(Action&& action) {
  try {
    action();
  } catch (const brdf::Error& error) {
    return error.what();
  }
  return {};
}

/// Scattered samples whose values no decimal writer and no float would bring back: subnormal, huge, thirds.
inline std::shared_ptr<const brdf::ScatteredBrdf> scattered(std::size_t count = 40) {
  brdf::ScatteredSamples data;
  data.channels = brdf::Channels::spectral({400, 550.25, 700});
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    data.pairs.push(brdf::fromSpherical(1.5 * t, 2.1 * t), brdf::fromSpherical(1.4 * (1 - t), -3.0 * t));
    data.valid.push_back(i % 7 != 3);
  }
  for (std::size_t i = 0; i < 3 * count; ++i) data.values.push_back(static_cast<double>(i + 1) / 3);
  data.values[0] = std::numeric_limits<double>::denorm_min();
  data.values[1] = 1.7e308;
  return std::make_shared<const brdf::ScatteredBrdf>(std::move(data), "scattered test samples");
}

inline bool sameSamples(const brdf::Brdf& a, const brdf::Brdf& b) {
  const auto& x = dynamic_cast<const brdf::ScatteredBrdf&>(a);
  const auto& y = dynamic_cast<const brdf::ScatteredBrdf&>(b);
  return x.data().channels == y.data().channels && x.data().pairs.wi == y.data().pairs.wi &&
         x.data().pairs.wo == y.data().pairs.wo && x.data().values == y.data().values &&
         x.data().valid == y.data().valid && x.symmetry() == y.symmetry() && x.description() == y.description();
}

}  // namespace samples
