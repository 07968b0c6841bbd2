#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/Microsurface.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A facet as people write it; numbers are one for all channels, or one a channel separated by blanks (or "(0.2,
/// 0.9, 1.1)"):
/// - "mirror"
/// - "conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)": refractive index eta + i k
/// - "dielectric(eta=1.5, absorption=0.01)": absorption (default 0) in 1 / micrometre
/// - "lambertian(albedo=0.5)"
/// - "scattering(MATERIAL)": any material expression, file or preset (io/LoadMaterial.h)
/// Throws Error::Kind::Formula or Error::Kind::Value with the column of what is wrong (base/Call.h).
BRDF_EXPORT Facet parseFacet(std::string_view text);
/// The expression that reads back.
BRDF_EXPORT std::string facetText(const Facet& facet);

/// The channels that facets and nothing else determine: monochrome where all have one number, RGB where some have
/// three, the wavelengths of a spectral BRDF. Throws Error::Kind::Value where they disagree.
BRDF_EXPORT Channels facetChannels(const std::vector<Facet>& facets);

/// For help: the forms above, one line each.
BRDF_EXPORT const std::vector<std::string>& facetForms();

}  // namespace brdf
