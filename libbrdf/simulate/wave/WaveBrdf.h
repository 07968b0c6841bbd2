#pragma once
#include <brdf/material/Brdf.h>
#include <brdf/material/Components.h>
#include <brdf/material/DeclaresEnergy.h>
#include <brdf/simulate/wave/ScatterModel.h>

#include <string>
#include <vector>

namespace brdf {

/// A wave-optical model as a BRDF, exact: its Mueller matrices, and the value that one state of polarisation in and one
/// analyser out give. Conventions of polarisation: wave/Polarization.h.
class BRDF_EXPORT WaveBrdf : public Brdf, public DeclaresEnergy {
 public:
  /// `models`: one a channel. The value is analyser . M . incident; an analyser of all light is (1, 0, 0, 0), one that
  /// passes a state half of it. Throws Error::Kind::Value for a number of models other than that of channels.
  WaveBrdf(std::vector<wave::ScatterModelPointer> models, Channels channels, wave::PolarizationState incident,
           wave::PolarizationState detected, std::string description);

  const Channels& channels() const override { return channels_; }
  Symmetry symmetry() const override;
  /// Where the model is, for unpolarised light and a detector of all light: along the normal, whose plane is a
  /// convention, states of light and viewer are not exchanged.
  bool reciprocal() const override;
  std::string description() const override { return description_; }
  /// A value that the model does not have (an infinite spectrum) is invalid.
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;

  /// Mueller matrices of one channel, in 1/sr; zero below the horizon. `matrices` has room for pairs.count.
  void mueller(const DirectionPairs<double>& pairs, std::size_t channel, wave::Mueller* matrices) const;

  const std::vector<wave::ScatterModelPointer>& models() const { return models_; }
  const wave::PolarizationState& incident() const { return incident_; }
  const wave::PolarizationState& detected() const { return detected_; }
  std::string energyNote() const override { return models_.front()->energyNote(); }
  /// What leaves undiffracted in the mirror direction, at every degree; empty where there is none or it is not known,
  /// and for other light than unpolarised or an analyser. Tables and files keep it beside the values (loadMaterial).
  Components components() const;

 private:
  std::vector<wave::ScatterModelPointer> models_;
  Channels channels_;
  wave::PolarizationState incident_, detected_;
  std::string description_;
  bool plain_;  ///< unpolarised light, detector of all light
};

}  // namespace brdf
