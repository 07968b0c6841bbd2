#pragma once
#include <brdf/brdf_export.h>
#include <brdf/fit/Fit.h>

#include <string_view>
#include <vector>

namespace brdf {

/// The lobes to fit from one line: lobes joined by '+' as in a material expression, without scale factors (they are
/// fitted); parameters written there are starting values, one number each. Example: "Lambertian + GGX(alpha=0.1)".
/// Throws Error::Kind::Formula as parseMaterialExpression does, and Error::Kind::Usage for a factor or a list of
/// values.
BRDF_EXPORT std::vector<LobeRequest> parseLobeRequests(std::string_view text);

/// Holds a parameter at a value: "name=value" in every lobe that has it, "Lobe.name=value" in the lobes of that model;
/// the name "scale" means a lobe's factor. Throws Error::Kind::Usage for another form, Error::Kind::Value when no lobe
/// has the parameter or the value is out of its bounds.
BRDF_EXPORT void holdParameter(std::vector<LobeRequest>& requests, std::string_view text);

/// Keeps two parameters equal. In one lobe: "name=leader" in every lobe that has both, "Lobe.name=leader" or
/// "Lobe.name=Lobe.leader" in the lobes of that model. Of two lobes: "Lobe.name=Other.leader", a lobe being a model's
/// name, with a number from 1 where the sum has several of it ("GGX#2.alpha=GGX#1.alpha"). Throws Error::Kind::Usage for
/// another form, Error::Kind::Value for lobes or parameters that are not there.
BRDF_EXPORT void tieParameter(std::vector<LobeRequest>& requests, std::string_view text);

/// Requests that start where a material is: its lobes, with their parameters as starting values (of a parameter that
/// differs between channels the mean).
BRDF_EXPORT std::vector<LobeRequest> requestsFrom(const LobeSum& material);

}  // namespace brdf
