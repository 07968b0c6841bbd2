#pragma once
#include <brdf/measured/Format.h>

namespace brdf {

/// Whether the file's name says that it is of transmitted light (.ddt, .sdt): nothing in its content does.
bool integraNamesTransmission(const std::filesystem::path& path);

/// Writes the front reflection, or front transmission where the name says so, as .ddr or .ddt. Throws
/// Error::Kind::Value when there is none, Error::Kind::File.
WriteReport writeIntegra(const Brdf* front, const Components& components, const std::filesystem::path& path);

/// The same of specular fractions, as .sdr or .sdt.
WriteReport writeIntegraSpecular(const Brdf* front, const Components& components, const std::filesystem::path& path);

}  // namespace brdf
