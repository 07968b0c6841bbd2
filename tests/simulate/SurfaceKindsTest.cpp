#include "SurfaceSupport.h"

#include <brdf/base/Error.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace brdf {
namespace {

TEST(SurfaceKinds, RecordsAreComplete) {
  std::set<std::string> names;
  for (const SurfaceKind& kind : surfaceKinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_FALSE(kind.title.empty() || kind.description.empty()) << kind.name;
    for (const Parameter& parameter : kind.parameters) {
      SCOPED_TRACE(kind.name + ", " + parameter.name);
      EXPECT_FALSE(parameter.label.empty() || parameter.description.empty() || parameter.unit.empty());
      EXPECT_TRUE(std::isfinite(parameter.minimum) && std::isfinite(parameter.maximum));
      EXPECT_LE(parameter.minimum, parameter.defaultValue);
      EXPECT_LE(parameter.defaultValue, parameter.maximum);
    }
  }
}

TEST(SurfaceKinds, DefaultsMakeASurface) {
  for (const SurfaceKind& kind : surfaceKinds()) {
    const bool needsMore = std::ranges::any_of(kind.texts, &TextParameter::required);
    if (needsMore) continue;
    SCOPED_TRACE(kind.name);
    const MadeSurface made = makeSurface(kind.name);
    EXPECT_EQ(makeSurface(made.surface.description).surface.description, made.surface.description);
  }
}

TEST(SurfaceKinds, ErrorsNameWhatIsWrong) {
  EXPECT_TRUE(surfaceError("groves(width=3)").starts_with("unknown kind of surface; found 'groves'; "));
  EXPECT_NE(surfaceError("groves").find("did you mean grooves?"), std::string::npos);
  EXPECT_NE(surfaceError("grooves(widht=3)").find("did you mean width?"), std::string::npos);
  EXPECT_NE(surfaceError("grooves(width=-3)").find("out of bounds"), std::string::npos);
  EXPECT_NE(surfaceError("grooves(width=wide)").find("expected a number"), std::string::npos);
  EXPECT_NE(surfaceError("grooves(width=30)").find("surface grooves, width: out of bounds; found 30"),
            std::string::npos);
  EXPECT_NE(surfaceError("grooves(sets=1.5)").find("surface grooves, sets: not a whole number; found 1.5"),
            std::string::npos);
  EXPECT_NE(surfaceError("grooves(width=4").find("column"), std::string::npos);
}

TEST(SurfaceKinds, PluginsAddTheirOwn) {
  SurfaceKind kind{"bumps_of_test", "a test", "One node is high.", {}, {}, {}, {}};
  kind.make = [](const SurfaceArguments&, const SurfaceReaders&) {
    MadeSurface made;
    made.surface.shape = HeightField{2, 2, 1, 1, {1, 0, 0, 0}};
    return made;
  };
  registerSurfaceKind(kind);
  EXPECT_EQ(heightField("bumps_of_test").heights[0], 1);
  kind.make = {};
  EXPECT_THROW(registerSurfaceKind(kind), Error);
  kind.name = "no name";
  EXPECT_THROW(registerSurfaceKind(kind), Error);
}

TEST(SurfaceKinds, WhatAKindMakesIsChecked) {
  SurfaceKind kind{"broken_of_test", "a test", "Not finite.", {}, {}, {}, {}};
  kind.make = [](const SurfaceArguments&, const SurfaceReaders&) {
    MadeSurface made;
    made.surface.shape = HeightField{2, 2, 1, 1, {1, 0, 0, NAN}};
    return made;
  };
  registerSurfaceKind(kind);
  EXPECT_THROW(makeSurface("broken_of_test"), Error);
}

TEST(HeightField, RefusesWhatIsNoSurface) {
  const HeightField good{2, 3, 0.5, 2, std::vector<float>(6, 1.0F)};
  EXPECT_NO_THROW(good.check("here"));
  HeightField bad = good;
  bad.columns = 1;
  EXPECT_THROW(bad.check("here"), Error);
  bad = good;
  bad.rows = std::size_t{1} << 60;
  EXPECT_THROW(bad.check("here"), Error);
  bad = good;
  bad.spacingX = 0;
  EXPECT_THROW(bad.check("here"), Error);
  bad = good;
  bad.heights.pop_back();
  EXPECT_THROW(bad.check("here"), Error);
  bad = good;
  bad.heights[4] = INFINITY;
  try {
    bad.check("here");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "here: height of node (0, 2); found inf; allowed: a finite number of micrometres");
  }
}

}  // namespace
}  // namespace brdf
