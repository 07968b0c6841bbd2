#pragma once
#include <brdf/brdf_export.h>

#include <filesystem>

namespace brdf {

/// Refuses mesh files that readers which trust their input do not survive: counts that the file cannot hold, indices
/// past the end, accessors outside their buffers. By the ending: .ply (header, and lists of binary ones), .obj, .stl,
/// .vtp (counts), .gltf, .glb; other files pass. Throws Error::Kind::Format naming the place, and as readFile does; a
/// file of more than 1 GiB is refused.
BRDF_EXPORT void checkMeshFile(const std::filesystem::path& path);

}  // namespace brdf
