// The lobe that docs/own-lobes.md shows loads, passes the audit, and is the file in docs/examples.
#include <brdf/base/File.h>
#include <brdf/check/Check.h>
#include <brdf/models/Registry.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "Page.h"

namespace brdf {
namespace {

std::filesystem::path file() { return docs() / "examples/lobes/SatinPaint.xml"; }

TEST(OwnLobesPage, ShowsTheExampleFile) {
  const auto shown = blocks(readFile(docs() / "own-lobes.md"), "xml");
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0] + "\n", readFile(file()));
}

TEST(OwnLobesPage, ItsLobeHasTheValueOfItsEquationByHand) {
  const ModelPointer model = readModelFile(file());
  // Normal incidence and view: D = (n + 2)/(2 pi), V = 1/4, F = F0; the coat lets (1 - F0)^2 through, through(1) = 1.
  const double zero = 0, one = 1;
  double value = 0;
  model->evaluate(DirectionPairs<double>{{&zero, &zero, &one}, {&zero, &zero, &one}, 1},
                  std::array<double, 3>{0.5, 48, 0.04}, &value);
  EXPECT_NEAR(value, 50 / (8 * std::numbers::pi) * 0.04 + 0.5 / std::numbers::pi * 0.96 * 0.96, 1e-15);
}

TEST(OwnLobesPage, ItsLobePassesTheAudit) {
  for (const Check& check : checkModel(*readModelFile(file())).checks)
    EXPECT_TRUE(check.passed) << check.name << " " << check.worst << " " << check.at;
}

}  // namespace
}  // namespace brdf
