#include <brdf/formula/Graph.h>
#include <brdf/formula/PlainOperations.h>
#include <brdf/formula/SpecialFunctions.h>
#include <brdf/formula/Table.h>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/math/special_functions/digamma.hpp>
#include <cmath>

namespace brdf::formula {
namespace {

/// Overflow gives infinity, as in every other operation, instead of an exception.
using Quiet = boost::math::policies::policy<boost::math::policies::overflow_error<boost::math::policies::ignore_error>>;

struct OpInfo {
  std::string_view name;
  int arity;
};

constexpr std::array<OpInfo, static_cast<std::size_t>(Op::Count)> kOps{{
    {"constant", 0}, {"input", 0},    {"parameter", 0}, {"-", 1},         {"abs", 1},      {"sqrt", 1},
    {"exp", 1},      {"expm1", 1},    {"log", 1},       {"log1p", 1},     {"sin", 1},      {"cos", 1},
    {"tan", 1},      {"asin", 1},     {"acos", 1},      {"atan", 1},      {"sinh", 1},     {"cosh", 1},
    {"tanh", 1},     {"erf", 1},      {"erfc", 1},      {"lgamma", 1},    {"digamma", 1},  {"trigamma", 1},
    {"besselj0", 1}, {"besselj1", 1}, {"besseli0", 1},  {"besseli1", 1},  {"besselk0", 1}, {"besselk1", 1},
    {"floor", 1},    {"!", 1},        {"+", 2},         {"-", 2},         {"*", 2},        {"/", 2},
    {"pow", 2},      {"min", 2},      {"max", 2},       {"atan2", 2},     {"gammap", 2},   {"gammaq", 2},
    {"gammapDa", 2}, {"<", 2},        {"<=", 2},        {"==", 2},        {"&&", 2},       {"||", 2},
    {"select", 3},   {"bound", 0},    {"sum", 3},       {"solve", 4},     {"table", 2},    {"tableDx", 2},
    {"tableDy", 2},  {"muladd", 3},   {"mulsub", 3},    {"negmuladd", 3}, {"copy", 1},
}};

bool commutative(Op op) { return op == Op::Add || op == Op::Mul || op == Op::Equal || op == Op::And || op == Op::Or; }

double applySpecial(Op op, double a, double b, double c) {
  switch (op) {
    case Op::Sqrt:
      return std::sqrt(a);
    case Op::Expm1:
      return std::expm1(a);
    case Op::Log:
      return std::log(a);
    case Op::Log1p:
      return std::log1p(a);
    case Op::Erf:
      return std::erf(a);
    case Op::Erfc:
      return std::erfc(a);
    case Op::Lgamma:
      return std::lgamma(a);
    case Op::Digamma:
      return a > 0 ? boost::math::digamma(a, Quiet{}) : std::nan("");
    case Op::Trigamma:
      return trigamma(a);
    case Op::BesselJ0:
      return besselJ0(a);
    case Op::BesselJ1:
      return besselJ1(a);
    case Op::BesselI0:
      return besselI0(a);
    case Op::BesselI1:
      return besselI1(a);
    case Op::BesselK0:
      return besselK0(a);
    case Op::BesselK1:
      return besselK1(a);
    case Op::Pow:
      return std::pow(a, b);
    case Op::GammaP:
      return gammaP(a, b);
    case Op::GammaQ:
      return gammaQ(a, b);
    case Op::GammaPDa:
      return gammaPDa(a, b);
    case Op::MulAdd:
      return std::fma(a, b, c);
    case Op::MulSub:
      return std::fma(a, b, -c);
    case Op::NegMulAdd:
      return std::fma(-a, b, c);
    default:
      return a;
  }
}

}  // namespace

int arity(Op op) { return kOps[static_cast<std::size_t>(op)].arity; }
std::string_view opName(Op op) { return kOps[static_cast<std::size_t>(op)].name; }

double applyOp(Op op, double a, double b, double c) {
  return applyPlain(op, a, b, c, [&] { return applySpecial(op, a, b, c); });
}

std::size_t Graph::Hash::operator()(const Node& node) const {
  std::uint64_t hash = static_cast<std::uint64_t>(node.op);
  const auto mix = [&](std::uint64_t part) { hash = (hash ^ part) * 0x9e3779b97f4a7c15u, hash ^= hash >> 29; };
  for (const NodeId operand : node.operands) mix(operand);
  mix(node.index);
  mix(std::bit_cast<std::uint64_t>(node.value));
  return hash;
}

bool Graph::Equal::operator()(const Node& a, const Node& b) const {
  return a.op == b.op && std::equal(a.operands, a.operands + 4, b.operands) && a.index == b.index &&
         std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
}

Graph::Range Graph::rangeOf(const Node& node) const {
  const auto range = [&](int k) { return ranges_[node.operands[k]]; };
  const auto least = [&] { return std::min(range(0), range(1)); };
  switch (node.op) {
    case Op::Constant:
      return !std::isfinite(node.value) ? Range::Any
             : node.value > 0           ? Range::Positive
             : node.value == 0          ? Range::NonNegative
                                        : Range::Number;
    case Op::Input:
    case Op::Parameter:
      return Range::Number;
    case Op::Neg:
    case Op::Sub:
      return std::min(Range::Number, node.op == Op::Neg ? range(0) : least());
    case Op::Abs:
      return range(0) == Range::Number ? Range::NonNegative : range(0);
    case Op::Sqrt:
      return range(0) >= Range::NonNegative ? range(0) : Range::Any;
    case Op::Add:
      return least() == Range::NonNegative ? std::max(range(0), range(1)) : least();
    case Op::Mul:  // of positive numbers: perhaps so small that it is 0
      if (least() == Range::Number && node.operands[0] == node.operands[1]) return Range::NonNegative;
      return std::min(least(), Range::NonNegative);
    case Op::Min:
      return least();
    case Op::Max:
      return least() == Range::Any ? Range::Any : std::max(range(0), range(1));
    case Op::Select:
      return std::min(range(1), range(2));
    default:
      return Range::Any;
  }
}

NodeId Graph::intern(const Node& node) {
  const auto [it, added] = ids_.try_emplace(node, static_cast<NodeId>(nodes_.size()));
  if (added) {
    nodes_.push_back(node);
    ranges_.push_back(rangeOf(node));
  }
  return it->second;
}

NodeId Graph::constant(double value) {
  Node node;
  node.value = value;
  return intern(node);
}

NodeId Graph::input(Input input) {
  Node node;
  node.op = Op::Input;
  node.index = static_cast<std::uint32_t>(input);
  return intern(node);
}

NodeId Graph::parameter(std::uint32_t index) {
  Node node;
  node.op = Op::Parameter;
  node.index = index;
  return intern(node);
}

NodeId Graph::bound() { return boundNode(boundCount_++); }

NodeId Graph::boundNode(std::uint32_t index) {
  Node node;
  node.op = Op::Bound;
  node.index = index;
  return intern(node);
}

NodeId Graph::sum(NodeId variable, NodeId first, NodeId last, NodeId term, double tolerance) {
  if (isConstant(term, 0)) return term;
  Node node;
  node.op = Op::Sum;
  node.operands[0] = first;
  node.operands[1] = last;
  node.operands[2] = term;
  node.index = nodes_[variable].index;
  node.value = tolerance;
  return intern(node);
}

NodeId Graph::solve(NodeId variable, NodeId low, NodeId high, NodeId f, NodeId slope) {
  Node node;
  node.op = Op::Solve;
  node.operands[0] = low;
  node.operands[1] = high;
  node.operands[2] = f;
  node.operands[3] = slope;
  node.index = nodes_[variable].index;
  return intern(node);
}

NodeId Graph::lookUp(Op op, const std::shared_ptr<const Table>& table, NodeId x, NodeId y) {
  auto it = std::find(tables_.begin(), tables_.end(), table);
  if (it == tables_.end()) it = tables_.insert(it, table);
  Node node;
  node.op = op;
  node.operands[0] = x;
  node.operands[1] = table->ny > 1 ? y : constant(0);
  node.index = static_cast<std::uint32_t>(it - tables_.begin());
  return intern(node);
}

NodeId Graph::substitute(NodeId root, NodeId from, NodeId to) {
  const std::vector<bool> needed = reachable({root});
  std::vector<NodeId> image(root + 1);
  for (NodeId id = 0; id <= root; ++id) {
    image[id] = id == from ? to : id;
    if (!needed[id] || id == from) continue;
    Node node = nodes_[id];
    bool changed = false;
    for (int k = 0; k < arity(node.op); ++k) {
      changed = changed || image[node.operands[k]] != node.operands[k];
      node.operands[k] = image[node.operands[k]];
    }
    if (!changed) continue;
    const bool indexed = node.op >= Op::Sum && node.op <= Op::TableDy;
    image[id] = indexed ? intern(node) : make(node.op, node.operands[0], node.operands[1], node.operands[2]);
  }
  return image[root];
}

std::vector<std::uint32_t> Graph::scopes() const {
  // Every variable a node depends on and that is not bound below it; few, so a sorted list each.
  std::vector<std::vector<std::uint32_t>> free(nodes_.size());
  std::vector<std::uint32_t> scope(nodes_.size(), 0);
  for (std::size_t id = 0; id < nodes_.size(); ++id) {
    const Node& node = nodes_[id];
    std::vector<std::uint32_t>& mine = free[id];
    if (node.op == Op::Bound) mine.push_back(node.index + 1);
    for (int k = 0; k < arity(node.op); ++k)
      for (const std::uint32_t variable : free[node.operands[k]]) {
        const bool bodyOperand = (node.op == Op::Sum && k == 2) || (node.op == Op::Solve && k >= 2);
        if (bodyOperand && variable == node.index + 1) continue;
        if (std::find(mine.begin(), mine.end(), variable) == mine.end()) mine.push_back(variable);
      }
    for (const std::uint32_t variable : mine) scope[id] = std::max(scope[id], variable);
  }
  return scope;
}

NodeId Graph::simplified(Op op, NodeId a, NodeId b, NodeId c, bool& found) {
  found = true;
  const auto number = [&](NodeId id) { return nodes_[id].value; };
  switch (op) {
    case Op::Neg:
      if (nodes_[a].op == Op::Neg) return nodes_[a].operands[0];
      break;
    case Op::Add:
      if (isConstant(a, 0)) return b;
      if (isConstant(b, 0)) return a;
      if (nodes_[b].op == Op::Neg) return sub(a, nodes_[b].operands[0]);
      if (nodes_[a].op == Op::Neg) return sub(b, nodes_[a].operands[0]);
      break;
    case Op::Sub:
      if (isConstant(b, 0)) return a;
      if (isConstant(a, 0)) return neg(b);
      if (a == b) return constant(0);
      if (nodes_[b].op == Op::Neg) return add(a, nodes_[b].operands[0]);
      break;
    case Op::Mul:
      if (isConstant(a, 0) || isConstant(b, 0)) return constant(0);
      if (isConstant(a, 1)) return b;
      if (isConstant(b, 1)) return a;
      if (isConstant(a, -1)) return neg(b);
      if (isConstant(b, -1)) return neg(a);
      break;
    case Op::Div:
      if (isConstant(a, 0)) return a;
      if (isConstant(b, 1)) return a;
      // A power of two divides and multiplies alike, without a rounding; other constants keep the division.
      if (int exponent = 0; isConstant(b) && number(b) != 0 && std::abs(std::frexp(number(b), &exponent)) == 0.5 &&
                            std::abs(exponent) < 100)
        return mul(a, constant(1 / number(b)));
      break;
    case Op::Pow:
      if (isConstant(b, 0)) return constant(1);
      if (isConstant(b, 1)) return a;
      if (isConstant(b, 0.5)) return sqrt(a);
      if (isConstant(b) && number(b) == std::floor(number(b)) && number(b) > 1 && number(b) <= 8) {
        // Small whole powers by repeated squaring: fewer roundings and far cheaper than pow.
        NodeId result = 0;
        bool have = false;
        NodeId square = a;
        for (int n = static_cast<int>(number(b)); n > 0; n >>= 1) {
          if (n & 1) result = have ? mul(result, square) : square, have = true;
          if (n > 1) square = mul(square, square);
        }
        return result;
      }
      break;
    case Op::Min:
    case Op::Max:
      if (a == b) return a;
      if (op == Op::Max && isConstant(b) && number(b) <= 0 && ranges_[a] >= Range::NonNegative) return a;
      break;
    case Op::Less:
      if (isConstant(a) && number(a) <= 0 && ranges_[b] == Range::Positive) return constant(1);
      break;
    case Op::Select:
      if (isConstant(a)) return number(a) != 0 ? b : c;
      if (b == c) return b;
      break;
    case Op::And:
      if (isConstant(a, 0) || isConstant(b, 0)) return constant(0);
      break;
    default:
      break;
  }
  found = false;
  return 0;
}

NodeId Graph::make(Op op, NodeId a, NodeId b, NodeId c) {
  const int count = arity(op);
  const bool allConstant = isConstant(a) && (count < 2 || isConstant(b)) && (count < 3 || isConstant(c));
  if (allConstant)
    return constant(applyOp(op, nodes_[a].value, count < 2 ? 0 : nodes_[b].value, count < 3 ? 0 : nodes_[c].value));
  bool found = false;
  const NodeId simple = simplified(op, a, b, c, found);
  if (found) return simple;
  if (commutative(op) && a > b) std::swap(a, b);
  Node node;
  node.op = op;
  node.operands[0] = a;
  if (count > 1) node.operands[1] = b;
  if (count > 2) node.operands[2] = c;
  return intern(node);
}

std::vector<bool> Graph::reachable(const std::vector<NodeId>& roots) const {
  std::vector<bool> needed(nodes_.size(), false);
  for (const NodeId root : roots) needed[root] = true;
  for (std::size_t id = nodes_.size(); id-- > 0;) {
    if (!needed[id]) continue;
    for (int k = 0; k < arity(nodes_[id].op); ++k) needed[nodes_[id].operands[k]] = true;
  }
  return needed;
}

}  // namespace brdf::formula
