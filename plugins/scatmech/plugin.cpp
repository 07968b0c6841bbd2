#include "ScatmechBrdf.h"
#include "ScatmechRequest.h"

#include <brdf/base/Plugins.h>
#include <brdf/io/LoadMaterial.h>

namespace {

void registerScatmech(const brdf::PluginContext&) {
  brdf::registerMaterialKind({"scatmech", "scatmech:MODEL(parameter=value, ...), a model of NIST's SCATMECH library",
                              scatmech::scatmechBrdf, scatmech::listModels, scatmech::describeModel});
}

}  // namespace

BRDF_PLUGIN("scatmech", "1.0", registerScatmech)
