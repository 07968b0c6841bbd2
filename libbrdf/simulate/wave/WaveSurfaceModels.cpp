#include <brdf/simulate/wave/Roughness.h>
#include <brdf/simulate/wave/WaveEntries.h>

#include <algorithm>

namespace brdf::wave {
namespace {

const WaveArgument kSpectrumArgument{"spectrum", "spectrum", "Power spectral density of the heights.", "gaussian", {}};

/// One a wavelength, of its substrate's index.
template <class Make>
Models roughness(WaveReader& reader, Make&& make) {
  const std::vector<Complex> substrate = reader.indices(kEta.defaultValue, 0);
  Models models;
  for (std::size_t c = 0; c < substrate.size(); ++c) {
    if (substrate[c] == 1.0) reader.arguments().fail("eta", "the substrate is air", "1", "another index");
    models.push_back(make(substrate[c], reader.wavelengths()[c]));
  }
  return models;
}

/// One transform serves all wavelengths.
PhaseTransformPointer transformOf(const SpectrumPointer& spectrum, const WaveReader& reader) {
  return PhaseTransform::of(spectrum, *std::ranges::min_element(reader.wavelengths()));
}

Entry rayleighRiceEntry() {
  return {
      {"model",
       "RayleighRice",
       "Slightly rough interface, first-order vector perturbation",
       "Heights small against the wavelength: (4 pi rms cos theta_i / wavelength)^2 << 1. Polarised; any slopes that "
       "go with such heights.",
       {kEta, kK},
       {kIndexArgument, kSpectrumArgument},
       {{"S. O. Rice", 1951, "Reflection of electromagnetic waves from slightly rough surfaces",
         "Commun. Pure Appl. Math. 4, 351-378", "10.1002/cpa.3160040206", ""},
        {"D. E. Barrick", 1970, "Rough surfaces", "Radar Cross Section Handbook (Plenum), chapter 9", "", ""},
        {"J. M. Elson and J. M. Bennett", 1979, "Vector scattering theory", "Opt. Eng. 18, 116-124",
         "10.1117/12.7972335", ""}}},
      [](WaveReader& reader) {
        const SpectrumPointer spectrum = reader.spectrum();
        return roughness(reader,
                         [&](Complex index, double wavelength) { return rayleighRice(spectrum, index, wavelength); });
      }};
}

Entry harveyShackEntry() {
  return {
      {"model",
       "HarveyShack",
       "Rough interface, generalised Harvey-Shack",
       "Any height, moderate slopes, large angles; amplitudes of polarisation as Rayleigh and Rice's, with which it "
       "agrees for small heights where theta_s is near theta_i. Spectra of finite variance, and power laws of "
       "exponents between 2 and 4. roughness=relevant and energy=renormalized are not reciprocal.",
       {kEta, kK},
       {kIndexArgument,
        kSpectrumArgument,
        {"roughness", "text", "What counts: all heights, or frequencies that scatter.", "total", {"total", "relevant"}},
        {"energy",
         "text",
         "As it comes, or what evanescent waves take is given to the others.",
         "plain",
         {"plain", "renormalized"}}},
       {{"A. Krywonos, J. E. Harvey and N. Choi", 2011,
         "Linear systems formulation of scattering theory for rough surfaces with arbitrary incident and scattering "
         "angles",
         "J. Opt. Soc. Am. A 28, 1121-1138", "10.1364/JOSAA.28.001121", ""},
        {"V. E. Johansen", 2015,
         "Preparing the generalized Harvey-Shack rough surface scattering method for use with the discrete ordinates "
         "method",
         "J. Opt. Soc. Am. A 32, 186-194", "10.1364/JOSAA.32.000186", "(7), (15) to (20) of the preprint"}}},
      [](WaveReader& reader) {
        const SpectrumPointer spectrum = reader.spectrum();
        const PhaseTransformPointer transform = transformOf(spectrum, reader);
        HarveyShackOptions options;
        options.relevant = reader.arguments().choice("roughness", {"total", "relevant"}) == "relevant";
        options.renormalized = reader.arguments().choice("energy", {"plain", "renormalized"}) == "renormalized";
        return roughness(reader, [&](Complex index, double wavelength) {
          return harveyShack(spectrum, transform, index, wavelength, options);
        });
      }};
}

Entry beckmannEntry() {
  return {
      {"model",
       "BeckmannKirchhoff",
       "Rough surface, Kirchhoff's approximation",
       "Any height, slopes small enough that curvature radii exceed the wavelength; paraxial in its original form, "
       "whose factor F diverges at grazing angles; modified: F = 1. Fresnel's reflectance at the half angle.",
       {kEta, kK},
       {kIndexArgument,
        kFilmsArgument,
        kSpectrumArgument,
        {"form", "text", "Of the factor F.", "original", {"original", "modified"}}},
       {{"P. Beckmann and A. Spizzichino", 1963, "The Scattering of Electromagnetic Waves from Rough Surfaces",
         "Pergamon Press, section 5.3", "", ""},
        {"J. E. Harvey, A. Krywonos and C. L. Vernold", 2007,
         "Modified Beckmann-Kirchhoff scattering model for rough surfaces with large incident and scattering angles",
         "Opt. Eng. 46, 078002", "10.1117/1.2752180", ""}}},
      [](WaveReader& reader) {
        const std::vector<FilmStack> stacks = reader.stacks(reader.indices(kEta.defaultValue, 0));
        const SpectrumPointer spectrum = reader.spectrum();
        const PhaseTransformPointer transform = transformOf(spectrum, reader);
        const bool modified = reader.arguments().choice("form", {"original", "modified"}) == "modified";
        Models models;
        for (std::size_t c = 0; c < stacks.size(); ++c)
          models.push_back(beckmannKirchhoff(spectrum, transform, stacks[c], reader.wavelengths()[c], modified));
        return models;
      }};
}

Entry facetEntry() {
  return {{"model",
           "Facet",
           "Mirror facets with a distribution of slopes",
           "Rough against the wavelength, slopes of long curvature; one reflection. Without shadowing it grows without "
           "bound at grazing angles.",
           {kEta, kK},
           {kIndexArgument,
            kFilmsArgument,
            {"slopes", "slopes", "Distribution of the facets' slopes.", "gaussian", {}},
            {"shadowing", "shadowing", "What part of the facets is seen.", "none", {}}},
           {{"D. E. Barrick", 1968, "Rough surface scattering based on the specular point theory",
             "IEEE Trans. Antennas Propag. 16, 449-454", "10.1109/TAP.1968.1139220", "(2), (9)"},
            {"K. E. Torrance and E. M. Sparrow", 1967, "Theory for off-specular reflection from roughened surfaces",
             "J. Opt. Soc. Am. 57, 1105-1114", "10.1364/JOSA.57.001105", ""}}},
          [](WaveReader& reader) {
            const std::vector<FilmStack> stacks = reader.stacks(reader.indices(kEta.defaultValue, 0));
            const SlopePointer slopes = reader.slopes();
            const ShadowingPointer shadowing = reader.shadowing();
            Models models;
            for (const FilmStack& stack : stacks) models.push_back(facets(slopes, shadowing, stack));
            return models;
          }};
}

}  // namespace

std::vector<Entry> surfaceEntries() { return {rayleighRiceEntry(), harveyShackEntry(), beckmannEntry(), facetEntry()}; }

}  // namespace brdf::wave
