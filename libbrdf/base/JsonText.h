#pragma once
#include <brdf/brdf_export.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace brdf {

using Json = nlohmann::ordered_json;  ///< keys in the file's order

/// What a JSON text holds; comments (// and /* */) are allowed. `where` names it in errors. Throws Error::Kind::Format
/// with the line for what is no JSON, for a number that no double holds, and for values nested deeper than 64 levels:
/// writing them out again recurses.
BRDF_EXPORT Json parseJson(std::string_view text, const std::string& where);

/// A value as JSON on one line, cut to `length` characters: for errors.
BRDF_EXPORT std::string shortened(const Json& value, std::size_t length = 40);

}  // namespace brdf
