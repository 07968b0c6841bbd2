#include "SampleArguments.h"

#include "Arguments.h"

#include <brdf/base/Error.h>

namespace brdf::app {

void SampleArguments::declare(Arguments& arguments, bool noise) {
  arguments.choice("--sampling", sampling_, {"automatic", "all", "hemisphere", "importance"},
                   "Where the target is looked at: all its own samples, pairs in equal solid angles, or draws that are "
                   "more where it is bright, weighted to the same mean; automatic: its own where it has any");
  arguments.option("--samples", count_, {0, 1e7},
                   "How many pairs of --sampling hemisphere [221184] or importance [100000]");
  std::vector<std::string> weights{"none", "solid-angle"};
  if (noise) weights.emplace_back("noise");
  arguments.choice("--weights", weights_, weights,
                   noise ? "Samples count alike, by the solid angle of their cell, or by 1 / variance where their "
                           "errors are known"
                         : "Whether samples count alike or by the solid angle of their cell");
}

SampleChoice SampleArguments::choice(std::uint64_t seed) const {
  SampleChoice choice;
  choice.sampling = sampling_ == "all"          ? Sampling::All
                    : sampling_ == "hemisphere" ? Sampling::Hemisphere
                    : sampling_ == "importance" ? Sampling::Importance
                                                : Sampling::Automatic;
  choice.count = count_;
  choice.seed = seed;
  choice.solidAngles = weights_ == "solid-angle";
  choice.noise = weights_ == "noise";
  if (choice.sampling == Sampling::All && count_ > 0)
    throw Error(Error::Kind::Usage, {"the number of a target's own samples is given", "--samples",
                                     std::to_string(count_), "with --sampling hemisphere or importance"});
  if (choice.sampling == Sampling::Automatic && count_ > 0) choice.sampling = Sampling::Hemisphere;
  return choice;
}

std::string SampleArguments::words() const {
  return "--sampling " + sampling_ + (count_ > 0 ? " --samples " + std::to_string(count_) : "") + " --weights " +
         weights_;
}

}  // namespace brdf::app
