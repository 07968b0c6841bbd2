#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/formula/Derivative.h>
#include <brdf/formula/Extended.h>
#include <brdf/formula/GlslPrinter.h>
#include <brdf/formula/Parser.h>
#include <brdf/formula/Variables.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/models/Library.h>
#include <brdf/models/XmlRecord.h>

#include <algorithm>
#include <numbers>
#include <numeric>

namespace brdf {

using formula::Graph;
using formula::Input;
using formula::NodeId;
using formula::Op;
using formula::Program;

struct FormulaModel::Compiled {
  Graph graph;
  NodeId value = 0, density = 0;
  std::vector<NodeId> draw;
  std::vector<NodeId> derivatives;  // of the value, one a parameter
  std::vector<std::string> functionsUsed, distributions;
  std::vector<std::unique_ptr<const Program>> distributionPrograms;
  std::unique_ptr<const Program> valueProgram, densityProgram, drawProgram;

  std::mutex mutex;  // guards the map; programs themselves are immutable
  std::map<std::vector<std::size_t>, std::unique_ptr<const Program>> derivativePrograms;

  const Program& withDerivatives(std::span<const std::size_t> which) {
    const std::lock_guard lock(mutex);
    std::unique_ptr<const Program>& program = derivativePrograms[{which.begin(), which.end()}];
    if (!program) {
      std::vector<NodeId> outputs{value};
      for (const std::size_t k : which) outputs.push_back(derivatives[k]);
      program = std::make_unique<const Program>(graph, outputs);
    }
    return *program;
  }
};

namespace {

template <class T>
std::array<const T*, static_cast<std::size_t>(Input::Count)> inputsOf(const DirectionPairs<T>& pairs) {
  return {pairs.wi[0], pairs.wi[1], pairs.wi[2], pairs.wo[0], pairs.wo[1], pairs.wo[2], nullptr, nullptr};
}

/// `root` with both cosines at least 1e-14: nearer to the horizon a lobe keeps the value it has there, because squares
/// and products of the cosines would leave the normal numbers of float (0/0 instead of a limit), and the peak of a
/// sharp lobe over such a product its largest.
NodeId awayFromTheHorizon(Graph& graph, NodeId root) {
  for (const Input cosine : {Input::Uz, Input::Vz}) {
    const NodeId input = graph.input(cosine);
    root = graph.substitute(root, input, graph.make(Op::Max, input, graph.constant(1e-14)));
  }
  return root;
}

/// Whether both directions are above the horizon.
NodeId aboveTheHorizon(Graph& graph) {
  const NodeId zero = graph.constant(0);
  return graph.make(Op::And, graph.make(Op::Less, zero, graph.input(Input::Uz)),
                    graph.make(Op::Less, zero, graph.input(Input::Vz)));
}

}  // namespace

FormulaModel::FormulaModel(std::string_view xml, const std::string& where) : where_(where) {
  const XmlSource source(xml, where);
  pugi::xml_document document;
  const pugi::xml_node root = xmlRoot(document, source, "model");
  allowOnly(root, {"name", "title", "isotropic", "reciprocal", "constant", "clamp", "dialect"},
            {"description", "parameter", "equation", "sampler", "declares", "reference"}, source);
  name_ = identifierAttribute(root, "name", source);
  title_ = requiredAttribute(root, "title", source);
  description_ = std::string(trimmed(root.child_value("description")));
  equation_ = std::string(trimmed(root.child_value("equation")));
  if (equation_.empty()) throw Error(Error::Kind::Format, {"missing <equation>", source.at(root), {}, {}});
  equationStart_ = source.textStart(root.child("equation"));
  isotropic_ = flagAttribute(root, "isotropic", true, source);
  reciprocal_ = flagAttribute(root, "reciprocal", true, source);
  constant_ = flagAttribute(root, "constant", false, source);
  clamp_ = flagAttribute(root, "clamp", false, source);
  legacyDialect_ = std::string_view(root.attribute("dialect").value()) == "BRDFLab082";
  for (const pugi::xml_node node : root.children("parameter")) readParameterInto(node, source);
  for (const pugi::xml_node sampler : root.children("sampler")) readSamplerInto(sampler, source);
  namesSampler_ = !parts_.empty();
  if (parts_.empty()) parts_.push_back({"Cosine", {}, {}, where, {}, {}});
  references_ = readReferences(root, source);
  declarations_ = readDeclarations(root, source);
}

void FormulaModel::readParameterInto(const pugi::xml_node& node, const XmlSource& source) {
  Parameter parameter = readParameter(node, source);
  const auto refuse = [&](const char* what, const char* attribute, const std::string& name,
                          const std::string& allowed) {
    throw Error(Error::Kind::Format, {what, source.at(node, attribute), "'" + name + "'", allowed});
  };
  std::vector<std::string> earlier;
  for (const Parameter& other : parameters_) earlier.push_back(other.name);
  if (std::ranges::find(earlier, parameter.name) != earlier.end())
    refuse("a parameter before has this name", "name", parameter.name, "another name");
  if (!legacyDialect_ && std::ranges::any_of(formula::variables(), [&](const formula::Variable& variable) {
        return variable.name == parameter.name;
      }))
    refuse("a variable of the formula language has this name", "name", parameter.name, "another name");
  if (!parameter.follows.empty() && std::ranges::find(earlier, parameter.follows) == earlier.end())
    refuse("no parameter to follow", "follows", parameter.follows,
           earlier.empty() ? "none: it is the first" : joined(earlier));
  parameters_.push_back(std::move(parameter));
}

void FormulaModel::readSamplerInto(const pugi::xml_node& node, const XmlSource& source) {
  allowOnly(node, {"name", "arguments", "share", "cosine"}, {}, source);
  const bool first = parts_.empty();
  const std::string all = node.attribute("arguments").value();
  SamplerPart part{requiredAttribute(node, "name", source),
                   splitArguments(all),
                   first ? "" : requiredAttribute(node, "share", source),
                   source.at(node, "name"),
                   {},
                   first ? formula::Position{} : source.valueStart(node, "share")};
  const formula::Position start = all.empty() ? formula::Position{} : source.valueStart(node, "arguments");
  std::size_t from = 0;
  for (const std::string& argument : part.arguments) {
    from = all.find(argument, from);
    part.argumentStarts.push_back({start.line, start.column + static_cast<int>(from)});
    from += argument.size();
  }
  parts_.push_back(std::move(part));
  if (const pugi::xml_attribute cosine = node.attribute("cosine"))
    parts_.push_back({"Cosine", {}, cosine.value(), source.at(node, "cosine"), {}, source.valueStart(node, "cosine")});
}

FormulaModel::~FormulaModel() = default;

formula::ParseOptions FormulaModel::parseOptions(Graph& graph) const {
  formula::ParseOptions options;
  options.tables = &tableMap();
  options.functions = legacyDialect_ ? &legacyFunctionTable() : &functionTable();
  options.where = where_ + ", equation of " + name_;
  options.start = equationStart_;
  if (legacyDialect_)
    for (const char* name : {"phi_i", "phi_o"}) {  // (0, 2 pi] there
      const NodeId phi = *formula::makeVariable(graph, name);
      const NodeId turn = graph.add(phi, graph.constant(2 * std::numbers::pi));
      options.bindings[name] = graph.select(graph.make(Op::Less, graph.constant(0), phi), phi, turn);
    }
  return options;
}

NodeId FormulaModel::finished(Graph& graph, NodeId raw) const {
  if (clamp_) raw = graph.make(Op::Max, raw, graph.constant(0));
  return graph.select(aboveTheHorizon(graph), awayFromTheHorizon(graph, raw), graph.constant(0));
}

NodeId FormulaModel::buildValue(Graph& graph, std::span<const double> parameters) const {
  formula::ParseOptions options = parseOptions(graph);
  for (std::size_t k = 0; k < parameters_.size(); ++k)
    options.bindings[parameters_[k].name] = graph.constant(parameters[k]);
  return finished(graph, formula::parse(graph, equation_, options).value);
}

/// The nodes of a mixture of samplers.
class FormulaModel::SamplerGraph {
 public:
  /// `options`: how the model's own formulas are parsed.
  SamplerGraph(Graph& graph, const std::vector<SamplerPart>& parts, formula::ParseOptions options) : graph_(graph) {
    const auto parsed = [&](const std::string& text, formula::Position start) {
      options.start = start;
      return formula::parse(graph, text, options).value;
    };
    NodeId rest = graph.constant(1);
    for (std::size_t k = parts.size(); k-- > 0;) {  // the first part last: it gets what the others leave
      const SamplerPart& part = parts[k];
      Mixed mixed{&findSampler(part.sampler, part.where), options, rest};
      if (!part.share.empty()) {
        mixed.share = parsed(part.share, part.shareStart);
        const formula::Node& share = graph[mixed.share];
        if (share.op == Op::Constant && !(share.value >= 0 && share.value < 1))
          throw Error(Error::Kind::Format, {"share of sampler " + part.sampler, part.where, part.share, "[0, 1)"});
      }
      rest = graph.sub(rest, mixed.share);
      const std::vector<std::string>& wanted = mixed.sampler->arguments;
      if (wanted.size() != part.arguments.size())
        throw Error(Error::Kind::Format, {"wrong number of arguments to sampler " + part.sampler, part.where,
                                          std::to_string(part.arguments.size()),
                                          std::to_string(wanted.size()) + " (" + joined(wanted) + ")"});
      for (std::size_t a = 0; a < wanted.size(); ++a)
        mixed.options.bindings[wanted[a]] = parsed(part.arguments[a], part.argumentStarts[a]);
      mixed_.push_back(std::move(mixed));
    }
  }

