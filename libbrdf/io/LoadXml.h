#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/LoadMaterial.h>

namespace brdf {

/// Whether the head of a file is XML that loadXml reads: a material of ours (root `material`), a BRDF or fitting file
/// of BRDFLab 0.8.2 (`BRDF`), or a model file, ours (`model`) or that program's (`AnalyticBRDFModel`).
BRDF_EXPORT bool isMaterialXml(std::string_view head);

/// The material in such a file. Of a fitting file `#0` is the original and `#1` the first fit; names work too. Without
/// a choice it is the original, or the first fit where the original's measured file is not at hand. A model file is its
/// lobe with the defaults, and registers the model. `options` go to a measured original.
LoadedMaterial loadXml(const std::filesystem::path& path, std::string_view which, const ReadOptions& options);

}  // namespace brdf
