#pragma once
// Internal to libbrdf/simulate/wave: what the makers of models read from expressions.
#include <brdf/models/CallArguments.h>
#include <brdf/simulate/Spectrum.h>
#include <brdf/simulate/wave/Facets.h>
#include <brdf/simulate/wave/Particles.h>
#include <brdf/simulate/wave/WaveModels.h>

namespace brdf::wave {

/// Records of parameters, by name, of every kind.
Parameter numberRecord(std::string name, std::string unit, std::string description, double standard, double minimum,
                       double maximum, double softMinimum, double softMaximum, bool logarithmic = false);

/// The kinds other than models, for listings.
std::vector<WaveKind> partKinds();

/// Reads one call for all wavelengths (micrometres) of a model.
class WaveReader {
 public:
  WaveReader(CallArguments& arguments, const std::vector<double>& wavelengths)
      : arguments_(arguments), wavelengths_(wavelengths) {}

  CallArguments& arguments() { return arguments_; }
  const std::vector<double>& wavelengths() const { return wavelengths_; }

  /// eta and k, or index=..., one a wavelength.
  std::vector<Complex> indices(double eta, double k);
  /// The real index of what must not absorb. Throws Error::Kind::Value where k > 0.
  std::vector<double> realIndices(const std::vector<Complex>& indices, const std::string& what) const;
  /// films=..., on the substrate, one a wavelength.
  std::vector<FilmStack> stacks(const std::vector<Complex>& substrate);
  SpectrumPointer spectrum();
  SlopePointer slopes();
  ShadowingPointer shadowing();
  /// scatterer=..., in media of real index, one a wavelength.
  std::vector<ScattererPointer> scatterers(const std::vector<double>& media);
  PhaseFunctionPointer phase();

 private:
  CallArguments& arguments_;
  const std::vector<double>& wavelengths_;
};

}  // namespace brdf::wave
