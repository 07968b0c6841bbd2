#include "Targets.h"

#include "ContainerEdits.h"

#include <brdf/base/Error.h>
#include <brdf/fit/StoredFit.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/BrdfLabXml.h>
#include <brdf/io/MaterialXml.h>
#include <brdf/io/StoredGrid.h>
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

/// Reads all of a container; an entry that is no good leaves the others to be read.
void readContainer(std::string_view bytes) {
  swallowErrors([&] {
    const brdf::Container container = brdf::Container::fromBytes(bytes, "fuzz");
    for (std::size_t i = 0; i < std::min<std::size_t>(container.entries().size(), 4); ++i) {
      swallowErrors([&] { use(*container.load(i)); });
      swallowErrors([&] { container.provenance(i); });
      swallowErrors([&] {
        for (const brdf::ScatterComponent& part : container.components(i).scatter) use(*part.brdf);
      });
      swallowErrors([&] {
        if (container.entries()[i].isFit) use(*brdf::loadFit(container, i).material);
      });
      swallowErrors([&] {
        const brdf::StoredTable table(container, i);
        table.values(0, table.slices() - 1, 1);
        table.states(0, table.slices());
      });
    }
  });
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
  targets.push_back({"container", readContainer});
  targets.push_back({"container-edits", [](std::string_view bytes) { readContainer(editedContainer(bytes)); }});
  targets.push_back({"expression", [](std::string_view bytes) {
                       swallowErrors([&] { use(*brdf::parseMaterialExpression(bytes)); });
                     }});
  return targets;
}
