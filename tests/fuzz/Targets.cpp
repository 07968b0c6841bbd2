#include "Targets.h"

#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/BrdfLabXml.h>
#include <brdf/io/MaterialXml.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/SampleSet.h>
#include <brdf/measured/Format.h>

#include <algorithm>

namespace {

/// Uses a BRDF as its first users do: evaluates it, and reads its first samples.
void use(const brdf::Brdf& material) {
  material.evaluate(brdf::fromSpherical(0.5, 0.1), brdf::fromSpherical(0.4, 3));
  material.evaluate({0, 0, 1}, {0, 0, 1});
  if (const brdf::SampleSet* samples = material.samples()) {
    const std::size_t count = std::min<std::size_t>(samples->count(), 64);
    std::vector<double> values(count * material.channels().count());
    std::vector<std::uint8_t> valid(count);
    brdf::DirectionPairBuffer<double> pairs;
    samples->read(0, count, &pairs, values.data(), valid.data());
  }
}

void swallowErrors(const std::function<void()>& action) {
  try {
    action();
  } catch (const brdf::Error&) {  // the right answer to a damaged file
  }
}

}  // namespace

std::vector<FuzzTarget> fuzzTargets() {
  std::vector<FuzzTarget> targets;
  for (const brdf::Format& format : brdf::allFormats()) {
    if (!format.read) continue;
    targets.push_back({format.name, [format](std::string_view bytes) {
                         format.recognise(bytes.substr(0, 8192), bytes.size());
                         swallowErrors([&] {
                           const brdf::ReadResult result = format.read(bytes, "fuzz", {});
                           if (result.brdf) use(*result.brdf);
                         });
                       }});
  }
  targets.push_back({"material-xml", [](std::string_view bytes) {
                       swallowErrors([&] { use(*brdf::readMaterialXml(bytes, "fuzz")); });
                     }});
  targets.push_back({"brdflab-xml", [](std::string_view bytes) {
                       swallowErrors([&] {
                         const brdf::BrdfLabFile file = brdf::readBrdfLabXml(bytes, "fuzz");
                         if (file.analytic) use(*file.analytic);
                         for (const auto& fitting : file.fittings) use(*fitting.material);
                       });
                     }});
  targets.push_back({"expression", [](std::string_view bytes) {
                       swallowErrors([&] { use(*brdf::parseMaterialExpression(bytes)); });
                     }});
  return targets;
}
