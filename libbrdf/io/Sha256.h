#pragma once
#include <brdf/brdf_export.h>

#include <string>
#include <string_view>

namespace brdf {

/// SHA-256 of `bytes` (FIPS 180-4) as 64 lower-case hexadecimal digits.
BRDF_EXPORT std::string sha256(std::string_view bytes);

}  // namespace brdf
