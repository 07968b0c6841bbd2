#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Graph.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/models/Declaration.h>
#include <brdf/models/Parameter.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// An analytic lobe read from one XML file (libbrdf/models/*.xml): its parameters, and everything derived from its one
/// equation: batched values in float and double, exact derivatives, GLSL, extended precision, sampler. Immutable and
/// shared; safe to use from several threads.
///
/// `parameters` arguments below are one number for each entry of parameters(), in that order, inside the hard bounds
/// (the caller checks, see checkBounds). One channel at a time: a channel-dependent lobe is evaluated once a channel.
class BRDF_EXPORT Model {
 public:
  virtual ~Model();

  const std::string& name() const { return name_; }
  const std::string& title() const { return title_; }  ///< one line
  const std::string& description() const { return description_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  const std::vector<Reference>& references() const { return references_; }
  const std::string& equation() const { return equation_; }  ///< text in the formula language
  bool isotropic() const { return isotropic_; }
  bool reciprocal() const { return reciprocal_; }
  /// True when the value depends on no direction (a Lambertian): environment light is then a cosine-convolved look-up.
  bool constant() const { return constant_; }
  /// False when the record names no sampler: `sample` is cosine-weighted, and who draws much from the lobe makes a
  /// tabulated sampler of its values (sampling/SampledBrdf.h).
  bool namesSampler() const { return namesSampler_; }

  /// The laws that the model declares not to keep.
  const std::vector<Declaration>& declarations() const { return declarations_; }
  /// What it declares about the check called `check` (models/Declaration.h), or null.
  const Declaration* declared(std::string_view check) const;

  /// Index of the parameter called `name`; throws Error::Kind::Value with the nearest name when there is none.
  std::size_t parameterIndex(std::string_view name) const;
  /// The defaults, one a parameter.
  std::vector<double> defaults() const;
  /// Throws Error::Kind::Value naming the parameter, the value and the hard bounds when `value` lies outside.
  void checkBounds(std::size_t parameter, double value) const;

  /// f_r in 1/sr without the cosine, 0 where either cosine is <= 0. `out` holds pairs.count numbers.
  virtual void evaluate(const DirectionPairs<double>& pairs, std::span<const double> parameters, double* out) const = 0;
  virtual void evaluate(const DirectionPairs<float>& pairs, std::span<const double> parameters, float* out) const = 0;

  /// Value and exact derivative with respect to each parameter listed in `which` (indices): `out` is planar, the value
  /// at out[i], the derivative with respect to which[k] at out[(k + 1) * pairs.count + i].
  virtual void evaluateWithDerivatives(const DirectionPairs<double>& pairs, std::span<const double> parameters,
                                       std::span<const std::size_t> which, double* out) const = 0;

  /// Draws wi given wo from two random numbers; see Brdf::sample.
  virtual void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                      std::span<const double> parameters, const std::array<double*, 3>& wi,
                      std::size_t count) const = 0;
  /// Density of `sample` per solid angle.
  virtual void pdf(const DirectionPairs<double>& pairs, std::span<const double> parameters, double* density) const = 0;

  /// One pair in 50-digit arithmetic from the same rounded inputs, rounded to double at the end: value, then the
  /// derivative with respect to each parameter (by the same exact graph).
  virtual std::vector<double> evaluateExtended(const std::array<double, 3>& wi, const std::array<double, 3>& wo,
                                               std::span<const double> parameters) const = 0;

  /// Adds the value at fixed parameters to a graph, where it shares what it can with what is there.
  virtual formula::NodeId buildValue(formula::Graph& graph, std::span<const double> parameters) const = 0;

  /// GLSL source (3.30 core) of three functions, each with the parameters as trailing float arguments in order:
  ///   float brdf_<name>(vec3 wi, vec3 wo, float p0, ...)          value, 0 below the horizon
  ///   float brdf_<name>_pdf(vec3 wi, vec3 wo, float p0, ...)      density of the sampler, 1/sr
  ///   vec3  brdf_<name>_sample(vec3 wo, vec2 u, float p0, ...)    unit wi, or vec3(0) for a failed draw
  /// Directions are in the local frame (normal +z); parameters are what Parameter::shaderValue gives. Needs
  /// glslPrelude() before it.
  virtual std::string glsl() const = 0;

  /// GLSL of the functions that every model's source may call (log, pow, ... of known accuracy). No #version line.
  static std::string glslPrelude();

 protected:
  Model() = default;

  std::string name_, title_, description_, equation_;
  std::vector<Parameter> parameters_;
  std::vector<Reference> references_;
  std::vector<Declaration> declarations_;
  bool isotropic_ = true, reciprocal_ = true, constant_ = false, namesSampler_ = true;
};

using ModelPointer = std::shared_ptr<const Model>;

/// The registered models in alphabetical order: those embedded in the library, then those loaded at run time.
BRDF_EXPORT std::vector<ModelPointer> allModels();
/// The model called `name`; throws Error::Kind::Value with the nearest name when there is none.
BRDF_EXPORT ModelPointer findModel(std::string_view name);

}  // namespace brdf
