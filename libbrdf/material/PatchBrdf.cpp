#include <brdf/base/Error.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/SampleSet.h>

#include <algorithm>
#include <cmath>

namespace brdf {

class PatchBrdf::Pairs : public SampleSet {
 public:
  explicit Pairs(const PatchData& data) : data_(data) {}

  std::size_t count() const override { return data_.incident.count() * data_.outgoing.count(); }
  const Channels& channels() const override { return data_.channels; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    const std::size_t lights = data_.incident.count();
    if (pairs) {
      pairs->resize(length);
      for (std::size_t i = 0; i < length; ++i) {
        const Direction travel = data_.incident.centre((first + i) % lights);
        pairs->set(i, {-travel[0], -travel[1], travel[2]}, data_.outgoing.centre((first + i) / lights));
      }
    }
    if (values)
      for (std::size_t c = 0; c < data_.channels.count(); ++c)
        std::copy_n(data_.values.data() + c * count() + first, length, values + c * length);
    if (valid) std::fill_n(valid, length, std::uint8_t{1});
  }
  bool solidAngles(std::size_t first, std::size_t length, double* measures) const override {
    const std::size_t lights = data_.incident.count();
    for (std::size_t i = 0; i < length; ++i)
      measures[i] = data_.incident.solidAngle((first + i) % lights) * data_.outgoing.solidAngle((first + i) / lights);
    return true;
  }

 private:
  const PatchData& data_;
};

PatchBrdf::PatchBrdf(PatchData data, std::string description)
    : data_(std::move(data)), description_(std::move(description)), pairs_(std::make_unique<Pairs>(data_)) {
  const std::size_t lights = data_.incident.count(), viewers = data_.outgoing.count(), cells = lights * viewers;
  const std::size_t channels = data_.channels.count();
  if (data_.values.size() != channels * cells)
    throw Error(Error::Kind::Value, {"wrong number of values", "matrix of patches", std::to_string(data_.values.size()),
                                     std::to_string(channels * cells)});
  for (double& value : data_.values)
    if (!std::isfinite(value)) value = 0;
  cumulative_.reserve(viewers * (lights + 1));
  for (std::size_t o = 0; o < viewers; ++o) {
    double sum = 0;
    cumulative_.push_back(sum);
    for (std::size_t i = 0; i < lights; ++i) {
      double magnitude = 0;
      for (std::size_t c = 0; c < channels; ++c) magnitude += std::abs(data_.values[c * cells + o * lights + i]);
      sum += magnitude * data_.incident.projectedSolidAngle(i);
      cumulative_.push_back(sum);
    }
  }
}

PatchBrdf::~PatchBrdf() = default;

const SampleSet* PatchBrdf::samples() const { return pairs_.get(); }

std::vector<double> PatchBrdf::directionalAlbedos() const {
  const std::size_t lights = data_.incident.count(), viewers = data_.outgoing.count();
  std::vector<double> albedos(data_.channels.count() * lights, 0.0);
  for (std::size_t c = 0; c < data_.channels.count(); ++c)
    for (std::size_t o = 0; o < viewers; ++o)
      for (std::size_t i = 0; i < lights; ++i)
        albedos[c * lights + i] += data_.values[(c * viewers + o) * lights + i] * data_.outgoing.projectedSolidAngle(o);
  return albedos;
}

void PatchBrdf::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  const std::size_t channels = data_.channels.count(), lights = data_.incident.count();
  const std::size_t cells = lights * data_.outgoing.count();
  for (std::size_t k = 0; k < pairs.count; ++k) {
    const std::size_t i = incidentPatch(pairs.wi[0][k], pairs.wi[1][k], pairs.wi[2][k]);
    const std::size_t o = data_.outgoing.find(pairs.wo[0][k], pairs.wo[1][k], pairs.wo[2][k]);
    const bool held = i != PatchBasis::npos && o != PatchBasis::npos;
    if (valid) valid[k] = held || !(pairs.wi[2][k] > 0 && pairs.wo[2][k] > 0);
    for (std::size_t c = 0; c < channels; ++c)
      values[c * pairs.count + k] = held ? data_.values[c * cells + o * lights + i] : 0;
  }
}

void PatchBrdf::sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                       const std::array<double*, 3>& wi, std::size_t count) const {
  const std::size_t lights = data_.incident.count();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t o = data_.outgoing.find(wo[0][k], wo[1][k], wo[2][k]);
    const double* sums = o == PatchBasis::npos ? nullptr : cumulative_.data() + o * (lights + 1);
    if (!sums || !(sums[lights] > 0)) {
      const double* oneWo[3] = {&wo[0][k], &wo[1][k], &wo[2][k]};
      Brdf::sample({oneWo[0], oneWo[1], oneWo[2]}, {&u[0][k], &u[1][k]}, {&wi[0][k], &wi[1][k], &wi[2][k]}, 1);
      continue;
    }
    const double target = u[0][k] * sums[lights];
    // The first sum above the target ends the patch: one whose weight is 0 is never chosen.
    std::size_t i = static_cast<std::size_t>(std::upper_bound(sums, sums + lights + 1, target) - sums);
    i = std::min(i, lights) - 1;
    while (i > 0 && sums[i + 1] == sums[i]) --i;  // only where rounding put the target at the very end
    const double within = std::clamp((target - sums[i]) / (sums[i + 1] - sums[i]), 0.0, 1.0);
    const Direction travel = data_.incident.at(i, within, u[1][k]);
    wi[0][k] = -travel[0];
    wi[1][k] = -travel[1];
    wi[2][k] = travel[2];
  }
}

void PatchBrdf::pdf(const DirectionPairs<double>& pairs, double* density) const {
  const std::size_t channels = data_.channels.count(), lights = data_.incident.count();
  const std::size_t cells = lights * data_.outgoing.count();
  for (std::size_t k = 0; k < pairs.count; ++k) {
    const double cosine = pairs.wi[2][k];
    density[k] = 0;
    if (!(cosine > 0 && pairs.wo[2][k] > 0)) continue;
    const std::size_t o = data_.outgoing.find(pairs.wo[0][k], pairs.wo[1][k], pairs.wo[2][k]);
    const double total = o == PatchBasis::npos ? 0 : cumulative_[o * (lights + 1) + lights];
    if (!(total > 0)) {
      density[k] = cosine / kPi;
      continue;
    }
    const std::size_t i = incidentPatch(pairs.wi[0][k], pairs.wi[1][k], cosine);
    if (i == PatchBasis::npos) continue;
    double magnitude = 0;
    for (std::size_t c = 0; c < channels; ++c) magnitude += std::abs(data_.values[c * cells + o * lights + i]);
    density[k] = magnitude * cosine / total;
  }
}

}  // namespace brdf
