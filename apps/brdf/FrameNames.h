#pragma once
#include <cstddef>
#include <string>

namespace brdf::app {

/// Throws Error::Kind::Usage unless `pattern` holds one place for a number, %d or %0Nd.
void checkFrameNames(const std::string& pattern);

/// The name of a frame: "a_%03d.png" and 7 make "a_007.png".
std::string frameName(const std::string& pattern, std::size_t frame);

}  // namespace brdf::app
