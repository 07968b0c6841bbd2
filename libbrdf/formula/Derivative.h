#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Graph.h>

namespace brdf::formula {

/// The exact derivative of `root` with respect to the leaf `variable` (a Parameter or a Bound), as a node of the same
/// graph, built by the chain rule (forward), sharing every common expression with the value. A `select` is
/// differentiated by selecting between the derivatives of its branches, never by multiplying with its condition, so a
/// branch that is not taken may be infinite. Comparisons and floor have derivative 0. A `sum` is differentiated term by
/// term, a `solve` by the implicit function theorem.
BRDF_EXPORT NodeId derivative(Graph& graph, NodeId root, NodeId variable);

/// The derivatives with respect to the parameters `which` (indices).
BRDF_EXPORT std::vector<NodeId> derivatives(Graph& graph, NodeId root, const std::vector<std::uint32_t>& which);

}  // namespace brdf::formula
