#include <brdf/base/Error.h>
#include <brdf/formula/Derivative.h>
#include <brdf/formula/Parser.h>
#include <brdf/formula/Syntax.h>
#include <brdf/formula/Table.h>
#include <brdf/formula/Variables.h>

#include <algorithm>
#include <array>

namespace brdf::formula {
namespace {

constexpr int kMaximumExpansion = 64;           // of functions within functions: ends recursion
constexpr std::size_t kMaximumNodes = 200'000;  // in one graph
// Visits of syntax nodes in one parse(), every expansion of a function counted: functions that call each other several
// times multiply, and equal expressions do not make the graph grow.
constexpr std::size_t kMaximumVisits = 500'000;

struct Builtin {
  std::string_view name;
  Op op;
};

constexpr std::array kUnary = {Builtin{"neg", Op::Neg},           Builtin{"!", Op::Not},
                               Builtin{"abs", Op::Abs},           Builtin{"sqrt", Op::Sqrt},
                               Builtin{"exp", Op::Exp},           Builtin{"expm1", Op::Expm1},
                               Builtin{"log", Op::Log},           Builtin{"ln", Op::Log},
                               Builtin{"log1p", Op::Log1p},       Builtin{"sin", Op::Sin},
                               Builtin{"cos", Op::Cos},           Builtin{"tan", Op::Tan},
                               Builtin{"asin", Op::Asin},         Builtin{"acos", Op::Acos},
                               Builtin{"atan", Op::Atan},         Builtin{"sinh", Op::Sinh},
                               Builtin{"cosh", Op::Cosh},         Builtin{"tanh", Op::Tanh},
                               Builtin{"erf", Op::Erf},           Builtin{"erfc", Op::Erfc},
                               Builtin{"lgamma", Op::Lgamma},     Builtin{"digamma", Op::Digamma},
                               Builtin{"trigamma", Op::Trigamma}, Builtin{"besselj0", Op::BesselJ0},
                               Builtin{"besselj1", Op::BesselJ1}, Builtin{"besseli0", Op::BesselI0},
                               Builtin{"besseli1", Op::BesselI1}, Builtin{"besselk0", Op::BesselK0},
                               Builtin{"besselk1", Op::BesselK1}, Builtin{"floor", Op::Floor}};

constexpr std::array kBinary = {
    Builtin{"+", Op::Add},   Builtin{"-", Op::Sub},        Builtin{"*", Op::Mul},         Builtin{"/", Op::Div},
    Builtin{"pow", Op::Pow}, Builtin{"atan2", Op::Atan2},  Builtin{"gammap", Op::GammaP}, Builtin{"gammaq", Op::GammaQ},
    Builtin{"<", Op::Less},  Builtin{"<=", Op::LessEqual}, Builtin{"==", Op::Equal},      Builtin{"&&", Op::And},
    Builtin{"||", Op::Or}};

template <std::size_t n>
const Builtin* find(const std::array<Builtin, n>& table, std::string_view name) {
  const auto it = std::find_if(table.begin(), table.end(), [&](const Builtin& entry) { return entry.name == name; });
  return it == table.end() ? nullptr : &*it;
}

using Scope = std::map<std::string, NodeId, std::less<>>;
struct LocalFunction {
  std::vector<std::string> arguments;
  const Expression* body;
};

/// Lowers syntax trees to nodes. One Lowering for each body: the formula's, and each library function's when called.
class Lowering {
 public:
  Lowering(Graph& graph, const ParseOptions& options, const std::string& where, int expansion,
           std::vector<std::string>& functionsUsed, std::size_t& visits)
      : graph_(graph),
        options_(options),
        where_(where),
        expansion_(expansion),
        functionsUsed_(functionsUsed),
        visits_(visits) {}

  NodeId run(const std::vector<Statement>& statements, Scope& scope) {
    NodeId value = 0;
    for (const Statement& statement : statements) {
      if (statement.isFunction) {
        localFunctions_[statement.target] = {statement.arguments, statement.value.get()};
        continue;
      }
      value = lower(*statement.value, scope);
      if (!statement.target.empty()) scope[statement.target] = value;
    }
    if (statements.back().isFunction)
      formulaError(where_, statements.back().position, "the last statement must be an expression",
                   "a function definition");
    return value;
  }