  NodeId density() {
    NodeId sum = graph_.constant(0);
    for (Mixed& part : mixed_) {
      part.options.where = "density of sampler " + part.sampler->name;
      part.options.start = {};
      sum = graph_.add(sum, graph_.mul(part.share, formula::parse(graph_, part.sampler->density, part.options).value));
    }
    return sum;
  }

  /// wx, wy, wz; all 0 for a draw that fails.
  std::vector<NodeId> draw() {
    // The first random number chooses and, stretched, serves again.
    const NodeId random = graph_.input(Input::Random1), zero = graph_.constant(0);
    NodeId below = zero;
    std::vector<NodeId> starts;
    std::vector<std::array<NodeId, 3>> drawn;
    for (Mixed& part : mixed_) {
      if (mixed_.size() > 1)
        part.options.bindings["random1"] =
            graph_.div(graph_.sub(random, below), graph_.make(Op::Max, part.share, graph_.constant(1e-9)));
      part.options.where = "draw of sampler " + part.sampler->name;
      part.options.start = {};
      const formula::ParseResult result = formula::parse(graph_, part.sampler->draw, part.options);
      std::array<NodeId, 3> w;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string name = std::string("w") + "xyz"[axis];
        const auto it = result.variables.find(name);
        if (it == result.variables.end())
          throw Error(Error::Kind::Formula, {"missing assignment", part.options.where, {}, name});
        w[axis] = it->second;
      }
      drawn.push_back(w);
      starts.push_back(below);
      below = graph_.add(below, part.share);
    }
    std::array<NodeId, 3> w = drawn.back();
    for (std::size_t k = drawn.size() - 1; k-- > 0;) {
      const NodeId here = graph_.make(Op::Less, random, starts[k + 1]);
      for (std::size_t axis = 0; axis < 3; ++axis) w[axis] = graph_.select(here, drawn[k][axis], w[axis]);
    }
    const NodeId success = graph_.make(Op::Less, zero, w[2]);
    std::vector<NodeId> result;
    for (const NodeId component : w) result.push_back(graph_.select(success, component, zero));
    return result;
  }

