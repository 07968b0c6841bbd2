#pragma once
#include <brdf/fit/FitProblem.h>
#include <brdf/material/ScatteredBrdf.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace brdf::study {

/// One thing to fit, with what counts as success. The lists are fixed before anything is run on them.
struct Case {
  std::string name;   ///< with the true parameters, for the list
  std::string label;  ///< short, for lists of failures
  std::string metric;
  BrdfPointer target;
  std::vector<LobeRequest> lobes;  ///< with the starting values
  double wantedError = 0;          ///< success: an error of at most this, in the metric
  /// Known-truth cases: values of the free parameters of each lobe by name, those that the data determine.
  std::vector<std::pair<std::string, double>> truth;
  /// How far each may be from the truth: a hundredth of its soft range, in its logarithm where its scale is one.
  std::vector<double> tolerance;
};

/// The 40 of ../shared/reference/best_fits.json: two paints, five lobes beside a Lambertian, four metrics, luminance,
/// from the models' defaults; success is an error within 2 % of the best known. Empty where the files are missing.
std::vector<Case> referenceCases(const std::filesystem::path& shared);

/// Every model beside a Lambertian, 0.3 Lambertian + 0.7 model, at two places of its soft range, on 2000 noise-free
/// scattered samples (200 of EPD, 40 of HeTorrance: they are slow) (tests/fit/SyntheticTarget.h); of models with a
/// roughness along y the second is anisotropic. Place k of parameter j is 0.15 + 0.7 frac(0.5 + k a_j) of the soft
/// range, a_j the R_d sequence's, rounded to three digits. The start is at 0.95 of every soft range whose truth lies in
/// its lower half, else at 0.05. Success: an rms error of at most a ten thousandth of the zero model's.
std::vector<Case> recoveryCases();

/// Whether the parameters that are determined came back: every |found - truth| within the tolerance.
bool parametersFound(const Case& one, const std::vector<std::vector<double>>& parameters);

}  // namespace brdf::study
