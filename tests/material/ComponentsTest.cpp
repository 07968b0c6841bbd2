// Components of a material besides its front reflection.
#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Components.h>
#include <brdf/material/LobeSum.h>

#include <gtest/gtest.h>

using brdf::ComponentKind;
using brdf::radians;

TEST(Components, SpecularReflectanceIsLinearBetweenAnglesAndConstantBeyond) {
  const brdf::SpecularComponent component{ComponentKind::FrontReflection,
                                          brdf::Channels::spectral({400, 700}),
                                          {radians(10), radians(30), radians(80)},
                                          {0.1, 0.2, 0.7, 1, 2, 3}};
  component.check();
  EXPECT_DOUBLE_EQ(component.at(0, 0), 0.1);
  EXPECT_DOUBLE_EQ(component.at(0, radians(20)), 0.15);
  EXPECT_DOUBLE_EQ(component.at(0, radians(30)), 0.2);
  EXPECT_DOUBLE_EQ(component.at(1, radians(55)), 2.5);
  EXPECT_DOUBLE_EQ(component.at(1, radians(89)), 3);
}

TEST(Components, WrongSpecularTablesAreErrors) {
  const auto check = [](std::vector<double> angles, std::vector<double> values) {
    brdf::SpecularComponent{ComponentKind::BackReflection, {}, std::move(angles), std::move(values)}.check();
  };
  EXPECT_NO_THROW(check({0, 1}, {0.5, 0.5}));
  EXPECT_THROW(check({}, {}), brdf::Error);
  EXPECT_THROW(check({1, 0}, {0.5, 0.5}), brdf::Error);
  EXPECT_THROW(check({0, 2}, {0.5, 0.5}), brdf::Error);
  EXPECT_THROW(check({0, 1}, {0.5}), brdf::Error);
}

TEST(Components, AreFoundByTheirKind) {
  brdf::Components components;
  EXPECT_TRUE(components.empty());
  const auto transmission = brdf::parseMaterialExpression("0.4*Lambertian");
  components.scatter.push_back({ComponentKind::FrontTransmission, transmission});
  EXPECT_FALSE(components.empty());
  EXPECT_EQ(components.find(ComponentKind::FrontTransmission), transmission);
  EXPECT_EQ(components.find(ComponentKind::BackReflection), nullptr);
}
