#pragma once
#include <brdf/simulate/wave/FilmStack.h>
#include <brdf/simulate/wave/Mie.h>
#include <brdf/simulate/wave/ScatterModel.h>

#include <memory>

namespace brdf::wave {

/// Amplitudes of a particle that looks the same from everywhere, in the convention of MieSphere::amplitudes.
class BRDF_EXPORT Scatterer {
 public:
  virtual ~Scatterer();
  virtual void amplitudes(double cosine, Complex& s1, Complex& s2) const = 0;
  virtual double scatteringCrossSection() const = 0;  ///< um^2
  virtual double extinctionCrossSection() const = 0;  ///< um^2
};
using ScattererPointer = std::shared_ptr<const Scatterer>;

/// `radius` and `wavelength` (in vacuum) in micrometres; `medium`: real index around the sphere.
BRDF_EXPORT ScattererPointer mieScatterer(double radius, Complex sphere, double medium, double wavelength);
/// The limit of small spheres: S1 = -i x^3 (m^2 - 1)/(m^2 + 2), S2 = S1 cos(angle); Bohren and Huffman (1983),
/// section 5.1, with its (5.8) for scattering and (5.11) to lowest order for absorption.
BRDF_EXPORT ScattererPointer rayleighScatterer(double radius, Complex sphere, double medium, double wavelength);

/// Spheres above a plane, independent of each other: direct scattering, scattering of the reflected light, reflection
/// of the scattered light, and both, added with their phases; no further multiple scattering between sphere and plane.
/// T. A. Germer, Appl. Opt. 36, 8798-8805 (1997), doi:10.1364/AO.36.008798.
/// `density` a um^2; `distance` of the centre above the surface, um. BRDF = density dC/dOmega / (cos_i cos_s).
BRDF_EXPORT ScatterModelPointer doubleInteraction(ScattererPointer scatterer, FilmStack stack, double density,
                                                  double distance, double wavelength);

/// Spheres under a plane, in a substrate that does not absorb: light is refracted in, scattered once and refracted out;
/// what comes back from the surface is not scattered again. Same source. How deep they lie does not matter.
BRDF_EXPORT ScatterModelPointer subsurfaceParticle(ScattererPointer scatterer, FilmStack stack, double density,
                                                   double wavelength);

/// `model` as SCATMECH (the library of NIST) evaluates its particle models: where the plane of scattering is that of
/// incidence or normal to it, at an angle of incidence 2.5e-5 radians greater (both: 5e-5), no polar angle below 1e-5,
/// over the cosine of the angle asked for. Differs from `model` by up to 5e-5 of its value; for comparisons only.
BRDF_EXPORT ScatterModelPointer movedIncidence(ScatterModelPointer model);

/// Angular distribution of single scattering, per solid angle, over the whole sphere 1.
class BRDF_EXPORT PhaseFunction {
 public:
  virtual ~PhaseFunction();
  virtual double value(double cosine) const = 0;
};
using PhaseFunctionPointer = std::shared_ptr<const PhaseFunction>;

/// (1 - g^2) / (1 + g^2 - 2 g cos)^(3/2) / (4 pi). L. G. Henyey and J. L. Greenstein, Astrophys. J. 93, 70-83 (1941),
/// doi:10.1086/144246.
BRDF_EXPORT PhaseFunctionPointer henyeyGreenstein(double g);
BRDF_EXPORT PhaseFunctionPointer isotropicPhase();
/// 3 (1 + cos^2) / (16 pi).
BRDF_EXPORT PhaseFunctionPointer rayleighPhase();
/// K (1 + g^2 - 2 g cos)^-(alpha + 1), K = alpha g / (pi ((1-g)^(-2 alpha) - (1+g)^(-2 alpha))): Henyey and
/// Greenstein's for alpha = 1/2. L. O. Reynolds and N. J. McCormick, J. Opt. Soc. Am. 70, 1206-1212 (1980),
/// doi:10.1364/JOSA.70.001206.
BRDF_EXPORT PhaseFunctionPointer reynoldsMcCormick(double g, double alpha);

/// Light scattered once in a semi-infinite medium under a smooth surface, depolarised: refraction in, single scattering
/// with `scattering` and `absorption` coefficients (1/um), refraction out. Within the medium the first order of S.
/// Chandrasekhar, Radiative Transfer (1960), section 47; refraction and solid angles as in T. A.
/// Germer, "Polarized light diffusely scattered under smooth and rough interfaces", Proc. SPIE 5158, 193-204 (2003),
/// doi:10.1117/12.505976.
BRDF_EXPORT ScatterModelPointer firstDiffuse(PhaseFunctionPointer phase, FilmStack stack, double scattering,
                                             double absorption);

/// reflectance / pi, unpolarised whatever comes in.
BRDF_EXPORT ScatterModelPointer lambertian(double reflectance);

}  // namespace brdf::wave
