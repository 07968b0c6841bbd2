#pragma once
#include <brdf/measured/Format.h>

namespace brdf {

/// Writes the front's reflection, transmission and specular fractions, as many as there are (`front` null: no
/// reflection), as SSDD version 0.3. Throws Error::Kind::Value when there is none, Error::Kind::File.
WriteReport writeSsdd(const Brdf* front, const Components& components, const std::filesystem::path& path);

}  // namespace brdf
