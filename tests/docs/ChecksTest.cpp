// docs/checks.md names the checks that there are, with their bounds.
#include <brdf/base/Text.h>
#include <brdf/check/Check.h>
#include <brdf/models/FormulaModel.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "Page.h"

namespace brdf {
namespace {

TEST(ChecksPage, HasARowForEveryCheckOfAModelWithItsBound) {
  const FormulaModel model(
      "<model name='Probe' title='A probe'><parameter name='a' default='0.5' min='0' max='1'/>"
      "<equation>D = 1 / pi; a * D</equation></model>",  // a distribution, so that it is audited too
      "test");
  CheckOptions quick;
  quick.effort = 0.1;
  std::map<std::string, double> bounds;
  for (const Check& check : checkModel(model, quick).checks) bounds[check.name] = check.allowed;
  const GlslRunner zeros = [](const std::string&, const std::vector<GlslColumn>& columns,
                              const std::vector<std::string>& expressions) {
    return std::vector(expressions.size(), std::vector<float>(columns.at(0).values.size()));
  };
  const Check glsl = checkGlsl(model, zeros, quick);
  bounds[glsl.name] = glsl.allowed;

  std::map<std::string, std::string> documented;
  for (const auto& row : tableRows(readFile(docs() / "checks.md"), ""))
    if (row.size() == 4 && row[0].starts_with("`")) documented[codeIn(row[0]).at(0)] = row[2];
  for (const auto& [name, bound] : bounds) {
    ASSERT_TRUE(documented.contains(name)) << name << " is not in docs/checks.md";
    const std::string& said = documented[name];
    if (name == "sampler") {
      EXPECT_GT(bound, 4);
    } else if (std::isinf(bound)) {
      EXPECT_EQ(said, "any") << name;
    } else {
      EXPECT_EQ(parseNumber(said), bound) << name;
    }
  }
  for (const auto& [name, bound] : documented) EXPECT_TRUE(bounds.contains(name)) << name << " is no check";
}

}  // namespace
}  // namespace brdf
