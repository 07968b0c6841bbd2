#pragma once
// The lobes of BRDFLab 0.8.2 and ours. Internal to libbrdf/io.
#include <brdf/material/LobeSum.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace brdf {

/// A lobe of that program for one channel: ours with `factor` in front has its value.
struct LobeFromBrdfLab {
  ModelPointer model;
  std::vector<double> parameters;
  double factor = 1;
};

/// `linear`: the lobe has scale factors of its own; a Lambertian's parameter then does not count.
LobeFromBrdfLab fromBrdfLab(const std::string& model, const std::map<std::string, double>& parameters, bool linear,
                            const std::string& where);

/// The other way round. The parameters stand in the program's order.
struct LobeForBrdfLab {
  std::string model;
  std::vector<std::pair<std::string, double>> parameters;
  double factor = 1;  ///< goes into the scale factor
};
LobeForBrdfLab toBrdfLab(const Lobe& lobe, std::size_t channel);

}  // namespace brdf
