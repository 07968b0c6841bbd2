#include "Pictures.h"

#include <vtkBRDFShaderProbe.h>

#include <memory>

namespace brdf::app {

GlslRunner shaderProbe() {
  return [probe = std::make_shared<vtkBRDFShaderProbe>()](const std::string& functions,
                                                          const std::vector<GlslColumn>& columns,
                                                          const std::vector<std::string>& expressions) {
    std::vector<vtkBRDFShaderProbe::Column> inputs;
    for (const GlslColumn& column : columns) inputs.push_back({column.name, column.values});
    return probe->Evaluate(functions, inputs, expressions);
  };
}

}  // namespace brdf::app
