#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/formula/MathPrinter.h>
#include <brdf/reference/Markdown.h>

#include <algorithm>
#include <cctype>

namespace brdf::markdown {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '*' || c == '<' || c == '[') result += '\\';
    result += c;
  }
  return result;
}

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ';
    for (const char c : cell) line += c == '|' ? std::string("\\|") : std::string(1, c);
    line += " |";
  }
  return line + "\n";
}

std::string header(const std::vector<std::string>& cells) {
  std::string rule = "|";
  for (std::size_t k = 0; k < cells.size(); ++k) rule += "---|";
  return row(cells) + rule + "\n";
}

std::string citation(const Reference& reference) {
  std::string text = escaped(reference.authors);
  if (reference.year != 0) text += (text.empty() ? "" : " ") + std::to_string(reference.year);
  if (!reference.title.empty()) text += ", *" + escaped(reference.title) + "*";
  if (!reference.venue.empty()) text += ", " + escaped(reference.venue);
  if (!reference.doi.empty()) text += ", [doi:" + reference.doi + "](https://doi.org/" + reference.doi + ")";
  if (!reference.equations.empty()) text += "; equations: " + escaped(reference.equations);
  return text;
}

std::string parameterTable(const std::vector<Parameter>& parameters) {
  std::string text = header({"parameter", "symbol", "unit", "default", "hard bounds", "usual", "scale", "meaning"});
  for (const Parameter& p : parameters) {
    std::string meaning = escaped(p.description);
    if (p.label != p.name) meaning = "**" + escaped(p.label) + ".** " + meaning;
    if (!p.follows.empty()) meaning += " Follows `" + p.follows + "`.";
    text += row({"`" + p.name + "`", "$" + formula::mathSymbol(p.symbol, formula::MathStyle::Latex) + "$", p.unit,
                 number(p.defaultValue), number(p.minimum) + " to " + number(p.maximum),
                 number(p.softMinimum) + " to " + number(p.softMaximum),
                 p.scale == Parameter::Scale::Logarithmic ? "log" : "linear", meaning});
  }
  return text;
}

std::string mathBlock(const std::string& formula, const std::string& value,
                      const std::map<std::string, std::string>& symbols, const std::string& where) {
  const auto statements = formula::printMath(formula, formula::MathStyle::Latex, symbols, where);
  std::string text = "```math\n\\begin{aligned}\n";
  for (std::size_t k = 0; k < statements.size(); ++k) {
    const bool last = k + 1 == statements.size();
    const std::string& target = statements[k].target;
    text += (last && target.empty() ? value : target) + " &= " + statements[k].expression + (last ? "\n" : " \\\\\n");
  }
  return text + "\\end{aligned}\n```\n";
}

std::vector<std::string> unindented(std::string_view text) {
  while (!text.empty() && (text.front() == '\n' || text.front() == '\r')) text.remove_prefix(1);
  std::vector<std::string> lines;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.emplace_back(text.substr(start, end - start));
    start = end + 1;
  }
  while (!lines.empty() && trimmed(lines.back()).empty()) lines.pop_back();
  // An equation's first line has lost its own when it was trimmed.
  std::size_t common = std::string::npos;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (const std::size_t at = lines[k].find_first_not_of(' '); at != std::string::npos && (k > 0 || at > 0))
      common = std::min(common, at);
  for (std::size_t k = 0; k < lines.size() && common != std::string::npos; ++k)
    lines[k].erase(0, std::min(common, lines[k].find_first_not_of(' ')));
  return lines;
}

std::string codeBlock(std::string_view text, std::string_view language) {
  return "```" + std::string(language) + "\n" + joined(unindented(text), "\n") + "\n```\n";
}

std::string number(double value) {
  std::string text = formatNumber(value, 8);
  const std::size_t e = text.find('e');
  if (e != std::string::npos)
    while (text[e + 2] == '0') text.erase(e + 2, 1);
  return text;
}

const std::map<std::string, std::string>& usualSymbols() {
  static const std::map<std::string, std::string> symbols{
      {"ax", "alpha_x"}, {"ay", "alpha_y"}, {"nu", "n_u"}, {"nv", "n_v"}};
  return symbols;
}

std::map<std::string, std::string> symbolsOf(const std::vector<Parameter>& parameters) {
  std::map<std::string, std::string> symbols;
  for (const Parameter& parameter : parameters) symbols[parameter.name] = parameter.symbol;
  return symbols;
}

const LibraryFunction& functionCalled(const std::string& name) {
  for (const LibraryFunction& entry : libraryFunctions())
    if (entry.function.name == name) return entry;
  throw Error(Error::Kind::Value, {"unknown function of the library", {}, "'" + name + "'", {}});
}

std::string functionHead(const LibraryFunction& entry) {
  std::vector<std::string> arguments;
  for (const std::string& argument : entry.function.arguments)
    arguments.push_back(formula::mathSymbol(usualSymbols().contains(argument) ? usualSymbols().at(argument) : argument,
                                            formula::MathStyle::Latex));
  const std::string name = formula::mathSymbol(entry.function.name, formula::MathStyle::Latex);
  return arguments.empty() ? name : name + "(" + joined(arguments, ",\\,") + ")";
}

std::string anchor(std::string_view name) {
  std::string text(name);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace brdf::markdown
