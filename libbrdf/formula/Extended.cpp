#include <brdf/formula/Extended.h>

#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/expm1.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace brdf::formula {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;

Wide clampToOne(const Wide& a) { return a > 1 ? Wide(1) : a < -1 ? Wide(-1) : a; }

Wide wideLog(const Wide& a) {
  if (a == 0) return -std::numeric_limits<Wide>::infinity();
  return a < 0 ? std::numeric_limits<Wide>::quiet_NaN() : Wide(log(a));
}

Wide widePow(const Wide& a, const Wide& b) {
  if (b == 0) return 1;
  if (a == 0) return b > 0 ? Wide(0) : std::numeric_limits<Wide>::infinity();
  return pow(a, b);
}

Wide apply(Op op, const Wide& a, const Wide& b, const Wide& c) {
  const auto truth = [](bool value) { return Wide(value ? 1 : 0); };
  switch (op) {
    case Op::Neg: return -a;
    case Op::Abs: return abs(a);
    case Op::Sqrt: return a < 0 ? std::numeric_limits<Wide>::quiet_NaN() : Wide(sqrt(a));
    case Op::Exp: return exp(a);
    case Op::Expm1: return abs(a) < 0.5 ? boost::math::expm1(a) : Wide(exp(a) - 1);
    case Op::Log: return wideLog(a);
    case Op::Log1p: return abs(a) < 0.5 ? boost::math::log1p(a) : wideLog(1 + a);
    case Op::Sin: return sin(a);
    case Op::Cos: return cos(a);
    case Op::Tan: return tan(a);
    case Op::Asin: return asin(clampToOne(a));
    case Op::Acos: return acos(clampToOne(a));
    case Op::Atan: return atan(a);
    case Op::Sinh: return sinh(a);
    case Op::Cosh: return cosh(a);
    case Op::Tanh: return tanh(a);
    case Op::Erf: return boost::math::erf(a);
    case Op::Erfc: return boost::math::erfc(a);
    case Op::Lgamma: return boost::math::lgamma(a);
    case Op::Digamma: return a > 0 ? boost::math::digamma(a) : std::numeric_limits<Wide>::quiet_NaN();
    case Op::Floor: return floor(a);
    case Op::Not: return truth(a == 0);
    case Op::Add: return a + b;
    case Op::Sub: return a - b;
    case Op::Mul: return a * b;
    case Op::Div: return a / b;
    case Op::Pow: return widePow(a, b);
    case Op::Min: return b < a ? b : a;
    case Op::Max: return b > a ? b : a;
    case Op::Atan2: return atan2(a, b);
    case Op::Less: return truth(a < b);
    case Op::LessEqual: return truth(a <= b);
    case Op::Equal: return truth(a == b);
    case Op::And: return truth(a != 0 && b != 0);
    case Op::Or: return truth(a != 0 || b != 0);
    case Op::Select: return a != 0 ? b : c;
    default: return a;
  }
}

std::vector<Wide> evaluate(const Graph& graph, const std::vector<NodeId>& roots, const InputLane& inputs,
                           const std::vector<Wide>& parameters) {
  const std::vector<bool> needed = graph.reachable(roots);
  std::vector<Wide> values(graph.size());
  for (NodeId id = 0; id < graph.size(); ++id) {
    if (!needed[id]) continue;
    const Node& node = graph[id];
    if (node.op == Op::Constant)
      values[id] = node.value;
    else if (node.op == Op::Input)
      values[id] = inputs[node.index];
    else if (node.op == Op::Parameter)
      values[id] = parameters[node.index];
    else
      values[id] = apply(node.op, values[node.operands[0]], values[node.operands[1]], values[node.operands[2]]);
  }
  std::vector<Wide> results;
  for (const NodeId root : roots) results.push_back(values[root]);
  return results;
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
