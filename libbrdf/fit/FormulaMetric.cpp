#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/FormulaMetric.h>
#include <brdf/formula/Derivative.h>
#include <brdf/formula/Parser.h>
#include <brdf/formula/Program.h>

#include <array>
#include <cmath>

namespace brdf {
namespace {

using formula::Graph;
using formula::Input;
using formula::NodeId;

// Stands in for f (1/sr) where the slope at f is not finite: that of a cube root at 0, say.
constexpr double kSmallestForSlope = 1e-6;
// The program reads f and t where a sampler's formula reads its random numbers.
constexpr Input kValue = Input::Random1, kTarget = Input::Random2;

class FormulaMetric final : public Metric {
 public:
  explicit FormulaMetric(std::string_view text) {
    name_ = "formula:" + std::string(text);
    source_ = "the user's own";
    partial_ = true;
    Graph graph;
    const NodeId f = graph.parameter(0), t = graph.parameter(1);
    const formula::FunctionTable functions = {{"cbrt", {"cbrt", {"x"}, "x < 0 ? -(-x)^(1/3) : x^(1/3)", "cbrt"}}};
    formula::ParseOptions options;
    options.functions = &functions;
    options.where = "formula of the metric";
    options.bindings = {{"f", f}, {"t", t}};
    NodeId value = formula::parse(graph, text, options).value;
    const auto uses = [&](NodeId root, NodeId leaf) -> bool { return graph.reachable({root})[leaf]; };
    if (!uses(value, f))
      throw Error(Error::Kind::Formula, {"the formula of a metric does not use f", options.where, std::string(text),
                                         "a formula of f, as in cbrt(f*cos_i)"});
    if (uses(value, graph.input(kValue)) || uses(value, graph.input(kTarget)))
      throw Error(Error::Kind::Formula,
                  {"random numbers in the formula of a metric", options.where, std::string(text), ""});
    const bool direct = uses(value, t);
    formula_ = std::string(trimmed(text)) + (direct ? "" : ", at f less at t");
    if (!direct) value = graph.sub(value, graph.substitute(value, f, t));
    const NodeId slope = formula::derivative(graph, value, f);
    quadratic_ = !uses(slope, f) && !direct;
    const auto inputs = [&](NodeId root) {
      return graph.substitute(graph.substitute(root, f, graph.input(kValue)), t, graph.input(kTarget));
    };
    residual_ = std::make_unique<const formula::Program>(graph, std::vector<NodeId>{inputs(value)});
    slope_ = std::make_unique<const formula::Program>(graph, std::vector<NodeId>{inputs(slope)});
  }

  void residual(const double* f, const double* target, const DirectionPairs<double>& pairs, double* r) const override {
    run(*residual_, f, target, pairs, r);
  }
  void slope(const double* f, const double* target, const DirectionPairs<double>& pairs, double* slope) const override {
    run(*slope_, f, target, pairs, slope);
    for (std::size_t i = 0; i < pairs.count; ++i) {
      if (std::isfinite(slope[i])) continue;
      run(*slope_, &kSmallestForSlope, target + i, pairs.slice(i, 1), slope + i);
      if (!std::isfinite(slope[i])) slope[i] = 0;
    }
  }

 private:
  static void run(const formula::Program& program, const double* f, const double* target,
                  const DirectionPairs<double>& pairs, double* out) {
    const std::array<const double*, static_cast<std::size_t>(Input::Count)> inputs = {
        pairs.wi[0], pairs.wi[1], pairs.wi[2], pairs.wo[0], pairs.wo[1], pairs.wo[2], f, target};
    program.run(inputs.data(), {}, &out, pairs.count);
  }

  std::unique_ptr<const formula::Program> residual_, slope_;
};

}  // namespace

MetricPointer makeFormulaMetric(std::string_view text) { return std::make_shared<FormulaMetric>(text); }

}  // namespace brdf
