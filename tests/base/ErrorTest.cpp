#include <brdf/base/Error.h>
#include <gtest/gtest.h>

using brdf::Error;

TEST(Error, IsOneLineThatSaysWhatWhereFoundAndAllowed) {
  const Error error(Error::Kind::Value, {"unknown\nlobe", "expression, column 3", "'GGGX'", "GGX, Ward"});
  EXPECT_STREQ(error.what(), "expression, column 3: unknown lobe; found 'GGGX'; allowed: GGX, Ward");
}

TEST(Error, LeavesEmptyPartsOut) {
  EXPECT_STREQ(Error(Error::Kind::File, {"no such file", "a.brdf", {}, {}}).what(), "a.brdf: no such file");
}

TEST(Error, EditDistanceIgnoresCaseAndCountsEdits) {
  EXPECT_EQ(brdf::editDistance("ggx", "GGX"), 0u);
  EXPECT_EQ(brdf::editDistance("kitten", "sitting"), 3u);  // the textbook example
}

TEST(Error, ClosestNameIsEmptyWhenNothingIsNear) {
  const std::string names[] = {"GGX", "Ward", "Lambertian"};
  EXPECT_EQ(brdf::closestName("Lambertain", names), "Lambertian");
  EXPECT_EQ(brdf::closestName("xyzzyplugh", names), "");
}
