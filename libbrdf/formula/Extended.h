#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Graph.h>

#include <array>
#include <span>

namespace brdf::formula {

/// One lane of inputs: ux uy uz vx vy vz random1 random2, taken as exact numbers.
using InputLane = std::array<double, static_cast<std::size_t>(Input::Count)>;

/// The graph's `roots` at one lane in 50-digit arithmetic from the same rounded inputs and parameters, rounded to
/// double at the end: what batched evaluation is judged against.
BRDF_EXPORT std::vector<double> evaluateExtended(const Graph& graph, const std::vector<NodeId>& roots,
                                                 const InputLane& inputs, std::span<const double> parameters);

/// d(root)/d(parameter `which`) by a central difference in 50-digit arithmetic (step 1e-15 of the parameter, error
/// about 1e-29 relative): independent of the symbolic derivative, which it checks.
BRDF_EXPORT double differenceExtended(const Graph& graph, NodeId root, const InputLane& inputs,
                                      std::span<const double> parameters, std::size_t which);

}  // namespace brdf::formula