 private:
  struct Mixed {
    const Sampler* sampler;
    formula::ParseOptions options;
    NodeId share;
  };
  Graph& graph_;
  std::vector<Mixed> mixed_;
};

FormulaModel::Compiled& FormulaModel::compiled() const {
  std::call_once(once_, [this] {
    auto made = std::make_unique<Compiled>();
    Graph& graph = made->graph;
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters_) names.push_back(parameter.name);
    const NodeId zero = graph.constant(0), above = aboveTheHorizon(graph);
    formula::ParseOptions options = parseOptions(graph);
    options.parameters = names;
    formula::ParseResult equation = formula::parse(graph, equation_, options);
    made->functionsUsed = std::move(equation.functionsUsed);
    for (const auto& [variable, node] : equation.variables)
      if (variable == "D" || variable.starts_with("D_")) {
        made->distributions.push_back(variable);
        made->distributionPrograms.push_back(std::make_unique<const Program>(graph, std::vector<NodeId>{node}));
      }
    made->value = finished(graph, equation.value);
    options.bindings.clear();
    options.functions = &functionTable();
    std::vector<std::uint32_t> all(parameters_.size());
    std::iota(all.begin(), all.end(), 0u);
    made->derivatives = formula::derivatives(graph, made->value, all);

    options.where = where_ + ", sampler of " + name_;
    SamplerGraph sampler(graph, parts_, options);
    made->density = graph.select(above, awayFromTheHorizon(graph, sampler.density()), zero);
    made->draw = sampler.draw();

    made->valueProgram = std::make_unique<const Program>(graph, std::vector<NodeId>{made->value});
    made->densityProgram = std::make_unique<const Program>(graph, std::vector<NodeId>{made->density});
    made->drawProgram = std::make_unique<const Program>(graph, made->draw);
    compiled_ = std::move(made);
  });
  return *compiled_;
}

