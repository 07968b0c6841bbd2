#pragma once
#include <brdf/brdf_export.h>
#include <brdf/models/Model.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// Names of the distributions D, Fresnel terms F and shadowing terms G that compose (models/components/components.xml).
struct MicrofacetTerms {
  std::vector<std::string> distributions, fresnels, shadowings;
};
BRDF_EXPORT const MicrofacetTerms& microfacetTerms();

/// The model f = D F G/(4 cos_i cos_o) of the named terms, called "Microfacet_<D>_<F>_<G>"; its parameters are those of
/// D, then of F. G = Smith is the height-correlated Smith term of the distribution. Composed once and kept. Throws
/// Error::Kind::Value for an unknown term, with the nearest or all names.
BRDF_EXPORT ModelPointer composeMicrofacet(std::string_view distribution, std::string_view fresnel,
                                           std::string_view shadowing);

/// The same from the composed name, or null when `name` is not of that form.
BRDF_EXPORT ModelPointer findMicrofacet(std::string_view name);

}  // namespace brdf
