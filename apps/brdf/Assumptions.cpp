#include "Assumptions.h"

#include <brdf/base/Text.h>

namespace brdf::app {
namespace {

struct Stored {
  ReadOptions options;
  std::vector<std::string> items;
};

Stored& stored() {
  static Stored given;
  return given;
}

}  // namespace

const ReadOptions& assumptions() { return stored().options; }

void setAssumptions(const std::vector<std::string>& items) { stored() = {parseReadOptions(items), items}; }

const std::vector<std::string>& assumptionItems() { return stored().items; }

std::string assumptionsHelp() {
  std::string text = "What a measured file means, against what its format says; several times: ";
  std::vector<std::string> keys;
  for (const ReadOptionKey& key : readOptionKeys()) keys.push_back(key.key + "=" + joined(key.values, "|"));
  return text + joined(keys, ", ");
}

}  // namespace brdf::app