void FormulaModel::evaluate(const DirectionPairs<double>& pairs, std::span<const double> parameters,
                            double* out) const {
  compiled().valueProgram->run(inputsOf(pairs).data(), parameters, &out, pairs.count);
}

void FormulaModel::evaluate(const DirectionPairs<float>& pairs, std::span<const double> parameters, float* out) const {
  compiled().valueProgram->run(inputsOf(pairs).data(), parameters, &out, pairs.count);
}

void FormulaModel::evaluateWithDerivatives(const DirectionPairs<double>& pairs, std::span<const double> parameters,
                                           std::span<const std::size_t> which, double* out) const {
  std::vector<double*> outputs;
  for (std::size_t k = 0; k <= which.size(); ++k) outputs.push_back(out + k * pairs.count);
  compiled().withDerivatives(which).run(inputsOf(pairs).data(), parameters, outputs.data(), pairs.count);
}

void FormulaModel::sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                          std::span<const double> parameters, const std::array<double*, 3>& wi,
                          std::size_t count) const {
  const double* const inputs[] = {nullptr, nullptr, nullptr, wo[0], wo[1], wo[2], u[0], u[1]};
  compiled().drawProgram->run(inputs, parameters, wi.data(), count);
}

void FormulaModel::pdf(const DirectionPairs<double>& pairs, std::span<const double> parameters, double* density) const {
  compiled().densityProgram->run(inputsOf(pairs).data(), parameters, &density, pairs.count);
}

std::vector<double> FormulaModel::evaluateExtended(const std::array<double, 3>& wi, const std::array<double, 3>& wo,
                                                   std::span<const double> parameters) const {
  const Compiled& c = compiled();
  std::vector<NodeId> roots{c.value};
  roots.insert(roots.end(), c.derivatives.begin(), c.derivatives.end());
  return formula::evaluateExtended(c.graph, roots, {wi[0], wi[1], wi[2], wo[0], wo[1], wo[2], 0, 0}, parameters);
}

std::string FormulaModel::glsl() const {
  const Compiled& c = compiled();
  formula::GlslNames names;
  std::string arguments;
  Graph graph = c.graph;
  std::vector<std::vector<NodeId>> roots{{c.value}, {c.density}, c.draw};
  for (std::uint32_t k = 0; k < parameters_.size(); ++k) {
    const std::string name = "p_" + parameters_[k].name;
    arguments += ", float " + name;
    names.parameters.push_back(parameters_[k].isLogarithmInShaders() ? "brdf_exp(" + name + ")" : name);
  }
  // Where a parameter arrives as its logarithm, that stands for log(parameter): exp may be beyond float.
  for (std::uint32_t k = 0; k < parameters_.size(); ++k) {
    if (!parameters_[k].isLogarithmInShaders()) continue;
    const NodeId logarithm = graph.make(Op::Log, graph.parameter(k));
    const NodeId given = graph.parameter(static_cast<std::uint32_t>(names.parameters.size()));
    names.parameters.push_back("p_" + parameters_[k].name);
    for (std::vector<NodeId>& nodes : roots)
      for (NodeId& node : nodes) node = graph.substitute(node, logarithm, given);
  }
  const auto function = [&](const std::string& head, const std::vector<NodeId>& nodes, const char* wrap) {
    const formula::GlslBody body = formula::printGlsl(graph, nodes, names);
    return body.functions + head + arguments + ") {\n" + body.statements + "  return " + wrap +
           (nodes.size() == 1 ? body.outputs[0] : "(" + joined(body.outputs) + ")") + ";\n}\n\n";
  };
  return function("float brdf_" + name_ + "(vec3 wi, vec3 wo", roots[0], "") +
         function("float brdf_" + name_ + "_pdf(vec3 wi, vec3 wo", roots[1], "") +
         function("vec3 brdf_" + name_ + "_sample(vec3 wo, vec2 u", roots[2], "vec3");
}

const std::vector<std::string>& FormulaModel::distributions() const { return compiled().distributions; }

void FormulaModel::evaluateDistribution(std::size_t which, const std::array<const double*, 3>& h,
                                        std::span<const double> parameters, double* out, std::size_t count) const {
  const DirectionPairs<double> pairs{h, h, count};
  compiled().distributionPrograms.at(which)->run(inputsOf(pairs).data(), parameters, &out, count);
}

const Graph& FormulaModel::graph() const { return compiled().graph; }
NodeId FormulaModel::valueNode() const { return compiled().value; }
const std::vector<std::string>& FormulaModel::functionsUsed() const { return compiled().functionsUsed; }
const std::vector<NodeId>& FormulaModel::derivativeNodes() const { return compiled().derivatives; }

}  // namespace brdf
