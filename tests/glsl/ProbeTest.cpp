// The probe itself: what goes in comes out, for any number of rows, and errors name their line.
#include "ProbeSupport.h"

#include <cmath>

namespace brdf {
namespace {

class Probe : public test::GlslTest {};

TEST_F(Probe, ReturnsItsInputsExactlyForAnyNumberOfRows) {
  for (const std::size_t count : {1u, 1023u, 1024u, 1025u, 70'000u}) {
    std::vector<float> a(count), b(count);
    for (std::size_t k = 0; k < count; ++k) {
      a[k] = static_cast<float>(k) + 0.25f;
      b[k] = std::ldexp(1.0f + static_cast<float>(k % 1000) / 1024.0f, static_cast<int>(k % 200) - 100);
    }
    const auto got = probe().Evaluate("", {{"a", a}, {"b", b}}, {"a", "b", "-a", "a + 1.0"});
    ASSERT_EQ(got.size(), 4u);
    EXPECT_EQ(got[0], a);
    EXPECT_EQ(got[1], b);
    for (std::size_t k = 0; k < count; ++k) {
      ASSERT_EQ(got[2][k], -a[k]);
      ASSERT_EQ(got[3][k], a[k] + 1.0f);
    }
  }
}

TEST_F(Probe, RunsMoreRowsThanOnePassHolds) {
  const std::size_t count = 1024 * 1024 + 5;
  std::vector<float> a(count);
  for (std::size_t k = 0; k < count; ++k) a[k] = static_cast<float>(k % 4096);
  const auto got = probe().Evaluate("float twice(float x) { return 2.0 * x; }", {{"a", a}}, {"twice(a)"});
  for (std::size_t k = 0; k < count; k += 997) ASSERT_EQ(got[0][k], 2 * a[k]);
  EXPECT_EQ(got[0].back(), 2 * a.back());
}

TEST_F(Probe, AcceptsNoRowsAtAll) { EXPECT_TRUE(probe().Evaluate("", {{"a", {}}}, {"a"})[0].empty()); }

TEST_F(Probe, NamesAndShowsTheLineThatDoesNotCompile) {
  try {
    probe().Evaluate("float good() { return 1.0; }\nfloat bad() { return nothing; }\n", {{"a", {1}}}, {"bad()"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Device);
    // Line 1 is the version.
    EXPECT_EQ(error.details().where, "GLSL line 3: float bad() { return nothing; }");
    EXPECT_NE(error.details().what.find("nothing"), std::string::npos) << error.what();
  }
}

TEST_F(Probe, RefusesWhatDoesNotFit) {
  EXPECT_THROW(probe().Evaluate("", {}, {"1.0"}), Error);
  EXPECT_THROW(probe().Evaluate("", {{"a", {1}}}, {}), Error);
  EXPECT_THROW(probe().Evaluate("", {{"a", {1}}, {"b", {1, 2}}}, {"a"}), Error);
  EXPECT_THROW(probe().Evaluate("", {{"a", {1}}}, {"a", "a", "a", "a", "a"}), Error);
}

}  // namespace
}  // namespace brdf
