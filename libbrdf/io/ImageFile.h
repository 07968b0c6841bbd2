#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/Image.h>

#include <filesystem>
#include <string_view>

namespace brdf {

/// Largest picture that is read: pixels in all, and pixels along one side.
constexpr std::size_t kMaximumImagePixels = std::size_t{1} << 27;
constexpr std::size_t kMaximumImageSide = 32768;

/// Reads a linear picture, recognised by content: OpenEXR (scan lines or tiles, half or float, any compression;
/// channels R,G,B[,A] or Y) or Radiance .hdr. Throws Error::Kind::File or Error::Kind::Format.
BRDF_EXPORT Image readImage(const std::filesystem::path& path);
/// The same from the file's bytes; `path` is for messages only.
BRDF_EXPORT Image readImage(std::string_view bytes, const std::filesystem::path& path);

/// Reads a Radiance RGBE picture from its bytes: flat or run-length coded in either way, rows from the top ("-Y h +X
/// w"). Values are (mantissa + 1/2) 2^(exponent - 136), as in Radiance's own color.c (G. Ward, "Real Pixels", Graphics
/// Gems II, 1991), divided by the product of the EXPOSURE lines: watt/steradian/m^2 by Radiance's convention. `path` is
/// for messages. Throws Error::Kind::Format.
BRDF_EXPORT Image readRadianceHdr(std::string_view bytes, const std::filesystem::path& path);

/// Writes an OpenEXR file of 32-bit floats (ZIP compression): channels Y, or R,G,B, or R,G,B,A. The file is replaced
/// only when complete. Throws Error::Kind::File.
BRDF_EXPORT void writeExr(const Image& image, const std::filesystem::path& path);

}  // namespace brdf
