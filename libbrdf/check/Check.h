#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/LobeSum.h>
#include <brdf/models/Model.h>

#include <functional>
#include <string>
#include <vector>

namespace brdf {

/// The outcome of one check of a model or material.
struct Check {
  std::string name;  ///< "finite", "reciprocity", ...; see checkModel and checkMaterial
  bool passed = true;
  double worst = 0;       ///< the worst case; its meaning is the check's own, never less is better
  double allowed = 0;     ///< passed means worst <= allowed; infinity where nothing is demanded
  std::string at;         ///< the worst case's directions (degrees) and parameters; empty where there is none
  std::string note;       ///< why nothing or less is demanded, or what was not checked; empty otherwise
  bool declared = false;  ///< the model declares not to keep the law; the note is its reason
};

/// All checks of one model or material.
struct Audit {
  std::string name;
  std::string kind;  ///< "model", "lobes", "measured", or "other": neither lobes nor samples
  std::vector<Check> checks;

  BRDF_EXPORT bool passed() const;
};

/// The relative variance allowed to any sampler of any lobe: n draws leave a relative error of sqrt(10/n). Cosine
/// sampling of a lobe cos^n about the normal has (n + 2)^2/(4 n + 4) - 1, which exceeds it from n = 42 on (a half width
/// of 10 degrees, GGX's alpha 0.2); sharper lobes need a sampler of their own.
constexpr double kEfficiencyBound = 10;
/// Albedos below count as this one when a variance is compared with their square: no picture shows noise of a lobe that
/// reflects less than a millionth.
constexpr double kLeastAlbedo = 1e-6;

struct CheckOptions {
  /// Multiplies the numbers of pairs, parameter sets and draws: 1 audits the whole library in about two minutes.
  double effort = 1;
  unsigned seed = 1;
};

/// Audits a model over its defaults, its soft bounds and its hard bounds, at random and at adversarial directions
/// (check/Cases.h). The checks, and what `worst` is:
/// - finite, non_negative: values in double and float that are not finite, or negative; none allowed. A float may be
///   infinite where the double exceeds the largest float;
/// - double_accuracy, float_accuracy: relative error against 50-digit arithmetic from the same rounded inputs, as a
///   share of what is allowed there (1e-12 and 1e-5, more where an exponential loses digits);
/// - conditioning: relative change of the exact value when the directions are rounded to float: nothing is demanded;
/// - parameter_conditioning: the same for the parameters, inside the soft bounds;
/// - derivative: difference from a 50-digit central difference, as a share of what is allowed there;
/// - reciprocity: relative change when light and viewer change places;
/// - turning: relative change when both directions are turned about the normal (isotropic models only);
/// - normalisation: how far the integral of a microfacet distribution D(h) cos(theta_h) is from 1, over the hard bounds
///   too; for models whose equation assigns D (models/FormulaModel.h);
/// - energy: largest directional albedo (white furnace);
/// - sampler_directions: draws that are no direction above the horizon or have no density; none allowed;
/// - sampler: surprise of the chi-square test, -log10 of its probability;
/// - pdf_integral: the density's integral + failed draws - 1 in units of its error (SamplerTest::deviation);
/// - efficiency: variance of f cos / pdf over the albedo squared, at most kEfficiencyBound. A lobe that names no
/// sampler
///   is drawn by the tables that renderers make of its values (sampling/SampledBrdf.h).
/// What a model declares not to keep (models/Declaration.h, Model::reciprocal) is measured, and passes with a note.
BRDF_EXPORT Audit checkModel(const Model& model, const CheckOptions& options = {});

/// Audits a material. A sum of lobes: finite, non_negative, reciprocity, energy and the sampler's checks of the sum,
/// and all checks of a model for each lobe at its own parameters, named "lobe 1: ..." (channels with parameters of
/// their own are all covered). Measured data: "invalid" (samples without a value, nothing demanded), non_negative
/// samples, finite, reciprocity (demanded where the data are reciprocal by construction), energy, and the sampler's
/// checks with the tabulated sampler that renderers use. Any other BRDF: the same without those of samples; energy is
/// not demanded of what declares not to keep it (material/DeclaresEnergy.h).
BRDF_EXPORT Audit checkMaterial(const BrdfPointer& material, const std::string& name, const CheckOptions& options = {});

/// Runs GLSL: `functions` (GLSL 3.30 without #version) and up to four float `expressions` over the names of the
/// columns, once a row; result[k][i] is expression k at row i.
struct GlslColumn {
  std::string name;
  std::vector<float> values;
};
using GlslRunner = std::function<std::vector<std::vector<float>>(
    const std::string& functions, const std::vector<GlslColumn>& columns, const std::vector<std::string>& expressions)>;

/// "glsl": the model's GLSL, value and density, against double at the same rounded inputs: relative error as a share of
/// the 1e-4 allowed, at defaults and inside the soft bounds. What the runner throws is thrown on.
BRDF_EXPORT Check checkGlsl(const Model& model, const GlslRunner& run, const CheckOptions& options = {});
/// "lobe 1: glsl", ...: the same for each lobe of a sum at its own parameters, those of every channel; outside of a
/// model's soft bounds nothing is demanded.
BRDF_EXPORT std::vector<Check> checkGlsl(const LobeSum& material, const GlslRunner& run,
                                         const CheckOptions& options = {});

}  // namespace brdf
