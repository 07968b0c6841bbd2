#pragma once
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/measured/Format.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace brdf {

// What the text formats of scattered samples share.

/// `text` without a UTF-8 byte order mark.
std::string_view withoutByteOrderMark(std::string_view text);

/// Keys of the read options that finishScattered honours; a format adds its own ("angles").
const std::vector<std::string>& scatteredOptions();

/// Makes the BRDF of samples just read, honours the options and counts the defects. NaN, infinity and directions below
/// the horizon make a sample invalid; negative values are counted and, unless an option says otherwise, kept as noise
/// about zero. `quantity` and `samples.isotropic` are what the format or the file says, and why.
ReadResult finishScattered(ScatteredSamples samples, const std::filesystem::path& path, ReadReport report,
                           const ReadOptions& options, Quantity quantity = Quantity::Brdf,
                           std::string_view quantityEvidence = "the format's definition",
                           std::string_view symmetryEvidence = "the format's definition");

/// The valid samples of `brdf` for a file of scattered samples: its own, or else a grid. What is lost goes to `report`.
ScatteredSamples collectSamples(const Brdf& brdf, WriteReport& report);

/// The same as linear sRGB (for formats of coloursOnly), or as luminance: what the latter loses goes to `report` too.
ScatteredSamples collectRgbSamples(const Brdf& brdf, WriteReport& report);
ScatteredSamples collectLuminanceSamples(const Brdf& brdf, WriteReport& report);

/// The wavelengths (nm, ascending) at which a spectral format writes the channels, and the channel that goes with each.
/// Colours get stand-ins: blue, green and red the dominant wavelengths of the sRGB primaries, one channel 555 nm.
struct SpectralColumns {
  std::vector<double> wavelengths;
  std::vector<std::size_t> channels;
};
SpectralColumns spectralColumns(const Channels& channels, WriteReport& report);

/// The angles of sample i, radians. Of an isotropic surface the light's azimuth is turned to 0, which lets the readers
/// of formats that do not state the symmetry see it.
struct SampleAngles {
  double thetaI, phiI, thetaO, phiO;
};
SampleAngles sampleAngles(const ScatteredSamples& samples, std::size_t i);

/// Whether all light directions have one azimuth (radians, modulo 2 pi; at the pole any), as they have when only an
/// isotropic surface was meant.
bool oneIncidentAzimuth(const ScatteredSamples& samples);
/// The evidence that this is for the symmetry.
std::string_view azimuthEvidence(bool one);

/// Writes a whole file. Throws Error::Kind::File.
void writeBytes(const std::filesystem::path& path, std::string_view bytes);

}  // namespace brdf
