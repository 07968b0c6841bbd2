#include <brdf/formula/Extended.h>
#include <brdf/formula/PlainOperations.h>
#include <brdf/formula/Table.h>

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/expm1.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace brdf::formula {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;

/// Poles and overflow give infinity or NaN, as in every other evaluator, instead of an exception.
namespace policies = boost::math::policies;
using Quiet =
    policies::policy<policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
                     policies::overflow_error<policies::ignore_error>,
                     policies::evaluation_error<policies::ignore_error>>;

Wide wideLog(const Wide& a) {
  if (a == 0) return -std::numeric_limits<Wide>::infinity();
  return a < 0 ? std::numeric_limits<Wide>::quiet_NaN() : Wide(log(a));
}

Wide widePow(const Wide& a, const Wide& b) {
  if (b == 0) return 1;
  if (a == 0) return b > 0 ? Wide(0) : std::numeric_limits<Wide>::infinity();
  return pow(a, b);
}

/// P(a, x) or Q(a, x).
Wide incompleteGamma(Op op, const Wide& a, const Wide& x) {
  if (!(a > 0) || !(x >= 0) || isinf(a)) return std::numeric_limits<Wide>::quiet_NaN();
  if (isinf(x)) return op == Op::GammaP ? 1 : 0;
  return op == Op::GammaP ? boost::math::gamma_p(a, x, Quiet{}) : boost::math::gamma_q(a, x, Quiet{});
}

/// dP/da by a central difference: step 1e-12 of a, error about 1e-24 relative. Of Q above the mean, where P loses its
/// digits.
Wide incompleteGammaSlope(const Wide& a, const Wide& x) {
  const Wide step = Wide("1e-12") * a;
  const Op op = x < a ? Op::GammaP : Op::GammaQ;
  const Wide difference = incompleteGamma(op, a + step, x) - incompleteGamma(op, a - step, x);
  return (op == Op::GammaP ? difference : Wide(-difference)) / (2 * step);
}

Wide bessel(Op op, const Wide& x) {
  const bool isK = op == Op::BesselK0 || op == Op::BesselK1;
  if (isnan(x) || (isK && x < 0)) return std::numeric_limits<Wide>::quiet_NaN();
  if (isK && x == 0) return std::numeric_limits<Wide>::infinity();
  if (isinf(x)) return isK || op == Op::BesselJ0 || op == Op::BesselJ1 ? Wide(0) : op == Op::BesselI0 ? abs(x) : x;
  switch (op) {
    case Op::BesselJ0:
      return boost::math::cyl_bessel_j(0, x, Quiet{});
    case Op::BesselJ1:
      return boost::math::cyl_bessel_j(1, x, Quiet{});
    case Op::BesselI0:
      return boost::math::cyl_bessel_i(0, x, Quiet{});
    case Op::BesselI1:
      return boost::math::cyl_bessel_i(1, x, Quiet{});
    case Op::BesselK0:
      return boost::math::cyl_bessel_k(0, x, Quiet{});
    default:
      return boost::math::cyl_bessel_k(1, x, Quiet{});
  }
}

Wide applySpecial(Op op, const Wide& a, const Wide& b) {
  switch (op) {
    case Op::Sqrt:
      return a < 0 ? std::numeric_limits<Wide>::quiet_NaN() : Wide(sqrt(a));
    case Op::Expm1:
      return abs(a) < 0.5 ? boost::math::expm1(a, Quiet{}) : Wide(exp(a) - 1);
    case Op::Log:
      return wideLog(a);
    case Op::Log1p:
      return abs(a) < 0.5 ? boost::math::log1p(a, Quiet{}) : wideLog(1 + a);
    case Op::Erf:
      return boost::math::erf(a, Quiet{});
    case Op::Erfc:
      return boost::math::erfc(a, Quiet{});
    case Op::Lgamma:
      return boost::math::lgamma(a, Quiet{});
    case Op::Digamma:
      return a > 0 ? boost::math::digamma(a, Quiet{}) : std::numeric_limits<Wide>::quiet_NaN();
    case Op::Trigamma:
      return a > 0 ? boost::math::trigamma(a, Quiet{}) : std::numeric_limits<Wide>::quiet_NaN();
    case Op::BesselJ0:
    case Op::BesselJ1:
    case Op::BesselI0:
    case Op::BesselI1:
    case Op::BesselK0:
    case Op::BesselK1:
      return bessel(op, a);
    case Op::Pow:
      return widePow(a, b);
    case Op::GammaP:
    case Op::GammaQ:
      return incompleteGamma(op, a, b);
    case Op::GammaPDa:
      return incompleteGammaSlope(a, b);
    default:
      return a;
  }
}

Wide apply(Op op, const Wide& a, const Wide& b, const Wide& c) {
  return applyPlain(op, a, b, c, [&] { return applySpecial(op, a, b); });
}

/// Walks the graph scope by scope, as Program does, with loops written out plainly.
class Evaluator {
 public:
  Evaluator(const Graph& graph, const InputLane& inputs, const std::vector<Wide>& parameters)
      : graph_(graph), inputs_(inputs), parameters_(parameters), scopes_(graph.scopes()), values_(graph.size()) {}

  std::vector<Wide> run(const std::vector<NodeId>& roots) {
    evaluateScope(0, graph_.reachable(roots));
    std::vector<Wide> results;
    for (const NodeId root : roots) results.push_back(values_[root]);
    return results;
  }

 private:
  void evaluateScope(std::uint32_t scope, const std::vector<bool>& wanted) {
    for (NodeId id = 0; id < wanted.size(); ++id) {
      if (!wanted[id] || scopes_[id] != scope) continue;
      const Node& node = graph_[id];
      const auto operand = [&](int k) -> const Wide& { return values_[node.operands[k]]; };
      switch (node.op) {
        case Op::Constant:
          values_[id] = node.value;
          break;
        case Op::Input:
          values_[id] = inputs_[node.index];
          break;
        case Op::Parameter:
          values_[id] = parameters_[node.index];
          break;
        case Op::Bound:
          break;  // set by its loop
        case Op::Table:
          values_[id] = graph_.table(node.index)->at(Table::Part::Value, operand(0), operand(1));
          break;
        case Op::TableDx:
          values_[id] = graph_.table(node.index)->at(Table::Part::Dx, operand(0), operand(1));
          break;
        case Op::TableDy:
          values_[id] = graph_.table(node.index)->at(Table::Part::Dy, operand(0), operand(1));
          break;
        case Op::Sum:
          values_[id] = sum(node);
          break;
        case Op::Solve:
          values_[id] = solve(node);
          break;
        default:
          values_[id] = apply(node.op, operand(0), operand(1), operand(2));
      }
    }
  }

  struct Body {
    std::vector<bool> wanted;
    std::vector<NodeId> bound;  ///< the node of the loop's variable, when the body uses it
  };
  Body bodyOf(const Node& node, const std::vector<NodeId>& roots) const {
    Body body{graph_.reachable(roots), {}};
    for (NodeId id = 0; id < body.wanted.size(); ++id)
      if (body.wanted[id] && graph_[id].op == Op::Bound && graph_[id].index == node.index) body.bound.push_back(id);
    return body;
  }
  void evaluateBody(const Node& node, const Body& body, const Wide& x) {
    for (const NodeId id : body.bound) values_[id] = x;
    evaluateScope(node.index + 1, body.wanted);
  }

  Wide sum(const Node& node) {
    const Body body = bodyOf(node, {node.operands[2]});
    const Wide last = values_[node.operands[1]];
    Wide k = values_[node.operands[0]], total = 0, previous = 0;
    for (int terms = 0, small = 0; terms < kMaximumTerms && k <= last && small < 2; ++terms, k += 1) {
      evaluateBody(node, body, k);
      const Wide term = values_[node.operands[2]], size = abs(term);
      total += term;
      small = size < previous && size <= node.value * abs(total) ? small + 1 : 0;
      previous = size;
    }
    return total;
  }

  /// Bisection to the last bit that matters; slow and plain.
  Wide solve(const Node& node) {
    const Body body = bodyOf(node, {node.operands[2]});
    const auto f = [&](const Wide& x) {
      evaluateBody(node, body, x);
      return values_[node.operands[2]];
    };
    Wide low = values_[node.operands[0]], high = values_[node.operands[1]];
    const Wide atLow = f(low), atHigh = f(high);
    if (atHigh == 0) return high;
    if ((atLow > 0) == (atHigh > 0)) return abs(atHigh) < abs(atLow) ? high : low;
    for (int k = 0; k < 180; ++k) {
      const Wide middle = (low + high) / 2;
      ((f(middle) > 0) == (atLow > 0) ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  const Graph& graph_;
  const InputLane& inputs_;
  const std::vector<Wide>& parameters_;
  std::vector<std::uint32_t> scopes_;
  std::vector<Wide> values_;
};

std::vector<Wide> evaluate(const Graph& graph, const std::vector<NodeId>& roots, const InputLane& inputs,
                           const std::vector<Wide>& parameters) {
  return Evaluator(graph, inputs, parameters).run(roots);
}

}  // namespace

std::vector<double> evaluateExtended(const Graph& graph, const std::vector<NodeId>& roots, const InputLane& inputs,
                                     std::span<const double> parameters) {
  std::vector<double> results;
  for (const Wide& value : evaluate(graph, roots, inputs, {parameters.begin(), parameters.end()}))
    results.push_back(value.convert_to<double>());
  return results;
}

double differenceExtended(const Graph& graph, NodeId root, const InputLane& inputs, std::span<const double> parameters,
                          std::size_t which) {
  std::vector<Wide> shifted(parameters.begin(), parameters.end());
  const Wide centre = shifted[which];
  const Wide step = Wide("1e-15") * (centre == 0 ? Wide(1) : Wide(abs(centre)));
  shifted[which] = centre + step;
  const Wide above = evaluate(graph, {root}, inputs, shifted)[0];
  shifted[which] = centre - step;
  const Wide below = evaluate(graph, {root}, inputs, shifted)[0];
  return Wide((above - below) / (2 * step)).convert_to<double>();
}

}  // namespace brdf::formula
