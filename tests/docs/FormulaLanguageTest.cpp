// docs/formula-language.md against the parser: its lists, its examples, its error messages.
#include <brdf/base/Error.h>
#include <brdf/formula/Extended.h>
#include <brdf/formula/Parser.h>
#include <brdf/formula/Variables.h>
#include <brdf/models/Library.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "Page.h"

namespace brdf {
namespace {

std::string page() { return readFile(docs() / "formula-language.md"); }

/// The value in 50-digit arithmetic.
double valueOf(const std::string& text) {
  formula::Graph graph;
  formula::ParseOptions options;
  options.where = "docs/formula-language.md";
  const auto node = formula::parse(graph, text, options).value;
  return formula::evaluateExtended(graph, {node}, {0.6, 0, 0.8, 0, 0.6, 0.8, 0, 0}, {})[0];
}

void expectValue(const std::string& formula, const std::string& shown) {
  const auto value = parseNumber(shown);
  ASSERT_TRUE(value) << formula << " = " << shown;
  EXPECT_NEAR(valueOf(formula), *value, 5e-14 * std::fabs(*value)) << formula;
}

TEST(FormulaLanguagePage, ListsEveryVariableWithItsMeaning) {
  std::string wanted, found;
  for (const formula::Variable& variable : formula::variables())
    wanted += "| `" + std::string(variable.name) + "` | " + std::string(variable.description) + " |\n";
  for (const auto& row : tableRows(page(), "Variables"))
    if (row[0].starts_with("`")) found += "| " + row[0] + " | " + row[1] + " |\n";
  EXPECT_EQ(found, wanted);
}

TEST(FormulaLanguagePage, ListsEveryFunctionWithAnExampleThatHolds) {
  std::set<std::string> documented;
  for (const auto& row : tableRows(page(), "Functions")) {
    if (!row[0].starts_with("`")) continue;
    ASSERT_EQ(row.size(), 4u) << row[0];
    const std::string heads = codeIn(row[0]).at(0), example = codeIn(row[2]).at(0);
    // "log(x), ln(x)": the names before the parentheses.
    std::string name;
    int depth = 0;
    for (const char c : heads) {
      if (c == '(' && depth++ == 0) documented.insert(std::string(trimmed(name)));
      if (c == ')') --depth;
      if (depth == 0) name = c == ')' || c == ',' ? "" : name + c;
    }
    expectValue(example, row[3]);
  }
  std::set<std::string> builtin{"if"};  // another spelling of select
  for (const std::string& function : formula::builtinFunctions()) builtin.insert(function);
  EXPECT_EQ(documented, builtin);
}

TEST(FormulaLanguagePage, ItsExamplesHaveTheValuesShown) {
  const auto examples = blocks(page(), "formula");
  ASSERT_GE(examples.size(), 5u);
  for (const std::string& example : examples) {
    const std::size_t at = example.rfind("# = ");
    ASSERT_NE(at, std::string::npos) << example;
    expectValue(example, example.substr(at + 4));
  }
}

TEST(FormulaLanguagePage, ItsOperatorsAreOnes) {
  const std::set<std::string> around{"c ? a : b", "-x", "+x", "!x", "x ^ y"};
  for (const auto& row : tableRows(page(), "Operators"))
    for (const std::string& op : codeIn(row[0]))
      EXPECT_NO_THROW(valueOf("a = 1; b = 2; c = 1; x = 1; y = 2; " + (around.contains(op) ? op : "a " + op + " b")))
          << op;
}

TEST(FormulaLanguagePage, ItsErrorsAreTheOnesThatThoseFormulasGive) {
  std::size_t count = 0;
  for (const auto& row : tableRows(page(), "Errors")) {
    if (!row[0].starts_with("`")) continue;
    ++count;
    const std::vector<std::string> parameters{"alpha"};
    formula::Graph graph;
    formula::ParseOptions options;
    options.where = "equation of Mine";
    options.parameters = parameters;
    options.functions = &functionTable();
    try {
      formula::parse(graph, codeIn(row[0]).at(0), options);
      ADD_FAILURE() << row[0] << " is no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), row[1]);
    }
  }
  EXPECT_GE(count, 10u);
}

}  // namespace
}  // namespace brdf
