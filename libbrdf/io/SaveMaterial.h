#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/LoadMaterial.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// Names that saveMaterial takes as formats: "vtkhdf" (the container), "xml" (io/MaterialXml.h) and "brdflab-xml"
/// (io/BrdfLabXml.h) for sums of lobes, and every writable measured format.
BRDF_EXPORT std::vector<std::string> materialFormats();

/// Writes a material as `loadMaterial` gave it. `format` empty: by the extension of `path`, else a name, with settings
/// where it has some (configuredFormat()); .xml means "xml" for a sum
/// of lobes, Radiance's for anything else. `action` goes to the provenance of a container, `colour` to writeMeasured.
/// Throws Error::Kind::Value where the format cannot hold it.
BRDF_EXPORT WriteReport saveMaterial(const LoadedMaterial& material, const std::filesystem::path& path,
                                     std::string_view format, const std::string& action,
                                     const ColourSettings& colour = {});

}  // namespace brdf
