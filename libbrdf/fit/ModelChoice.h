#pragma once
#include <brdf/fit/Fit.h>

#include <string>
#include <vector>

namespace brdf {

/// Lobes that may describe a target.
struct CandidateLobes {
  std::string name;  ///< for the report
  std::vector<LobeRequest> lobes;
};

/// Fits each of them and gives the report of the best: of least error by cross-validation where the options ask for
/// one, else of least BIC. Its list of candidates has all, the best first. When stopped, the best of those complete, or
/// the one that was begun. Throws Error::Kind::Value for an empty list, and what fit() throws.
BRDF_EXPORT FitReport fitBest(const Brdf& target, const std::vector<CandidateLobes>& candidates,
                              const FitOptions& options);

/// Fits the first lobe, then the first two from where that ended, and so on. The report is the last fit's; its list of
/// candidates has every stage in order.
BRDF_EXPORT FitReport fitProgressively(const Brdf& target, std::vector<LobeRequest> lobes, const FitOptions& options);

}  // namespace brdf
