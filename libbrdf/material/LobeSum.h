#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Program.h>
#include <brdf/material/Brdf.h>
#include <brdf/models/Model.h>

#include <optional>
#include <string_view>

namespace brdf {

/// One lobe of a material: scale * model(parameters).
struct BRDF_EXPORT Lobe {
  ModelPointer model;
  std::vector<std::vector<double>> parameters;  ///< for each model parameter one value, or one value a channel
  std::vector<double> scale{1.0};               ///< one factor, or one a channel; non-negative

  /// True when every parameter has one value: the lobe's shape is shared by the channels.
  bool channelIndependent() const;
  /// The parameters of one channel, one number each.
  std::vector<double> parametersOf(std::size_t channel) const;
  double scaleOf(std::size_t channel) const { return scale.size() == 1 ? scale[0] : scale[channel]; }
};

/// An analytic material: a sum of lobes with scale factors.
class BRDF_EXPORT LobeSum : public Brdf {
 public:
  /// Throws Error::Kind::Value when a parameter or scale is out of bounds or its length is neither 1 nor the number of
  /// channels. `channels` is Monochrome, Rgb or Spectral.
  LobeSum(std::vector<Lobe> lobes, Channels channels);

  const std::vector<Lobe>& lobes() const { return lobes_; }

  const Channels& channels() const override { return channels_; }
  Symmetry symmetry() const override;
  bool reciprocal() const override;
  /// The material expression; reads back to the same values (17 significant digits).
  std::string description() const override;
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  void evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const override;
  /// A mixture of the lobes' samplers, weighted by `samplingWeights`.
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const override;
  void pdf(const DirectionPairs<double>& pairs, double* density) const override;
  using Brdf::evaluate;

  /// Share of samples that each lobe gets: its estimated directional albedo at 45 degrees, averaged over channels.
  const std::vector<double>& samplingWeights() const { return samplingWeights_; }

  /// One way to draw a direction: a lobe with one channel's parameters, and the share of draws it gets.
  struct Component {
    std::size_t lobe;
    std::size_t channel;  ///< whose parameters these are; 0 where the channels share them
    std::vector<double> parameters;
    double weight;
  };
  /// The mixture that `sample` draws from, in its order; the weights sum to 1.
  const std::vector<Component>& components() const { return components_; }

 private:
  struct Lazy;
  /// The whole sum as one program, an output a channel, made at its first use: what lobes and channels have in common
  /// is computed once, and the directions are read once.
  const formula::Program& program() const;
  template <class T>
  void evaluateProgram(const DirectionPairs<T>& pairs, T* values, std::uint8_t* valid) const;
  void chooseSamplingWeights();

  std::vector<Lobe> lobes_;
  Channels channels_;
  std::vector<double> samplingWeights_;
  std::vector<Component> components_;
  std::shared_ptr<Lazy> lazy_;
};

/// Reads a material expression: lobes joined by '+', each with optional scale factors `s *` where s is a number or one
/// number a channel `(s0, s1, ...)`, parameters named `name=value` or `name=(v0, v1, ...)`. Three values anywhere make
/// it RGB, all single values monochrome; other channels must be named by `channels`, whose count every list must have.
/// Example: "(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)". A microfacet lobe may be composed of its terms:
/// "Microfacet(D=Beckmann(alpha=0.1), F=Conductor(eta=0.2, k=3), G=Smith)" (models/Microfacet.h). Throws
/// Error::Kind::Formula with the column, what was expected and the nearest known name, Error::Kind::Value for a value
/// out of bounds.
BRDF_EXPORT std::shared_ptr<const LobeSum> parseMaterialExpression(std::string_view text,
                                                                   std::optional<Channels> channels = {});

}  // namespace brdf
