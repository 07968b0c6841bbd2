#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Graph.h>

namespace brdf::formula {

/// The exact derivatives of `root` with respect to parameters `which` (indices), as nodes of the same graph, built by
/// the chain rule (forward), sharing every common expression with the value. A `select` is differentiated by selecting
/// between the derivatives of its branches, never by multiplying with its condition, so a branch that is not taken may
/// be infinite. Comparisons and floor have derivative 0.
BRDF_EXPORT std::vector<NodeId> derivatives(Graph& graph, NodeId root, const std::vector<std::uint32_t>& which);

}  // namespace brdf::formula
