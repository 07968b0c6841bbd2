#include <brdf/base/Error.h>
#include <brdf/base/JsonText.h>

#include <algorithm>

namespace brdf {

Json parseJson(std::string_view text, const std::string& where) {
  constexpr int kMostLevels = 64;
  const auto checkDepth = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > kMostLevels)
      throw Error(Error::Kind::Format,
                  {"values nested too deeply", where, {}, "at most " + std::to_string(kMostLevels) + " levels"});
    return true;
  };
  try {
    return Json::parse(text, checkDepth, true, true);
  } catch (const Json::parse_error& error) {
    const auto end =
        text.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(error.byte, 1, text.size() + 1) - 1);
    const auto line = 1 + std::count(text.begin(), end, '\n');
    throw Error(
        Error::Kind::Format,
        {"not JSON", where + ", line " + std::to_string(line), "a fault near byte " + std::to_string(error.byte), {}});
  } catch (const Json::exception&) {
    throw Error(Error::Kind::Format, {"a number that JSON cannot hold", where, {}, "a double-precision number"});
  }
}

std::string shortened(const Json& value, std::size_t length) {
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > length) text = text.substr(0, length - 3) + "...";
  return text;
}

}  // namespace brdf
