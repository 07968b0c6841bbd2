#include <brdf/base/Text.h>
#include <brdf/formula/GlslPrinter.h>
#include <brdf/formula/Table.h>

#include <cmath>
#include <map>

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
    case Op::Max:
      return std::string(opName(op));
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
    case Op::Trigamma:
    case Op::BesselJ0:
    case Op::BesselJ1:
    case Op::BesselI0:
    case Op::BesselI1:
    case Op::BesselK0:
    case Op::BesselK1:
    case Op::GammaP:
    case Op::GammaQ:
    case Op::GammaPDa:
    case Op::Pow:
      return "brdf_" + std::string(opName(op));
    default:
      return {};
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
  Printer(const Graph& graph, const GlslNames& names) : graph_(graph), names_(names), scopes_(graph.scopes()) {}

  GlslBody run(const std::vector<NodeId>& outputs) {
    const std::vector<bool> needed = graph_.reachable(outputs);
    uses_.assign(needed.size(), 0);
    for (NodeId id = 0; id < needed.size(); ++id)
      for (int k = 0; needed[id] && k < arity(graph_[id].op); ++k) {
        const NodeId operand = graph_[id].operands[k];
        uses_[operand] += scopes_[operand] == scopes_[id] ? 1 : 2;  // named outside the loop that repeats its use
      }
    text_.assign(needed.size(), {});
    printScope(0, needed);
    GlslBody body;
    body.statements = std::move(statements_);
    for (const auto& [table, text] : tables_) body.functions += text;
    for (const NodeId output : outputs) body.outputs.push_back(number(output));
    return body;
  }

 private:
  void line(const std::string& text) { statements_ += std::string(2 * depth_, ' ') + text + "\n"; }

  void printScope(std::uint32_t scope, const std::vector<bool>& wanted) {
    for (NodeId id = 0; id < wanted.size(); ++id) {
      if (!wanted[id] || scopes_[id] != scope) continue;
      const Op op = graph_[id].op;
      const std::string name = "t" + std::to_string(id);
      if (op == Op::Bound) {
        text_[id] = "x" + std::to_string(graph_[id].index);
      } else if (op == Op::Sum) {
        printSum(graph_[id], name);
        text_[id] = name;
      } else if (op == Op::Solve) {
        printSolve(graph_[id], name);
        text_[id] = name;
      } else {
        if (op >= Op::Table && op <= Op::TableDy) addTable(*graph_.table(graph_[id].index));
        text_[id] = print(id);
        if (uses_[id] > 1 && arity(op) > 0) {
          line((isTruth(op) ? "bool " : "float ") + name + " = " + text_[id] + ";");
          text_[id] = name;
        }
      }
    }
  }

  // The same steps as formula/Loops.h.
  void printSum(const Node& node, const std::string& name) {
    const std::string x = "x" + std::to_string(node.index);
    line("float " + name + " = 0.0, " + name + "_last = 0.0;");
    line("int " + name + "_small = 0, " + name + "_terms = 0;");
    line("for (float " + x + " = " + number(node.operands[0]) + "; " + x + " <= " + number(node.operands[1]) + " && " +
         name + "_small < 2 && " + name + "_terms < " + std::to_string(kMaximumTerms) + "; " + x + " += 1.0, ++" +
         name + "_terms) {");
    ++depth_;
    printScope(node.index + 1, graph_.reachable({node.operands[2]}));
    line("float " + name + "_term = " + number(node.operands[2]) + ";");
    line(name + " += " + name + "_term;");
    line(name + "_small = abs(" + name + "_term) < " + name + "_last && abs(" + name +
         "_term) <= " + literal(node.value) + " * abs(" + name + ") ? " + name + "_small + 1 : 0;");
    line(name + "_last = abs(" + name + "_term);");
    --depth_;
    line("}");
  }

  void printSolve(const Node& node, const std::string& name) {
    const std::string x = "x" + std::to_string(node.index), low = name + "_low", high = name + "_high";
    line("float " + low + " = " + number(node.operands[0]) + ", " + high + " = " + number(node.operands[1]) + ";");
    line("float " + x + " = " + low + ", " + name + " = " + low + ", " + name + "_first = 0.0;");
    line("for (int " + name + "_round = 1; " + name + "_round < 60; ++" + name + "_round) {");
    ++depth_;
    printScope(node.index + 1, graph_.reachable({node.operands[2], node.operands[3]}));
    line("float f = " + number(node.operands[2]) + ";");
    line("if (" + name + "_round == 1) {");
    line("  " + name + "_first = f;");
    line("  " + x + " = " + high + ";");
    line("} else if (" + name + "_round == 2 && (f > 0.0) == (" + name + "_first > 0.0) && f != 0.0) {");
    line("  " + name + " = abs(f) < abs(" + name + "_first) ? " + high + " : " + low + ";");
    line("  break;");
    line("} else {");
    line("  if (" + name + "_round > 2) {");
    line("    if ((f > 0.0) == (" + name + "_first > 0.0)) " + low + " = " + x + "; else " + high + " = " + x + ";");
    line("  }");
    line("  float next = " + low + " + (" + high + " - " + low + ") * 0.5;");
    line("  if (" + name + "_round > 2) {");
    line("    float newton = " + x + " - f / " + number(node.operands[3]) + ";");
    line("    if (newton > min(" + low + ", " + high + ") && newton < max(" + low + ", " + high + ")) next = newton;");
    line("  }");
    line("  bool ended = f == 0.0 || (" + name + "_round > 2 && abs(next - " + x + ") <= 1.2e-7 * abs(" + x + "));");
    line("  " + name + " = f == 0.0 ? " + x + " : next;");
    line("  " + x + " = " + name + ";");
    line("  if (ended) break;");
    line("}");
    --depth_;
    line("}");
  }

  /// The table as a constant array, with the look-up of formula/Table.h.
  void addTable(const Table& table) {
    if (tables_.contains(table.name)) return;
    const std::string name = "brdf_table_" + table.name, size = std::to_string(table.values.size());
    std::string text = "#ifndef " + name + "_defined\n#define " + name + "_defined\nconst float " + name + "[" + size +
                       "] = float[" + size + "](";
    for (std::size_t k = 0; k < table.values.size(); ++k)
      text += (k == 0 ? "" : (k % 8 == 0 ? ",\n  " : ", ")) + literal(table.values[k]);
    text += ");\n";
    const auto whole = [](std::size_t n) { return std::to_string(n) + ".0"; };
    const auto position = [&](const char* x, double first, double last, std::size_t count) {
      const std::string steps = whole(count - 1), v(x);
      text += "  float f" + v + " = clamp((" + v + " - " + literal(first) + ") * (" + steps + " / (" + literal(last) +
              " - " + literal(first) + ")), 0.0, " + steps + ");\n  int " + v + "i = min(int(f" + v + "), " +
              std::to_string(count - 2) + ");\n";
    };
    text += "float " + name + "_value(float x, float y) {\n";
    position("x", table.x0, table.x1, table.nx);
    const auto row = [&](const std::string& offset) {
      return "mix(" + name + "[" + offset + "xi], " + name + "[" + offset + "xi + 1], fx - float(xi))";
    };
    if (table.ny > 1) {
      position("y", table.y0, table.y1, table.ny);
      const std::string stride = std::to_string(table.nx);
      text += "  return mix(" + row("yi * " + stride + " + ") + ", " + row("(yi + 1) * " + stride + " + ") +
              ", fy - float(yi));\n}\n#endif\n";
    } else {
      text += "  return " + row("") + ";\n}\n#endif\n";
    }
    tables_[table.name] = std::move(text);
  }

  std::string number(NodeId id) const { return isTruth(graph_[id].op) ? "float(" + text_[id] + ")" : text_[id]; }
  std::string truth(NodeId id) const { return isTruth(graph_[id].op) ? text_[id] : "(" + text_[id] + " != 0.0)"; }

  std::string print(NodeId id) const {
    const Node& node = graph_[id];
    const NodeId a = node.operands[0], b = node.operands[1], c = node.operands[2];
    const auto infix = [&](const char* symbol) { return "(" + number(a) + symbol + number(b) + ")"; };
    switch (node.op) {
      case Op::Constant:
        return literal(node.value);
      case Op::Input:
        return names_.inputs[node.index];
      case Op::Parameter:
        return names_.parameters[node.index];
      case Op::Neg:
        return "(-" + number(a) + ")";
      case Op::Add:
        return infix(" + ");
      case Op::Sub:
        return infix(" - ");
      case Op::Mul:
        return infix(" * ");
      case Op::Div:
        return infix(" / ");
      case Op::Less:
        return infix(" < ");
      case Op::LessEqual:
        return infix(" <= ");
      case Op::Equal:
        return infix(" == ");
      case Op::Not:
        return "(!" + truth(a) + ")";
      case Op::And:
        return "(" + truth(a) + " && " + truth(b) + ")";
      case Op::Or:
        return "(" + truth(a) + " || " + truth(b) + ")";
      case Op::Select:
        return "(" + truth(a) + " ? " + number(b) + " : " + number(c) + ")";
      case Op::Table:
        return "brdf_table_" + graph_.table(node.index)->name + "_value(" + number(a) + ", " + number(b) + ")";
      default: {
        std::string call = functionName(node.op) + "(" + number(a);
        if (arity(node.op) > 1) call += ", " + number(b);
        return call + ")";
      }
    }
  }

  const Graph& graph_;
  const GlslNames& names_;
  std::vector<std::uint32_t> scopes_;
  std::vector<int> uses_;
  std::vector<std::string> text_;
  std::string statements_;
  std::map<std::string, std::string> tables_;
  std::size_t depth_ = 1;
};

}  // namespace

GlslBody printGlsl(const Graph& graph, const std::vector<NodeId>& outputs, const GlslNames& names) {
  return Printer(graph, names).run(outputs);
}

std::string glslPrelude() { return std::string(glslPreludeFiles()[0].text); }

}  // namespace brdf::formula
