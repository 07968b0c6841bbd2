#include <brdf/base/Call.h>
#include <brdf/base/Error.h>
#include <gtest/gtest.h>

namespace brdf {
namespace {

TEST(Call, SplitsNestedArguments) {
  const Call call = parseCall(" grooves( width = 4, file=\"a, b.png\", spectrum=abc(a=0.01, b=(1,2)), 3 )", "surface");
  EXPECT_EQ(call.name, "grooves");
  EXPECT_EQ(call.column, 2u);
  ASSERT_EQ(call.arguments.size(), 4u);
  EXPECT_EQ(call.arguments[0].key, "width");
  EXPECT_EQ(call.arguments[0].text, "4");
  EXPECT_EQ(call.arguments[1].text, "a, b.png");
  EXPECT_EQ(call.arguments[2].text, "abc(a=0.01, b=(1,2))");
  EXPECT_EQ(call.arguments[3].key, "");
  const Call inner = parseCall(call.arguments[2].text, "surface", call.arguments[2].column);
  EXPECT_EQ(inner.column, call.arguments[2].column);
  EXPECT_EQ(numbersOf(inner, inner.arguments[1]), (std::vector<double>{1, 2}));
}

TEST(Call, NameAloneAndEmptyParenthesesAreCalls) {
  EXPECT_TRUE(parseCall("mirror", "facet").arguments.empty());
  EXPECT_TRUE(parseCall("mirror()", "facet").arguments.empty());
}

TEST(Call, KeepsMaterialsWhole) {
  const Call call = parseCall("scattering(0.3*Lambertian + 0.04*GGX(alpha=0.2))", "facet");
  ASSERT_EQ(call.arguments.size(), 1u);
  EXPECT_EQ(call.arguments[0].key, "");
  EXPECT_EQ(call.arguments[0].text, "0.3*Lambertian + 0.04*GGX(alpha=0.2)");
}

TEST(Call, ListsAreReadWithCommasOrBlanks) {
  const Call call = parseCall("conductor(eta=0.2 0.9 1.1, k=(3, 4,5), a=1e-3)", "facet");
  EXPECT_EQ(numbersOf(call, call.arguments[0]), (std::vector<double>{0.2, 0.9, 1.1}));
  EXPECT_EQ(numbersOf(call, call.arguments[1]), (std::vector<double>{3, 4, 5}));
  EXPECT_EQ(numbersOf(call, call.arguments[2]), (std::vector<double>{1e-3}));
}

TEST(Call, RefusesWhatIsNoCallWithItsColumn) {
  for (const char* text : {"", "()", "3(a=1)", "a(b=1", "a(b=\"c)", "a(b=)", "a(,)", "a(b=1,b=2)", "a(b=1) c"})
    EXPECT_THROW(parseCall(text, "surface"), Error) << text;
  try {
    parseCall("abc(x=(1,2)", "surface");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "surface, column 4: parenthesis not closed; found '(x=(1,2)'");
  }
  const Call call = parseCall("a(b=1 x, c=(), d=(1,), e=1,2)", "surface");
  for (std::size_t k = 0; k < 3; ++k) EXPECT_THROW(numbersOf(call, call.arguments[k]), Error) << k;
}

}  // namespace
}  // namespace brdf
