#include <brdf/base/Error.h>
#include <brdf/simulate/wave/WaveBrdf.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdf {
namespace {

constexpr std::size_t kBlock = 128;

/// The pairs above the horizon, in blocks: calls `use(geometries, places, count)`.
template <class Use>
void forBlocks(const DirectionPairs<double>& pairs, Use&& use) {
  std::array<wave::Geometry, kBlock> geometry;
  std::array<std::size_t, kBlock> place;
  std::size_t filled = 0;
  for (std::size_t k = 0; k < pairs.count; ++k) {
    if (!wave::geometryOf(pairs, k, geometry[filled])) continue;
    place[filled++] = k;
    if (filled < kBlock) continue;
    use(geometry.data(), place.data(), filled);
    filled = 0;
  }
  if (filled > 0) use(geometry.data(), place.data(), filled);
}

bool isPlain(const wave::PolarizationState& state) { return state.stokes == std::array<double, 4>{1, 0, 0, 0}; }

}  // namespace

WaveBrdf::WaveBrdf(std::vector<wave::ScatterModelPointer> models, Channels channels, wave::PolarizationState incident,
                   wave::PolarizationState detected, std::string description)
    : models_(std::move(models)),
      channels_(std::move(channels)),
      incident_(std::move(incident)),
      detected_(std::move(detected)),
      description_(std::move(description)),
      plain_(isPlain(incident_) && isPlain(detected_)) {
  if (models_.empty() || models_.size() != channels_.count())
    throw Error(Error::Kind::Value, {"one model a channel is needed", description_, std::to_string(models_.size()),
                                     std::to_string(channels_.count())});
}

Symmetry WaveBrdf::symmetry() const {
  const Symmetry own = models_.front()->symmetry();
  // Circular and diagonal states tell left from right.
  const bool sided =
      incident_.stokes[2] != 0 || incident_.stokes[3] != 0 || detected_.stokes[2] != 0 || detected_.stokes[3] != 0;
  return own == Symmetry::Isotropic && sided ? Symmetry::Bilateral : own;
}

bool WaveBrdf::reciprocal() const { return plain_ && models_.front()->reciprocal(); }

void WaveBrdf::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  std::fill_n(values, models_.size() * pairs.count, 0.0);
  if (valid) std::fill_n(valid, pairs.count, std::uint8_t{1});
  std::array<double, 16> weight;
  const double half = isPlain(detected_) ? 1 : 0.5;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      weight[4 * row + column] = half * detected_.stokes[row] * incident_.stokes[column];
  forBlocks(pairs, [&](const wave::Geometry* geometry, const std::size_t* place, std::size_t count) {
    std::array<double, kBlock> block;
    std::array<wave::Mueller, kBlock> matrices;
    for (std::size_t channel = 0; channel < models_.size(); ++channel) {
      if (plain_) {
        models_[channel]->unpolarized(geometry, count, block.data());
      } else {
        models_[channel]->mueller(geometry, count, matrices.data());
        for (std::size_t k = 0; k < count; ++k) {
          double sum = 0;
          for (std::size_t e = 0; e < 16; ++e) sum += weight[e] * matrices[k].m[e];
          // Crossed states cancel to rounding, of either sign.
          block[k] = sum < 0 ? 0 : sum;
        }
      }
      for (std::size_t k = 0; k < count; ++k) {
        if (std::isfinite(block[k]))
          values[channel * pairs.count + place[k]] = block[k];
        else if (valid)
          valid[place[k]] = 0;
      }
    }
    for (std::size_t k = 0; valid && k < count; ++k)
      if (!valid[place[k]])
        for (std::size_t channel = 0; channel < models_.size(); ++channel) values[channel * pairs.count + place[k]] = 0;
  });
}

void WaveBrdf::mueller(const DirectionPairs<double>& pairs, std::size_t channel, wave::Mueller* matrices) const {
  std::fill_n(matrices, pairs.count, wave::Mueller{});
  forBlocks(pairs, [&](const wave::Geometry* geometry, const std::size_t* place, std::size_t count) {
    std::array<wave::Mueller, kBlock> block;
    models_.at(channel)->mueller(geometry, count, block.data());
    for (std::size_t k = 0; k < count; ++k) matrices[place[k]] = block[k];
  });
}

Components WaveBrdf::components() const {
  if (!plain_) return {};
  SpecularComponent specular{ComponentKind::FrontReflection, channels_, {}, {}};
  for (int degree = 0; degree <= 90; ++degree) specular.thetaI.push_back(degree * std::numbers::pi / 180);
  bool any = false;
  for (const wave::ScatterModelPointer& model : models_)
    for (const double theta : specular.thetaI) {
      specular.values.push_back(model->specular(theta));
      any |= specular.values.back() > 0;
    }
  Components components;
  if (any) components.specular.push_back(std::move(specular));
  return components;
}

}  // namespace brdf
