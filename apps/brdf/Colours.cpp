#include "Colours.h"

#include <brdf/base/Text.h>

#include <nlohmann/json.hpp>

namespace brdf::app {

void declareColours(Arguments& arguments, ColourNames& names, bool luminance) {
  arguments.option("--illuminant", names.illuminant, "NAME",
                   "The light under which spectral data are seen: " + joined(illuminantNames()) +
                       ", or a file of wavelengths (nm) and powers such as lamp.csv " +
                       (luminance ? "[D65; luminance: E]" : "[D65]"));
  arguments.choice("--observer", names.observer, {"2", "10"}, "Whose eye, degrees: CIE 1931 or CIE 1964");
  arguments.choice("--adaptation", names.adaptation, {"bradford", "none"},
                   "Whether a white stays white under another light than D65");
}

nlohmann::ordered_json coloursJson(const ColourNames& names) {
  return {{"illuminant", names.illuminant.empty() ? "D65" : names.illuminant},
          {"observer", names.observer},
          {"adaptation", names.adaptation}};
}

}  // namespace brdf::app
