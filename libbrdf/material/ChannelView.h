#pragma once
#include <brdf/brdf_export.h>
#include <brdf/color/ColourSettings.h>
#include <brdf/material/Brdf.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace brdf {

class LobeSum;

/// Another BRDF seen through other channels: each of its values is a fixed linear combination of the source's.
/// Directions, symmetry, validity and sampling are the source's; its samples are seen through the same matrix.
class BRDF_EXPORT ChannelView : public Brdf {
 public:
  /// `matrix` has channels.count() rows of source->channels().count() weights, rows first. `name` says what is seen,
  /// e.g. "luminance"; the description is "name of (source)". Throws Error::Kind::Value when the sizes disagree.
  ChannelView(BrdfPointer source, Channels channels, std::vector<double> matrix, std::string name);
  ~ChannelView() override;

  const BrdfPointer& source() const { return source_; }
  /// Rows of weights, one a channel, as given.
  const std::vector<double>& matrix() const { return matrix_; }

  const Channels& channels() const override { return channels_; }
  Symmetry symmetry() const override { return source_->symmetry(); }
  bool reciprocal() const override { return source_->reciprocal(); }
  std::string description() const override;
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const override;
  void pdf(const DirectionPairs<double>& pairs, double* density) const override;
  const SampleSet* samples() const override;

 private:
  class View;
  /// result (planar, `count` a channel) = matrix * values (planar).
  void combine(const double* values, std::size_t count, double* result) const;

  BrdfPointer source_;
  Channels channels_;
  std::vector<double> matrix_;
  std::string name_;
  std::unique_ptr<const SampleSet> samples_;
};

/// As linear sRGB for display: spectral through rgbWeights under the settings (D65 and the 2-degree observer by
/// default), monochrome as three equal channels; RGB comes back unchanged (the same pointer). Throws Error::Kind::Value
/// for a spectrum without visible wavelengths.
BRDF_EXPORT BrdfPointer asRgb(BrdfPointer brdf, const ColourSettings& settings = {});

/// A spectral BRDF as linear sRGB, anything else unchanged. A table or grid stays one, with its cells and their states;
/// not the standard errors of a grid.
BRDF_EXPORT BrdfPointer reducedToRgb(BrdfPointer brdf, const ColourSettings& settings = {});

/// Planar values of spectral `channels` as planar linear sRGB.
BRDF_EXPORT std::vector<double> inRgb(const std::vector<double>& values, const Channels& channels,
                                      const ColourSettings& settings = {});

/// A sum of linear sRGB lobes equal to a spectral one: its scale factors seen as colours. Null where a lobe's
/// parameters depend on the wavelength, or a colour lies outside sRGB (lobes have no negative scale).
BRDF_EXPORT std::shared_ptr<const LobeSum> lobesAsRgb(const LobeSum& material, const ColourSettings& settings = {});

/// As one channel of luminance: spectral through luminanceWeights (under the settings' illuminant, equal energy where
/// none is set), RGB by the weights of ITU-R BT.709; monochrome comes back unchanged. Throws as asRgb does.
BRDF_EXPORT BrdfPointer asLuminance(BrdfPointer brdf, const ColourSettings& settings = {});

/// Some of the source's channels, by index, in the order given. One is monochrome unless the source is spectral;
/// several of an RGB source must be (0, 1, 2), those of a spectral source ascending. Throws Error::Kind::Value
/// otherwise, and for an index out of range.
BRDF_EXPORT BrdfPointer selectedChannels(BrdfPointer brdf, std::span<const std::size_t> indices);

}  // namespace brdf
