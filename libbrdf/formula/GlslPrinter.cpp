#include <brdf/base/Text.h>
#include <brdf/formula/GlslPrinter.h>

#include <cmath>

#include "glslPreludeFiles.h"

namespace brdf::formula {
namespace {

bool isTruth(Op op) {
  return op == Op::Less || op == Op::LessEqual || op == Op::Equal || op == Op::And || op == Op::Or || op == Op::Not;
}

/// GLSL function that stands for the operation, or empty where an operator does.
std::string functionName(Op op) {
  switch (op) {
    case Op::Abs:
    case Op::Sqrt:
    case Op::Sin:
    case Op::Cos:
    case Op::Tan:
    case Op::Floor:
    case Op::Min:
    case Op::Max: return std::string(opName(op));
    case Op::Exp:
    case Op::Expm1:
    case Op::Log:
    case Op::Log1p:
    case Op::Asin:
    case Op::Acos:
    case Op::Atan:
    case Op::Atan2:
    case Op::Sinh:
    case Op::Cosh:
    case Op::Tanh:
    case Op::Erf:
    case Op::Erfc:
    case Op::Lgamma:
    case Op::Digamma:
    case Op::Pow: return "brdf_" + std::string(opName(op));
    default: return {};
  }
}

std::string literal(double value) {
  const float narrow = static_cast<float>(value);
  if (std::isnan(narrow)) return "uintBitsToFloat(0x7fc00000u)";
  if (std::isinf(narrow)) return narrow > 0 ? "uintBitsToFloat(0x7f800000u)" : "uintBitsToFloat(0xff800000u)";
  std::string text = formatNumber(static_cast<double>(narrow), 9);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return narrow < 0 || std::signbit(narrow) ? "(" + text + ")" : text;
}

class Printer {
 public:
  Printer(const Graph& graph, const GlslNames& names) : graph_(graph), names_(names) {}

  GlslBody run(const std::vector<NodeId>& outputs) {
    const std::vector<bool> needed = graph_.reachable(outputs);
    std::vector<int> uses(needed.size(), 0);
    for (NodeId id = 0; id < needed.size(); ++id)
      for (int k = 0; needed[id] && k < arity(graph_[id].op); ++k) ++uses[graph_[id].operands[k]];
    text_.assign(needed.size(), {});
    GlslBody body;
    for (NodeId id = 0; id < needed.size(); ++id) {
      if (!needed[id]) continue;
      text_[id] = print(id);
      if (uses[id] > 1 && arity(graph_[id].op) > 0) {
        const std::string name = "t" + std::to_string(id);
        body.statements += "  " + std::string(isTruth(graph_[id].op) ? "bool " : "float ") + name + " = " + text_[id] + ";\n";
        text_[id] = name;
      }
    }
    for (const NodeId output : outputs) body.outputs.push_back(number(output));
    return body;
  }

 private:
  std::string number(NodeId id) const { return isTruth(graph_[id].op) ? "float(" + text_[id] + ")" : text_[id]; }
  std::string truth(NodeId id) const { return isTruth(graph_[id].op) ? text_[id] : "(" + text_[id] + " != 0.0)"; }

  std::string print(NodeId id) const {
    const Node& node = graph_[id];
    const NodeId a = node.operands[0], b = node.operands[1], c = node.operands[2];
    const auto infix = [&](const char* symbol) { return "(" + number(a) + symbol + number(b) + ")"; };
    switch (node.op) {
      case Op::Constant: return literal(node.value);
      case Op::Input: return names_.inputs[node.index];
      case Op::Parameter: return names_.parameters[node.index];
      case Op::Neg: return "(-" + number(a) + ")";
      case Op::Add: return infix(" + ");
      case Op::Sub: return infix(" - ");
      case Op::Mul: return infix(" * ");
      case Op::Div: return infix(" / ");
      case Op::Less: return infix(" < ");
      case Op::LessEqual: return infix(" <= ");
      case Op::Equal: return infix(" == ");
      case Op::Not: return "(!" + truth(a) + ")";
      case Op::And: return "(" + truth(a) + " && " + truth(b) + ")";
      case Op::Or: return "(" + truth(a) + " || " + truth(b) + ")";
      case Op::Select: return "(" + truth(a) + " ? " + number(b) + " : " + number(c) + ")";
      default: {
        std::string call = functionName(node.op) + "(" + number(a);
        if (arity(node.op) > 1) call += ", " + number(b);
        return call + ")";
      }
    }
  }

  const Graph& graph_;
  const GlslNames& names_;
  std::vector<std::string> text_;
};

}  // namespace

GlslBody printGlsl(const Graph& graph, const std::vector<NodeId>& outputs, const GlslNames& names) {
  return Printer(graph, names).run(outputs);
}

std::string glslPrelude() { return std::string(glslPreludeFiles()[0].text); }

}  // namespace brdf::formula
