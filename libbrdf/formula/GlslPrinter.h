#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Graph.h>

#include <array>
#include <string>

namespace brdf::formula {

struct GlslNames {
  /// GLSL expression for each Input, in its order; empty where the shader has none.
  std::array<std::string, static_cast<std::size_t>(Input::Count)> inputs{"wi.x", "wi.y", "wi.z", "wo.x",
                                                                         "wo.y", "wo.z", "u.x",  "u.y"};
  std::vector<std::string> parameters;  ///< GLSL name of each parameter
};

struct GlslBody {
  std::string functions;             ///< look-ups of the tables used, guarded against being defined twice; go before
  std::string statements;            ///< declarations of the intermediate values, one a line, indented by two blanks
  std::vector<std::string> outputs;  ///< a float expression for each output, valid after the statements
};

/// The nodes `outputs` as GLSL 3.30 core. Functions of known accuracy come from glslPrelude().
BRDF_EXPORT GlslBody printGlsl(const Graph& graph, const std::vector<NodeId>& outputs, const GlslNames& names);

/// Functions that printed bodies call: brdf_log, brdf_pow, ... (formula/prelude.glsl).
BRDF_EXPORT std::string glslPrelude();

}  // namespace brdf::formula
