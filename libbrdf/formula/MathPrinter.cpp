#include <brdf/base/Text.h>
#include <brdf/formula/MathPrinter.h>
#include <brdf/formula/MathSymbols.h>
#include <brdf/formula/Syntax.h>

#include <algorithm>
#include <cctype>

namespace brdf::formula {
namespace {

/// How tightly a piece of mathematics holds together; what binds less than its place asks for gets parentheses.
enum Binding { kLoose, kOr, kAnd, kEqual, kCompare, kSum, kProduct, kSign, kQuotient, kPower, kAtom };

struct Piece {
  std::string text;
  int binding = kAtom;
};

class Printer {
 public:
  Printer(MathStyle style, const std::map<std::string, std::string>& symbols)
      : latex_(style == MathStyle::Latex), style_(style), symbols_(symbols) {}

  std::string symbol(const std::string& name) const {
    if (const auto it = symbols_.find(name); it != symbols_.end()) return mathSymbol(it->second, style_);
    if (std::string known = variableSymbol(name, style_); !known.empty()) return known;
    return mathSymbol(name, style_);
  }

  Piece print(const Expression& e) const {
    if (e.kind == Expression::Kind::Number) return number(e.number);
    if (e.kind == Expression::Kind::Name) return {symbol(e.name), kAtom};
    return call(e);
  }

 private:
  std::string either(const char* latex, const char* unicode) const { return latex_ ? latex : unicode; }

  std::string enclosed(const std::string& text) const {
    return latex_ ? "\\left(" + text + "\\right)" : "(" + text + ")";
  }
  std::string at(const Expression& e, int binding) const {
    const Piece piece = print(e);
    return piece.binding < binding ? enclosed(piece.text) : piece.text;
  }
  const Expression& argument(const Expression& e, std::size_t k) const { return *e.arguments.at(k); }

  Piece number(double value) const {
    const std::string text = formatNumber(value);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return {text, kAtom};
    std::string exponent = text.substr(e + 1);
    if (exponent[0] == '+') exponent.erase(0, 1);
    const std::size_t zeros = exponent[0] == '-' ? 1 : 0;
    while (exponent.size() > zeros + 1 && exponent[zeros] == '0') exponent.erase(zeros, 1);
    const std::string power = "10" + raised(exponent), mantissa = text.substr(0, e);
    return mantissa == "1" ? Piece{power, kPower} : Piece{mantissa + either("\\cdot ", "·") + power, kProduct};
  }

  /// An exponent: raised letters where the style has them.
  std::string raised(const std::string& exponent) const {
    if (latex_) return "^{" + exponent + "}";
    static const std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : exponent) {
      if (c == '-')
        text += "⁻";
      else if (std::isdigit(static_cast<unsigned char>(c)))
        text += digits[c - '0'];
      else
        return "^" + (exponent.size() == 1 ? exponent : "(" + exponent + ")");
    }
    return text;
  }

  Piece power(const Expression& base, const std::string& exponent) const {
    std::string text = at(base, kAtom);
    const std::string cosine = either("\\cos\\", "cos ");
    if (text.starts_with(cosine)) {  // cos^n theta
      const std::size_t length = latex_ ? 4 : 3;
      return {text.substr(0, length) + raised(exponent) + text.substr(length), kAtom};
    }
    // A symbol that is squared already.
    const std::string_view square = latex_ ? "^2" : "²";
    if (const std::size_t found = text.find(square);
        base.kind == Expression::Kind::Name && found != std::string::npos) {
      if (exponent != "2") return {enclosed(text) + raised(exponent), kPower};
      return {text.replace(found, square.size(), raised("4")), kAtom};
    }
    return {text + raised(exponent), kPower};
  }

  /// The second operand of two: a sign of its own must not meet the operator.
  std::string second(const Expression& e, int binding) const {
    const std::string text = at(argument(e, 1), binding);
    return text.starts_with("-") || text.starts_with("−") ? enclosed(text) : text;
  }

  Piece product(const Expression& e) const {
    // On one line a/b c would be read as a/(b c).
    const bool quotientFirst = !latex_ && argument(e, 0).kind == Expression::Kind::Call && argument(e, 0).name == "/";
    const std::string left = at(argument(e, 0), quotientFirst ? kPower : kProduct), right = second(e, kProduct);
    const bool digit = std::isdigit(static_cast<unsigned char>(right[0]));
    return {left + (digit ? either("\\cdot ", " · ") : either("\\,", " ")) + right, kProduct};
  }

  Piece quotient(const Expression& e) const {
    const Expression& top = argument(e, 0);
    if (latex_ && top.kind == Expression::Kind::Call && top.name == "neg")  // the sign before the bar
      return {"-\\frac{" + print(argument(top, 0)).text + "}{" + print(argument(e, 1)).text + "}", kSign};
    if (!latex_) return {at(argument(e, 0), kProduct) + " / " + at(argument(e, 1), kPower), kProduct};
    return {"\\frac{" + print(argument(e, 0)).text + "}{" + print(argument(e, 1)).text + "}", kQuotient};
  }

  Piece infix(const Expression& e, const std::string& symbol, int binding, int right) const {
    return {at(argument(e, 0), binding) + symbol + second(e, right), binding};
  }

  Piece choice(const Expression& e) const {
    const std::string condition = print(argument(e, 0)).text, yes = print(argument(e, 1)).text,
                      no = print(argument(e, 2)).text;
    if (!latex_) return {"[" + yes + " if " + condition + ", else " + no + "]", kAtom};
    return {"\\begin{cases}" + yes + " & \\text{if } " + condition + " \\\\ " + no + " & \\text{otherwise}\\end{cases}",
            kLoose};
  }

