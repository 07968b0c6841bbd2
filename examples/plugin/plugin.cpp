#include "Workshop.h"

#include <brdf/base/Plugins.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/models/Registry.h>

namespace {

void registerWorkshop(const brdf::PluginContext& context) {
  brdf::registerFormat(workshop::goniometerFormat());
  brdf::registerMetric(workshop::fourthRootMetric());
  brdf::registerOptimizer(
      {"compass", "compass search (Kolda, Lewis, Torczon 2003)", false, false, workshop::compassSearch});
  brdf::registerMaterialKind(
      {"turned", "turned:DEGREES,MATERIAL, a material turned about its normal", workshop::turnedBrdf});
  brdf::registerSurfaceKind(workshop::roofsSurface());
  auto lobes = context.file;
  brdf::loadModelFolder(lobes.replace_extension(".lobes"));
}

}  // namespace

BRDF_PLUGIN("workshop", "1.0", registerWorkshop)
