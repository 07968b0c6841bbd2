#pragma once
#include <brdf/brdf_export.h>

#include <optional>
#include <string>
#include <string_view>

namespace brdf {

/// `bytes` in base64 (RFC 4648, section 4, with padding): bytes as text.
BRDF_EXPORT std::string toBase64(std::string_view bytes);

/// The bytes that `text` stands for; empty when it is no base64 (length, letters, padding, bits beyond the last byte).
BRDF_EXPORT std::optional<std::string> fromBase64(std::string_view text);

}  // namespace brdf
