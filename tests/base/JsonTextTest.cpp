#include <brdf/base/Error.h>
#include <brdf/base/JsonText.h>

#include <gtest/gtest.h>

namespace {

using namespace brdf;

std::string refusal(const std::string& text) {
  try {
    parseJson(text, "a.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string nested(std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); }

TEST(JsonText, ReadsValuesCommentsAndAByteOrderMark) {
  const Json json = parseJson("\xef\xbb\xbf{\"b\": [1, 2.5], // last\r\n \"a\": \"x\" /* too */}", "a.json");
  EXPECT_EQ(json["b"][1], 2.5);
  EXPECT_EQ(json.begin().key(), "b");
  EXPECT_EQ(shortened(json), "{\"b\":[1,2.5],\"a\":\"x\"}");
  EXPECT_EQ(shortened(json, 10), "{\"b\":[1...");
}

TEST(JsonText, SaysWhereATextIsNoJson) {
  EXPECT_EQ(refusal("{\n\"a\": b}"), "a.json, line 2: not JSON; found a fault near byte 8");
  EXPECT_EQ(refusal("").substr(0, 24), "a.json, line 1: not JSON");
  EXPECT_EQ(refusal("[1e999]"), "a.json: a number that JSON cannot hold; allowed: a double-precision number");
}

TEST(JsonText, RefusesDeepNestingWithoutRecursion) {
  EXPECT_EQ(refusal(nested(60)), "accepted");
  for (const std::size_t levels : {70u, 3000000u})
    EXPECT_EQ(refusal(nested(levels)), "a.json: values nested too deeply; allowed: at most 64 levels");
}

}  // namespace
