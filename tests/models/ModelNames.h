#pragma once
#include <brdf/models/Model.h>

#include <string>
#include <vector>

namespace brdf::test {

/// Names of all registered models, for parameterized tests.
inline std::vector<std::string> modelNames() {
  std::vector<std::string> names;
  for (const ModelPointer& model : allModels()) names.push_back(model->name());
  return names;
}

}  // namespace brdf::test
