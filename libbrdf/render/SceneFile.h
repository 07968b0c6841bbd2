#pragma once
#include <brdf/brdf_export.h>
#include <brdf/render/Scene.h>

#include <filesystem>
#include <functional>

namespace brdf {

/// What the core leaves to the program that reads a scene: VTK's readers and shapes, in ours. Each throws brdf::Error.
struct SceneReaders {
  /// A mesh from a file (.ply, .obj, .stl, ...). Without it a scene with mesh files is refused.
  std::function<TriangleMesh(const std::filesystem::path&)> mesh;
  /// A shape by its name. Without it there are the core's own: sphere and makeShape's.
  std::function<TriangleMesh(const std::string& name)> shape;
  /// A picture of linear radiance. Without it OpenEXR and Radiance files are read.
  std::function<Image(const std::filesystem::path&)> picture;
};

/// Reads a scene from a JSON file (docs/scenes.md describes it). Paths in it are relative to the file's folder;
/// materials are whatever loadMaterial takes. Throws Error::Kind::Format naming the place in the file, what
/// loadMaterial, EnvironmentMap::read and the readers throw, and as checkScene does.
BRDF_EXPORT Scene readScene(const std::filesystem::path& path, const SceneReaders& readers = {});

}  // namespace brdf