 private:
  NodeId lower(const Expression& e, const Scope& scope) {
    if (graph_.size() > kMaximumNodes || ++visits_ > kMaximumVisits)
      formulaError(where_, e.position, "formula too large", {},
                   "at most " + std::to_string(kMaximumNodes) + " operations");
    switch (e.kind) {
      case Expression::Kind::Number:
        return graph_.constant(e.number);
      case Expression::Kind::Name:
        return name(e, scope);
      default:
        return call(e, scope);
    }
  }

  NodeId name(const Expression& e, const Scope& scope) {
    if (const auto it = scope.find(e.name); it != scope.end()) return it->second;
    for (std::size_t k = 0; k < options_.parameters.size() && expansion_ == 0; ++k)
      if (options_.parameters[k] == e.name) return graph_.parameter(static_cast<std::uint32_t>(k));
    if (const auto node = makeVariable(graph_, e.name)) return *node;
    std::vector<std::string> known;
    for (const auto& [key, node] : scope) known.push_back(key);
    if (expansion_ == 0) known.insert(known.end(), options_.parameters.begin(), options_.parameters.end());
    for (const Variable& variable : variables()) known.emplace_back(variable.name);
    unknown("unknown name", e, known);
  }

  [[noreturn]] void unknown(std::string what, const Expression& e, const std::vector<std::string>& known) {
    const std::string nearest = closestName(e.name, known);
    formulaError(where_, e.position, std::move(what), "'" + e.name + "'",
                 nearest.empty() ? "" : "did you mean '" + nearest + "'?");
  }

  void checkCount(const Expression& e, std::size_t wanted) {
    if (e.arguments.size() != wanted)
      formulaError(where_, e.position, "wrong number of arguments to " + e.name, std::to_string(e.arguments.size()),
                   std::to_string(wanted));
  }

  NodeId call(const Expression& e, const Scope& scope) {
    if (e.name == "sum" || e.name == "solve") return loop(e, scope);
    std::vector<NodeId> arguments;
    for (const auto& argument : e.arguments) arguments.push_back(lower(*argument, scope));
    if (const auto it = localFunctions_.find(e.name); it != localFunctions_.end()) {
      checkCount(e, it->second.arguments.size());
      Scope inner = scope;
      for (std::size_t k = 0; k < arguments.size(); ++k) inner[it->second.arguments[k]] = arguments[k];
      const Expansion guard(*this, e);
      return lower(*it->second.body, inner);
    }
    if (options_.functions != nullptr)
      if (const auto it = options_.functions->find(e.name); it != options_.functions->end())
        return libraryCall(e, it->second, arguments);
    if (options_.tables != nullptr)
      if (const auto it = options_.tables->find(e.name); it != options_.tables->end()) {
        checkCount(e, it->second->ny > 1 ? 2 : 1);
        return graph_.lookUp(Op::Table, it->second, arguments[0], arguments.back());
      }
    return builtinCall(e, arguments);
  }

  /// sum(k, first, last, term [, tolerance]) and solve(x, low, high, f).
  NodeId loop(const Expression& e, const Scope& scope) {
    const bool isSum = e.name == "sum";
    if (!isSum || e.arguments.size() != 5) checkCount(e, 4);
    const Expression& variable = *e.arguments[0];
    if (variable.kind != Expression::Kind::Name)
      formulaError(where_, variable.position, "the first argument of " + e.name + " must be a name", {},
                   "a new variable");
    const NodeId from = lower(*e.arguments[1], scope), to = lower(*e.arguments[2], scope);
    double tolerance = 0;
    if (e.arguments.size() == 5) {
      const NodeId node = lower(*e.arguments[4], scope);
      if (!graph_.isConstant(node))
        formulaError(where_, e.arguments[4]->position, "the tolerance of a sum must be a number");
      tolerance = graph_[node].value;
    }
    const NodeId bound = graph_.bound();
    Scope inner = scope;
    inner[variable.name] = bound;
    const NodeId body = lower(*e.arguments[3], inner);
    return isSum ? graph_.sum(bound, from, to, body, tolerance)
                 : graph_.solve(bound, from, to, body, derivative(graph_, body, bound));
  }

