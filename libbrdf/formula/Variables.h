#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Graph.h>

#include <optional>
#include <span>
#include <string_view>

namespace brdf::formula {

/// A name that every formula may use: how it is made from the inputs, and what it means.
struct Variable {
  std::string_view name;
  std::string_view description;
  NodeId (*make)(Graph& graph);
};

/// All of them. Those made of cancelling differences are written in the unnormalised half vector (Hx, Hy, Hz) = wi +
/// wo, which keeps its digits near the mirror direction; cos_d = |H|/2 and sin2_d = |wi - wo|^2/4 hold for unit
/// directions.
BRDF_EXPORT std::span<const Variable> variables();

/// The node of the variable called `name`, or empty. `random1` and `random2` (samplers only) are among them.
BRDF_EXPORT std::optional<NodeId> makeVariable(Graph& graph, std::string_view name);

}  // namespace brdf::formula
