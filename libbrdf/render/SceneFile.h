#pragma once
#include <brdf/brdf_export.h>
#include <brdf/render/Scene.h>

#include <filesystem>
#include <functional>

namespace brdf {

/// Reads a mesh from a file (.ply, .obj, .stl, ...): VTK's readers in the programs, since the core has none.
using MeshReader = std::function<TriangleMesh(const std::filesystem::path&)>;

/// Reads a scene from a JSON file (docs/scenes.md describes it). Paths in it are relative to the file's folder;
/// materials are whatever loadMaterial takes. Throws Error::Kind::Format naming the place in the file, what
/// loadMaterial and EnvironmentMap::read throw, and as checkScene does. Without a `readMesh` a scene with mesh files is
/// refused.
BRDF_EXPORT Scene readScene(const std::filesystem::path& path, const MeshReader& readMesh = {});

}  // namespace brdf
