#include <brdf/base/Error.h>
#include <brdf/formula/Derivative.h>

#include <numbers>

namespace brdf::formula {
namespace {

[[noreturn]] void noDerivative(const std::string& what) {
  throw Error(Error::Kind::Formula, {what + " is not offered", "derivative", {}, {}});
}

/// dP(a, x)/dx = exp(-x) x^(a-1)/Gamma(a), counted as 0 at x = 0.
NodeId gammaDensity(Graph& g, NodeId a, NodeId x) {
  const NodeId zero = g.constant(0);
  const NodeId power = g.mul(g.sub(a, g.constant(1)), g.make(Op::Log, x));
  const NodeId exponent = g.sub(g.sub(power, x), g.make(Op::Lgamma, a));
  return g.select(g.make(Op::Less, zero, x), g.make(Op::Exp, exponent), zero);
}

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
    case Op::Digamma:
      return g.mul(d[0], g.make(Op::Trigamma, a));
    case Op::BesselJ0:
      return g.neg(g.mul(d[0], g.make(Op::BesselJ1, a)));
    case Op::BesselI0:
      return g.mul(d[0], g.make(Op::BesselI1, a));
    case Op::BesselK0:
      return g.neg(g.mul(d[0], g.make(Op::BesselK1, a)));
    case Op::BesselJ1:
    case Op::BesselI1: {
      // f1' = f0 - f1/x (DLMF 10.6.2, 10.29.2), 1/2 at 0.
      const NodeId f0 = g.make(node.op == Op::BesselJ1 ? Op::BesselJ0 : Op::BesselI0, a);
      const NodeId slope = g.select(g.make(Op::Equal, a, zero), g.constant(0.5), g.sub(f0, g.div(id, a)));
      return g.mul(d[0], slope);
    }
    case Op::BesselK1:
      return g.neg(g.mul(d[0], g.add(g.make(Op::BesselK0, a), g.div(id, a))));
    case Op::GammaP:
    case Op::GammaQ: {
      const NodeId byA = g.isConstant(d[0], 0) ? zero : g.mul(d[0], g.make(Op::GammaPDa, a, b));
      const NodeId slope = g.add(byA, g.mul(d[1], gammaDensity(g, a, b)));
      return node.op == Op::GammaP ? slope : g.neg(slope);
    }
    case Op::GammaPDa: {
      // d^2P/(dx da) = density (log x - digamma a)
      if (!g.isConstant(d[0], 0)) noDerivative("the second derivative of gammap by its first argument");
      const NodeId logarithm = guarded(b, g.sub(g.make(Op::Log, b), g.make(Op::Digamma, a)));
      return g.mul(d[1], g.mul(gammaDensity(g, a, b), logarithm));
    }
    case Op::Trigamma:
      noDerivative("the derivative of trigamma");
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
  // What the root's derivative needs: not that of a Solve's own slope.
  std::vector<bool> needed(root + 1, false);
  needed[root] = true;
  for (NodeId id = root + 1; id-- > 0;)
    for (int k = 0; needed[id] && k < arity(graph[id].op) && !(graph[id].op == Op::Solve && k == 3); ++k)
      needed[graph[id].operands[k]] = true;
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
