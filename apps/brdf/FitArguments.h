#pragma once
#include "SampleArguments.h"

#include <brdf/fit/Fit.h>
#include <brdf/fit/LobeRequests.h>
#include <brdf/fit/ModelChoice.h>
#include <brdf/io/LoadMaterial.h>

#include <string>
#include <vector>

namespace brdf::app {

class Arguments;

/// What a fit is asked for: the options that `brdf fit` and the tasks of `brdf batch` share, declared here alone.
class FitArguments {
 public:
  /// Declares the options, which keep their values here: this object must outlive the parsing.
  void declare(Arguments& arguments);

  /// To be called after parsing: makes the request of the options' texts. Throws Error::Kind::Usage, Formula or Value
  /// naming the option.
  void resolve();

  /// Fits; `progress` as in FitOptions. Throws what brdf::fit throws.
  FitReport run(const Brdf& target, std::function<bool(std::size_t iteration, double error)> progress) const;

  /// The options as they would be typed, for the record.
  std::string words() const;

  /// What is fitted; sums to choose among with " or " between them.
  std::string lobes() const;
  const std::string& optimizer() const { return options_.optimizer; }
  const std::string& metric() const { return options_.metric; }
  /// The definitions of the models to fit, as text: another text is another model, whatever its name.
  std::string modelDefinitions() const;

 private:
  std::vector<std::string> lobes_;  ///< none: Lambertian + GGX, or those of from_
  std::string from_, channels_ = "spectral", strategy_ = "automatic", combination_ = "shared";
  std::vector<std::string> fixed_, tied_;
  bool progressive_ = false, noScan_ = false;
  std::size_t seed_ = 1;
  SampleArguments samples_;
  FitOptions options_;
  std::vector<CandidateLobes> candidates_;
};

/// The material that `spec` means. Throws what loadMaterial throws.
LoadedMaterial loadTarget(const std::string& spec);

}  // namespace brdf::app
