#pragma once
#include <string_view>

namespace brdf {

/// A text file compiled into the library (cmake/BRDFEmbed.cmake).
struct EmbeddedFile {
  std::string_view name;  ///< file name without its folder, e.g. "GGX.xml"
  std::string_view text;  ///< its bytes, unchanged
};

}  // namespace brdf
