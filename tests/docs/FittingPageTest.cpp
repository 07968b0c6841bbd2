// docs/fitting.md has a row for every metric, which says rightly whether it is quadratic.
#include <brdf/base/File.h>
#include <brdf/fit/Metric.h>

#include <gtest/gtest.h>

#include <map>

#include "Page.h"

namespace brdf {
namespace {

TEST(FittingPage, HasARowForEveryMetric) {
  std::map<std::string, std::string> quadratic;
  for (const auto& row : tableRows(readFile(docs() / "fitting.md"), ""))
    if (row.size() == 4 && row[0].starts_with("`") && !row[0].starts_with("`--"))
      quadratic[codeIn(row[0]).at(0)] = row[2];
  for (const MetricPointer& metric : allMetrics()) {
    ASSERT_TRUE(quadratic.contains(metric->name())) << metric->name();
    EXPECT_EQ(quadratic[metric->name()], metric->quadratic() ? "yes" : "no") << metric->name();
  }
  for (const auto& [name, said] : quadratic)
    if (name != "formula:TEXT") {
      EXPECT_NO_THROW(findMetric(name)) << name;
    }
}

}  // namespace
}  // namespace brdf