  struct Expansion {
    Expansion(Lowering& lowering, const Expression& e) : lowering_(lowering) {
      if (++lowering_.depth_ + lowering_.expansion_ > kMaximumExpansion)
        formulaError(lowering_.where_, e.position, "functions call each other too deeply", "'" + e.name + "'",
                     "no recursion");
    }
    ~Expansion() { --lowering_.depth_; }
    Lowering& lowering_;
  };

  NodeId libraryCall(const Expression& e, const Function& function, const std::vector<NodeId>& arguments) {
    checkCount(e, function.arguments.size());
    const Expansion guard(*this, e);
    if (std::find(functionsUsed_.begin(), functionsUsed_.end(), function.name) == functionsUsed_.end())
      functionsUsed_.push_back(function.name);
    Scope inner;  // a library function sees its arguments and the directions, nothing of its caller
    for (std::size_t k = 0; k < arguments.size(); ++k) inner[function.arguments[k]] = arguments[k];
    const std::string where = function.where.empty() ? "function " + function.name : function.where;
    const std::vector<Statement> body = parseStatements(function.body, where);
    return Lowering(graph_, options_, where, expansion_ + depth_, functionsUsed_, visits_).run(body, inner);
  }

  NodeId builtinCall(const Expression& e, const std::vector<NodeId>& a) {
    if (const Builtin* unary = find(kUnary, e.name)) return checkCount(e, 1), graph_.make(unary->op, a[0]);
    if (const Builtin* binary = find(kBinary, e.name)) return checkCount(e, 2), graph_.make(binary->op, a[0], a[1]);
    if (e.name == ">") return graph_.make(Op::Less, a[1], a[0]);
    if (e.name == ">=") return graph_.make(Op::LessEqual, a[1], a[0]);
    if (e.name == "!=") return graph_.make(Op::Not, graph_.make(Op::Equal, a[0], a[1]));
    if (e.name == "select" || e.name == "if") return checkCount(e, 3), graph_.select(a[0], a[1], a[2]);
    if (e.name == "sqr") return checkCount(e, 1), graph_.mul(a[0], a[0]);
    if (e.name == "hypot")
      return checkCount(e, 2), graph_.sqrt(graph_.add(graph_.mul(a[0], a[0]), graph_.mul(a[1], a[1])));
    if (e.name == "min" || e.name == "max") {
      if (a.empty()) checkCount(e, 1);
      NodeId result = a[0];
      for (std::size_t k = 1; k < a.size(); ++k)
        result = graph_.make(e.name == "min" ? Op::Min : Op::Max, result, a[k]);
      return result;
    }
    std::vector<std::string> known = builtinFunctions();
    for (const auto& [key, function] : localFunctions_) known.push_back(key);
    if (options_.functions != nullptr)
      for (const auto& [key, function] : *options_.functions) known.push_back(key);
    unknown("unknown function", e, known);
  }

  Graph& graph_;
  const ParseOptions& options_;
  std::string where_;
  int expansion_;
  int depth_ = 0;
  std::vector<std::string>& functionsUsed_;
  std::size_t& visits_;
  std::map<std::string, LocalFunction, std::less<>> localFunctions_;
};

}  // namespace

std::vector<std::string> builtinFunctions() {
  std::vector<std::string> names{"select", "min", "max", "sqr", "hypot", "sum", "solve"};
  for (const Builtin& entry : kUnary)
    if (std::isalpha(static_cast<unsigned char>(entry.name[0])) && entry.name != "neg") names.emplace_back(entry.name);
  for (const Builtin& entry : kBinary)
    if (std::isalpha(static_cast<unsigned char>(entry.name[0]))) names.emplace_back(entry.name);
  return names;
}

ParseResult parse(Graph& graph, std::string_view text, const ParseOptions& options) {
  ParseResult result;
  const std::vector<Statement> statements = parseStatements(text, options.where, options.start);
  Scope scope = options.bindings;
  std::size_t visits = 0;
  result.value = Lowering(graph, options, options.where, 0, result.functionsUsed, visits).run(statements, scope);
  result.variables = std::move(scope);
  return result;
}

}  // namespace brdf::formula
