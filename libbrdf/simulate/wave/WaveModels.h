#pragma once
#include <brdf/brdf_export.h>
#include <brdf/models/Parameter.h>
#include <brdf/simulate/wave/FilmStack.h>
#include <brdf/simulate/wave/Grating.h>
#include <brdf/simulate/wave/WaveBrdf.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// An argument that is no number: one of another family, written as a call itself, or a text.
struct WaveArgument {
  std::string name;         ///< identifier in expressions, e.g. "spectrum"
  std::string family;       ///< whose kinds it takes ("spectrum", "slopes", ...); "text" for one of `choices`
  std::string description;  ///< one sentence
  std::string standard;     ///< what it is where it is not given
  std::vector<std::string> choices{};
};

/// A kind of wave-optical thing: a model, or what a model is made of.
struct WaveKind {
  std::string family;       ///< "model", "spectrum", "slopes", "shadowing", "scatterer", "phase", "index", "films"
  std::string name;         ///< as written in expressions
  std::string title;        ///< one line
  std::string description;  ///< what it is and where it holds, in sentences
  std::vector<Parameter> parameters{};    ///< numbers
  std::vector<WaveArgument> arguments{};  ///< the rest
  std::vector<Reference> references{};
};

/// All kinds, models first.
BRDF_EXPORT const std::vector<WaveKind>& waveKinds();
/// A model by its name. Throws Error::Kind::Value with the known names and the nearest.
BRDF_EXPORT const WaveKind& findWaveModel(std::string_view name);

/// The BRDF that an expression means, such as
///   RayleighRice(wavelength=0.633, eta=1.5, k=0, spectrum=abc(a=0.01, b=5, c=2))
/// without the "wave:" that materials put before it. Lengths and wavelengths are micrometres, angles degrees.
/// `wavelength` may be a list: ascending for a spectral BRDF; three in the order red, green, blue with channels=rgb.
/// Numbers of refractive indices may be lists of the same length. Throws Error::Kind::Formula or Value with the column,
/// Error::Kind::File for tables.
BRDF_EXPORT std::shared_ptr<const WaveBrdf> makeWaveBrdf(std::string_view expression);

/// Of a Grating expression: the orders of unpolarised light from polar angle theta and azimuth phi (radians), of the
/// wavelength of `channel`. Throws Error::Kind::Value for other models.
BRDF_EXPORT std::vector<wave::GratingOrder> gratingOrders(std::string_view expression, std::size_t channel,
                                                          double theta, double phi);
/// Of a ThinFilms expression or of any model's substrate and films: fractions of the incident power, at the wavelength
/// of `channel` and polar angle theta (radians).
BRDF_EXPORT wave::FilmStack::Powers filmPowers(std::string_view expression, std::size_t channel, double theta);

}  // namespace brdf