  Piece loop(const Expression& e) const {
    const std::string variable = symbol(argument(e, 0).name), from = print(argument(e, 1)).text,
                      to = print(argument(e, 2)).text;
    if (e.name == "sum") {
      const std::string term = at(argument(e, 3), kProduct);
      return {latex_ ? "\\sum_{" + variable + "=" + from + "}^{" + to + "} " + term
                     : "Σ[" + variable + " = " + from + " .. " + to + "] " + term,
              kSum};
    }
    const std::string f = print(argument(e, 3)).text;
    return {latex_ ? "\\text{the } " + variable + "\\in\\left[" + from + ",\\,\\;" + to + "\\right]\\text{ where } " +
                         f + " = 0"
                   : "the " + variable + " in [" + from + ", " + to + "] where " + f + " = 0",
            kLoose};
  }

  std::string list(const Expression& e) const {
    std::string text;
    for (const auto& one : e.arguments) text += (text.empty() ? "" : latex_ ? ",\\," : ", ") + print(*one).text;
    return text;
  }

  Piece call(const Expression& e) const {
    const std::string& n = e.name;
    const std::size_t count = e.arguments.size();
    if (count == 2) {
      if (n == "+") return infix(e, " + ", kSum, kSum);
      if (n == "-") return infix(e, either(" - ", " − "), kSum, kProduct);
      if (n == "*") return product(e);
      if (n == "/") return quotient(e);
      if (n == "pow") return power(argument(e, 0), print(argument(e, 1)).text);
      if (n == "||") return infix(e, either(" \\lor ", " or "), kOr, kOr);
      if (n == "&&") return infix(e, either(" \\land ", " and "), kAnd, kAnd);
      if (n == "==") return infix(e, " = ", kEqual, kCompare);
      if (n == "!=") return infix(e, either(" \\ne ", " ≠ "), kEqual, kCompare);
      if (n == "<" || n == ">") return infix(e, " " + n + " ", kCompare, kSum);
      if (n == "<=") return infix(e, either(" \\le ", " ≤ "), kCompare, kSum);
      if (n == ">=") return infix(e, either(" \\ge ", " ≥ "), kCompare, kSum);
      if (n == "hypot") return {root(power(argument(e, 0), "2").text + " + " + power(argument(e, 1), "2").text), kAtom};
    }
    if (count == 1) {
      const Expression& a = argument(e, 0);
      if (n == "neg") return {either("-", "−") + at(a, kProduct), kSign};
      if (n == "!") return {either("\\lnot ", "not ") + at(a, kAtom), kSign};
      if (n == "sqr") return power(a, "2");
      if (n == "sqrt") return {root(print(a).text), kAtom};
      if (n == "abs") return {latex_ ? "\\left|" + print(a).text + "\\right|" : "|" + print(a).text + "|", kAtom};
      if (n == "floor")
        return {latex_ ? "\\left\\lfloor " + print(a).text + "\\right\\rfloor" : "⌊" + print(a).text + "⌋", kAtom};
      if (n == "log1p") {
        const bool minus = a.kind == Expression::Kind::Call && a.name == "neg";
        const std::string x = minus ? either("1 - ", "1 − ") + at(argument(a, 0), kProduct) : "1 + " + at(a, kSum);
        return {either("\\ln", "ln") + enclosed(x), kAtom};
      }
      if (n == "expm1") return {either("\\exp", "exp") + enclosed(print(a).text) + either(" - 1", " − 1"), kSum};
    }
    if ((n == "select" || n == "if") && count == 3) return choice(e);
    if ((n == "sum" || n == "solve") && count >= 4) return loop(e);
    return {function(n) + (count == 0 ? "" : enclosed(list(e))), kAtom};
  }

  std::string root(const std::string& inside) const { return latex_ ? "\\sqrt{" + inside + "}" : "√(" + inside + ")"; }

  std::string function(const std::string& name) const {
    if (name == "log" || name == "ln") return either("\\ln", "ln");
    if (name == "lgamma") return either("\\ln\\Gamma", "lnΓ");
    if (name == "digamma") return either("\\psi", "ψ");
    if (name == "trigamma") return either("\\psi'", "ψ′");
    if (name == "gammap") return "P";
    if (name == "gammaq") return "Q";
    if (name.starts_with("bessel") && name.size() == 8) {
      const char letter = static_cast<char>(name[6] - 'a' + 'A');
      return std::string(1, letter) + (name[7] == '0' ? either("_0", "₀") : either("_1", "₁"));
    }
    static const std::string_view known[] = {"exp", "sin", "cos", "tan", "sinh", "cosh", "tanh", "min", "max"};
    if (std::find(std::begin(known), std::end(known), name) != std::end(known)) return latex_ ? "\\" + name : name;
    if (name == "atan2") return either("\\mathrm{atan2}", "atan2");
    return mathSymbol(name, style_);
  }

  bool latex_;
  MathStyle style_;
  const std::map<std::string, std::string>& symbols_;
};

}  // namespace

std::vector<MathStatement> printMath(std::string_view formula, MathStyle style,
                                     const std::map<std::string, std::string>& symbols, const std::string& where) {
  const Printer printer(style, symbols);
  std::vector<MathStatement> statements;
  for (const Statement& statement : parseStatements(formula, where)) {
    MathStatement printed;
    if (!statement.target.empty()) printed.target = printer.symbol(statement.target);
    if (statement.isFunction) {
      std::vector<std::string> arguments;
      for (const std::string& argument : statement.arguments) arguments.push_back(printer.symbol(argument));
      printed.target = mathSymbol(statement.target, style) + "(" +
                       joined(arguments, style == MathStyle::Latex ? ",\\," : ", ") + ")";
    }
    printed.expression = printer.print(*statement.value).text;
    statements.push_back(std::move(printed));
  }
  return statements;
}

}  // namespace brdf::formula
