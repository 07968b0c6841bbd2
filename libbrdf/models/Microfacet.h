#pragma once
#include <brdf/brdf_export.h>
#include <brdf/models/Model.h>
#include <brdf/models/Parameter.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// Names of the distributions D, Fresnel terms F and shadowing terms G that compose (models/components/components.xml).
struct MicrofacetTerms {
  std::vector<std::string> distributions, fresnels, shadowings;
};
BRDF_EXPORT const MicrofacetTerms& microfacetTerms();

/// One of those terms: the call that computes it, in its parameters and those of its distribution.
struct MicrofacetTerm {
  std::string name;
  std::string call;  ///< formula; "smith" stands for the distribution's own
  std::vector<Parameter> parameters;
  std::string smith;                          ///< of a distribution: its Smith visibility
  std::string sampler;                        ///< of a distribution: name of the sampler that covers it
  std::vector<std::string> samplerArguments;  ///< of a distribution: formulas
};
/// The terms of a kind, 'D', 'F' or 'G', in the file's order.
BRDF_EXPORT const std::vector<MicrofacetTerm>& microfacetTermsOf(char kind);

/// The model f = D F G/(4 cos_i cos_o) of the named terms, called "Microfacet_<D>_<F>_<G>"; its parameters are those of
/// D, then of F. G = Smith is the height-correlated Smith term of the distribution, SmithSeparable the product of its two
/// directions' terms. Composed once and kept. Throws Error::Kind::Value for an unknown term, with the nearest or all names.
BRDF_EXPORT ModelPointer composeMicrofacet(std::string_view distribution, std::string_view fresnel,
                                           std::string_view shadowing);

/// The same from the composed name, or null when `name` is not of that form.
BRDF_EXPORT ModelPointer findMicrofacet(std::string_view name);

}  // namespace brdf
