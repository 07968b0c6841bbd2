#pragma once
#include <brdf/base/Call.h>
#include <brdf/brdf_export.h>
#include <brdf/models/Parameter.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

struct HeightSpectrum;

/// The power spectral density (PSD) of the heights of a rough surface, immutable.
///
/// Conventions: frequencies fx, fy along the surface in cycles per micrometre (1/um), both signs; PSD(fx, fy) in um^4,
/// two-sided, so that its integral over the whole plane is the variance of the heights in um^2. The autocovariance is
/// its Fourier transform: C(x, y) = integral of PSD cos(2 pi (fx x + fy y)) dfx dfy, C(0) = variance.
class BRDF_EXPORT Spectrum {
 public:
  virtual ~Spectrum();

  /// PSD at `count` frequencies; infinite only where the class says so.
  virtual void evaluate(const double* fx, const double* fy, double* psd, std::size_t count) const = 0;
  double psd(double fx, double fy) const {
    double value;
    evaluate(&fx, &fy, &value, 1);
    return value;
  }

  /// Variance of the heights, um^2; infinite where the integral diverges.
  virtual double variance() const = 0;
  /// Autocovariance at the distance (x, y) um, um^2. Throws Error::Kind::Value where the variance is infinite.
  virtual double autocovariance(double x, double y) const = 0;

  /// What a Gaussian autocovariance is made of (gaussianSpectrum), or nothing.
  struct Gaussian {
    double rms, correlationX, correlationY;  ///< um
  };
  virtual std::optional<Gaussian> gaussian() const { return {}; }

  /// A PSD of a / f^exponent at all frequencies (fractalSpectrum with corner 0), or nothing.
  struct PowerLaw {
    double a, exponent;
  };
  virtual std::optional<PowerLaw> powerLaw() const { return {}; }
  /// The periodogram that the PSD is made of, constant in the cells of its frequencies (measuredSpectrum), or nothing.
  virtual const HeightSpectrum* cells() const { return nullptr; }

  /// Whether the PSD depends on the length of (fx, fy) only.
  virtual bool isotropic() const = 0;
  /// The expression that makes it.
  virtual std::string description() const = 0;
};
using SpectrumPointer = std::shared_ptr<const Spectrum>;

/// K-correlation, or ABC: PSD = a / (1 + (b f)^2)^(c/2), f^2 = fx^2 + fy^2. Variance 2 pi a / (b^2 (c - 2)) for c > 2,
/// infinite else. E. L. Church and P. Z. Takacs, "The optimal estimation of finish parameters", Proc. SPIE 1530, 71-85
/// (1991), doi:10.1117/12.50498: the two-dimensional spectrum with its exponent written c/2. Its autocovariance is
/// variance 2 (u/2)^nu K_nu(u) / Gamma(nu), u = 2 pi r / b, nu = c/2 - 1 (DLMF 10.22.46).
/// `a` in um^4, >= 0; `b` in um, >= 0; `c` > 0.
BRDF_EXPORT SpectrumPointer abcSpectrum(double a, double b, double c);

/// Gaussian autocovariance rms^2 exp(-(x/Lx)^2 - (y/Ly)^2): PSD = pi rms^2 Lx Ly exp(-(pi Lx fx)^2 - (pi Ly fy)^2).
/// `rms` in um, >= 0; the correlation lengths (to 1/e) in um, > 0.
BRDF_EXPORT SpectrumPointer gaussianSpectrum(double rms, double correlationX, double correlationY);

/// Fractal: PSD = a / max(f, corner)^exponent. E. L. Church, "Fractal surface finish", Appl. Opt. 27, 1518-1526 (1988),
/// doi:10.1364/AO.27.001518. With corner 0 the pure power law: infinite at f = 0, with infinite variance. The
/// variance is infinite for exponents up to 2 as well. `a` in um^(4 - exponent), >= 0; `exponent` > 0; `corner` in
/// 1/um, >= 0.
BRDF_EXPORT SpectrumPointer fractalSpectrum(double a, double exponent, double corner);

/// The sum of spectra: uncorrelated kinds of roughness on one surface.
BRDF_EXPORT SpectrumPointer sumOfSpectra(std::vector<SpectrumPointer> parts);

/// A kind of spectrum, written "name(parameter=value, ...)".
struct SpectrumKind {
  std::string name;
  std::string title;                   ///< one line
  std::vector<Parameter> parameters;   ///< numbers
  std::vector<std::string> arguments;  ///< of other kinds, each with its meaning: "file: image of heights"
  std::vector<Reference> references;
  std::function<SpectrumPointer(const Call& call)> make;  ///< throws brdf::Error
};
/// abc, gaussian, fractal, sum, and those added.
BRDF_EXPORT const std::vector<SpectrumKind>& spectrumKinds();
/// Adds a kind; replaces one of the same name. Not while others look spectra up.
BRDF_EXPORT void registerSpectrumKind(SpectrumKind kind);

/// The spectrum that a call means. Throws Error::Kind::Value, Formula or File with the column of the call.
BRDF_EXPORT SpectrumPointer makeSpectrum(const Call& call);
BRDF_EXPORT SpectrumPointer makeSpectrum(std::string_view expression);

}  // namespace brdf
