#pragma once
#include "Arguments.h"

#include <brdf/color/ColourSettings.h>

#include <nlohmann/json_fwd.hpp>

namespace brdf::app {

/// Declares --illuminant, --observer and --adaptation, which say how spectral data become colours; `names` must outlive
/// the parsing. `luminance`: the command shows luminance, too.
void declareColours(Arguments& arguments, ColourNames& names, bool luminance = false);

/// For reports: {"illuminant", "observer", "adaptation"}.
nlohmann::ordered_json coloursJson(const ColourNames& names);

}  // namespace brdf::app
