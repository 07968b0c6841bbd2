#pragma once
#include <filesystem>
#include <string>

namespace brdf {

/// Refuses a glTF 2.0 file (text, or binary as .glb) with an index of nothing, an accessor outside its buffer, a buffer
/// that is shorter than it says, or nodes that are no trees. `path` is for messages and for buffers in files beside it.
/// Throws Error::Kind::Format, and Error::Kind::File for a buffer that is missing.
void checkGltf(const std::string& bytes, const std::filesystem::path& path);

}  // namespace brdf
