#include <brdf/formula/Derivative.h>

#include <numbers>

namespace brdf::formula {
namespace {

/// d(node) given the derivatives of its operands.
NodeId chainRule(Graph& g, NodeId id, const NodeId* d) {
  const Node node = g[id];  // a copy: making nodes moves the storage
  const NodeId a = node.operands[0], b = node.operands[1];
  const NodeId zero = g.constant(0), one = g.constant(1);
  // A factor that is infinite at the edge of its domain counts as 0 there, so that 0 * Inf does not appear.
  const auto guarded = [&](NodeId inside, NodeId factor) {
    return g.select(g.make(Op::Less, zero, inside), factor, zero);
  };
  switch (node.op) {
    case Op::Neg:
      return g.neg(d[0]);
    case Op::Abs:
      return g.select(g.make(Op::Less, a, zero), g.neg(d[0]), d[0]);
    case Op::Sqrt:
      return g.mul(d[0], guarded(a, g.div(g.constant(0.5), id)));
    case Op::Exp:
      return g.mul(d[0], id);
    case Op::Expm1:
      return g.mul(d[0], g.add(id, one));
    case Op::Log:
      return g.div(d[0], a);
    case Op::Log1p:
      return g.div(d[0], g.add(one, a));
    case Op::Sin:
      return g.mul(d[0], g.make(Op::Cos, a));
    case Op::Cos:
      return g.neg(g.mul(d[0], g.make(Op::Sin, a)));
    case Op::Tan:
      return g.mul(d[0], g.add(one, g.mul(id, id)));
    case Op::Asin:
    case Op::Acos: {
      const NodeId inside = g.mul(g.sub(one, a), g.add(one, a));
      const NodeId slope = g.mul(d[0], guarded(inside, g.div(one, g.sqrt(inside))));
      return node.op == Op::Asin ? slope : g.neg(slope);
    }
    case Op::Atan:
      return g.div(d[0], g.add(one, g.mul(a, a)));
    case Op::Sinh:
      return g.mul(d[0], g.make(Op::Cosh, a));
    case Op::Cosh:
      return g.mul(d[0], g.make(Op::Sinh, a));
    case Op::Tanh:
      return g.mul(d[0], g.sub(one, g.mul(id, id)));
    case Op::Erf:
    case Op::Erfc: {
      // d erf(x)/dx = 2/sqrt(pi) exp(-x^2)
      const NodeId slope =
          g.mul(g.mul(g.constant(2 * std::numbers::inv_sqrtpi), d[0]), g.make(Op::Exp, g.neg(g.mul(a, a))));
      return node.op == Op::Erf ? slope : g.neg(slope);
    }
    case Op::Lgamma:
      return g.mul(d[0], g.make(Op::Digamma, a));
    case Op::Add:
      return g.add(d[0], d[1]);
    case Op::Sub:
      return g.sub(d[0], d[1]);
    case Op::Mul:
      return g.add(g.mul(d[0], b), g.mul(a, d[1]));
    case Op::Div:
      return g.div(g.sub(d[0], g.mul(id, d[1])), b);
    case Op::Pow: {
      const NodeId byBase = g.mul(d[0], g.mul(b, g.make(Op::Pow, a, g.sub(b, one))));
      const NodeId byExponent = g.isConstant(d[1], 0) ? zero : g.mul(d[1], guarded(a, g.mul(id, g.make(Op::Log, a))));
      return g.add(byBase, byExponent);
    }
    case Op::Min:
      return g.select(g.make(Op::LessEqual, a, b), d[0], d[1]);
    case Op::Max:
      return g.select(g.make(Op::LessEqual, b, a), d[0], d[1]);
    case Op::Atan2:
      return g.div(g.sub(g.mul(d[0], b), g.mul(a, d[1])), g.add(g.mul(a, a), g.mul(b, b)));
    case Op::Select:
      return g.select(a, d[1], d[2]);
    case Op::Table:
      return g.add(g.mul(d[0], g.lookUp(Op::TableDx, g.table(node.index), a, b)),
                   g.mul(d[1], g.lookUp(Op::TableDy, g.table(node.index), a, b)));
    case Op::Sum:
      return g.sum(g.boundNode(node.index), a, b, d[2], node.value);
    case Op::Solve: {
      // f(x(p), p) = 0: dx/dp = -(df/dp)/(df/dx), both at the root.
      const NodeId variable = g.boundNode(node.index);
      const NodeId byParameter = g.substitute(d[2], variable, id);
      return g.neg(g.div(byParameter, g.substitute(node.operands[3], variable, id)));
    }
    default:
      return zero;  // leaves other than the parameter itself, comparisons, floor
  }
}

}  // namespace

NodeId derivative(Graph& graph, NodeId root, NodeId variable) {
  const std::vector<bool> needed = graph.reachable({root});
  const NodeId zero = graph.constant(0), one = graph.constant(1);
  std::vector<NodeId> slope(root + 1, zero);
  for (NodeId id = 0; id <= root; ++id) {
    if (!needed[id]) continue;
    const Node& node = graph[id];
    if (id == variable) {
      slope[id] = one;
      continue;
    }
    NodeId operandSlopes[4] = {zero, zero, zero, zero};
    bool any = false;
    for (int k = 0; k < arity(node.op); ++k) {
      operandSlopes[k] = slope[node.operands[k]];
      any = any || operandSlopes[k] != zero;
    }
    if (any) slope[id] = chainRule(graph, id, operandSlopes);
  }
  return slope[root];
}

std::vector<NodeId> derivatives(Graph& graph, NodeId root, const std::vector<std::uint32_t>& which) {
  std::vector<NodeId> results;
  for (const std::uint32_t index : which) results.push_back(derivative(graph, root, graph.parameter(index)));
  return results;
}

}  // namespace brdf::formula
