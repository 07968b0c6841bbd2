#include <brdf/check/Tally.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/DeclaresEnergy.h>
#include <brdf/material/SampleSet.h>
#include <brdf/sampling/SampledBrdf.h>

#include <algorithm>
#include <optional>

namespace brdf {
namespace {

/// The samples as stored: those without a value, and negative ones.
void checkSamples(const SampleSet& samples, std::vector<Check>& checks) {
  constexpr std::size_t block = 65536;
  const std::size_t channels = samples.channels().count();
  Tally invalid("invalid", kAnything, "samples without a value"), negative("negative_samples", 0);
  DirectionPairBuffer<double> pairs;
  std::vector<double> values(channels * block);
  std::vector<std::uint8_t> valid(block);
  for (std::size_t first = 0; first < samples.count(); first += block) {
    const std::size_t length = std::min(block, samples.count() - first);
    samples.read(first, length, &pairs, values.data(), valid.data());
    for (std::size_t k = 0; k < length; ++k) {
      const auto at = [&] {
        return "sample " + std::to_string(first + k) + " " +
               directionText({pairs.wi[0][k], pairs.wi[1][k], pairs.wi[2][k]},
                             {pairs.wo[0][k], pairs.wo[1][k], pairs.wo[2][k]});
      };
      if (!valid[k]) invalid.count(at);
      for (std::size_t channel = 0; valid[k] && channel < channels; ++channel)
        if (values[channel * length + k] < 0) negative.count(at);
    }
  }
  checks.push_back(invalid.result());
  checks.push_back(negative.result());
}

/// At most three of the channels, across the spectrum: an albedo for each wavelength would take minutes.
BrdfPointer fewChannels(const BrdfPointer& material) {
  const std::size_t count = material->channels().count();
  if (count <= 3) return material;
  const std::size_t chosen[] = {0, count / 2, count - 1};
  return selectedChannels(material, chosen);
}

/// The loosest that a material or one of its lobes declares about the albedo.
std::optional<Declaration> declaredEnergy(const Brdf& material, const LobeSum* sum) {
  std::optional<Declaration> loosest;
  if (const auto* declares = dynamic_cast<const DeclaresEnergy*>(&material))
    if (const std::string note = declares->energyNote(); !note.empty())
      loosest = Declaration{.check = "energy", .reason = note};
  for (std::size_t k = 0; sum && k < sum->lobes().size(); ++k)
    if (const Declaration* own = sum->lobes()[k].model->declared("energy"))
      if (!loosest || own->allowed > loosest->allowed) loosest = *own;
  return loosest;
}

}  // namespace

std::vector<ParameterCase> channelCases(const Lobe& lobe, std::size_t channels) {
  std::vector<ParameterCase> cases;
  for (std::size_t channel = 0; channel < (lobe.channelIndependent() ? 1 : channels); ++channel)
    cases.push_back({lobe.parametersOf(channel), "channel " + std::to_string(channel), true});
  return cases;
}

Audit checkMaterial(const BrdfPointer& material, const std::string& name, const CheckOptions& options) {
  const auto* lobes = dynamic_cast<const LobeSum*>(material.get());
  const bool measured = material->samples() != nullptr;
  Audit audit{name, lobes ? "lobes" : measured ? "measured" : "other", {}};
  if (measured) checkSamples(*material->samples(), audit.checks);

  // Interpolated data cost a thousand times more than formulas.
  const CheckPairs pairs = adversarialPairs(scaled(measured ? 40 : 200, options, 4), options.seed, true);
  Tally finite("finite", 0), negative("non_negative", 0);
  tallyExtremes(*material, pairs, "", finite, negative);
  // Tables are stored in float; what they interpolate beside their peak is rounding.
  Tally reciprocity("reciprocity",
                    !material->reciprocal() ? kAnything
                    : measured              ? 1e-6
                                            : 1e-12,
                    material->reciprocal() ? "" : "not reciprocal by construction");
  tallyReciprocity(*material, pairs, "", measured ? 1e-9 : 0, reciprocity);
  for (const Tally* tally : {&finite, &negative, &reciprocity}) audit.checks.push_back(tally->result());

  const BrdfPointer sampled = lobes ? material : withSampler(material);
  const std::optional<Declaration> energy = declaredEnergy(*material, lobes);
  SamplerTallies sampler(1, energy ? &*energy : nullptr);
  tallySampler(*sampled, *fewChannels(material), "", options, sampler);
  sampler.into(audit.checks);

  for (std::size_t k = 0; lobes && k < lobes->lobes().size(); ++k) {
    const Lobe& lobe = lobes->lobes()[k];
    for (Check& check : checkCases(*lobe.model, channelCases(lobe, material->channels().count()), options)) {
      check.name = "lobe " + std::to_string(k + 1) + ": " + check.name;
      audit.checks.push_back(std::move(check));
    }
  }
  return audit;
}

}  // namespace brdf
