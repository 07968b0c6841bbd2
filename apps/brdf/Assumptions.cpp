#include "Assumptions.h"

#include <brdf/base/Text.h>

namespace brdf::app {
namespace {

ReadOptions& stored() {
  static ReadOptions options;
  return options;
}

}  // namespace

const ReadOptions& assumptions() { return stored(); }

void setAssumptions(const std::vector<std::string>& items) { stored() = parseReadOptions(items); }

std::string assumptionsHelp() {
  std::string text = "What a measured file means, against what its format says; several times: ";
  std::vector<std::string> keys;
  for (const ReadOptionKey& key : readOptionKeys()) keys.push_back(key.key + "=" + joined(key.values, "|"));
  return text + joined(keys, ", ");
}

}  // namespace brdf::app
