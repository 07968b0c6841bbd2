// What BRDFLab 0.8.2 reads and writes besides XML: sparse measurements as text, one sample a line, theta_i, phi_i,
// theta_o, phi_o (radians), red, green, blue; and the export of a simulation by Qt's QDataStream (big-endian): int32
// number of samples, divisions in phi, divisions in theta, then for each sample in.xyz, out.xyz and value as
// floating-point numbers of 8 bytes (Qt 4.6 and later) or 4 (before); the file's size tells which.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/LineReader.h>
#include <brdf/measured/SampleRows.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace brdf {
namespace {

constexpr std::size_t kTextColumns = 7;

/// The seven numbers of a line, or false.
bool sevenNumbers(std::string_view line, std::array<double, kTextColumns>& numbers) {
  const auto cells = split(line, ',');
  if (cells.size() != kTextColumns) return false;
  for (std::size_t i = 0; i < kTextColumns; ++i) {
    const auto value = parseNumber(cells[i]);
    if (!value) return false;
    numbers[i] = *value;
  }
  return true;
}

int recogniseText(std::string_view head, std::uint64_t) {
  LineReader lines(head, {});
  std::string_view line;
  std::array<double, kTextColumns> numbers;
  return lines.next(line) && sevenNumbers(line, numbers) ? 60 : 0;
}

ReadResult readText(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  LineReader lines(bytes, path);
  ReadReport report;
  const double toRadians =
      choose(options, AngleUnit::Radians, "what the program takes them for", report) == AngleUnit::Degrees ? radians(1)
                                                                                                           : 1;
  SampleRows rows(3);
  double largestAngle = 0;
  std::array<double, kTextColumns> n;
  for (std::string_view line; lines.next(line);) {
    const auto cells = split(line, ',');
    if (cells.size() != kTextColumns) lines.fail("wrong number of columns", std::to_string(cells.size()), "7");
    for (std::size_t i = 0; i < kTextColumns; ++i) n[i] = lines.number(cells[i], "a sample");
    for (std::size_t i = 0; i < 4; ++i) {
      if (!std::isfinite(n[i])) lines.fail("an angle is not finite", formatNumber(n[i]), "a number");
      n[i] *= toRadians;
      largestAngle = std::max(largestAngle, std::abs(n[i]));
    }
    rows.add({fromSpherical(n[0], n[1]), fromSpherical(n[2], n[3])}, std::span(n).last(3));
  }
  if (rows.empty()) lines.fail("the file holds no sample", {}, {});
  if (toRadians == 1 && largestAngle > 2 * kPi * (1 + 1e-6))
    report.warnings.push_back("angles up to " + formatNumber(largestAngle, 6) +
                              ": this format has radians, the file looks like degrees (option angles=degrees)");
  ScatteredSamples samples = rows.samples(Channels::rgb(), false);
  samples.isotropic = oneIncidentAzimuth(samples);
  const std::string_view azimuths = azimuthEvidence(samples.isotropic);
  toLinearSrgb(samples, options, ColourSpace::LinearSrgb, "the format does not say", report);
  return finishScattered(std::move(samples), path, std::move(report), options, Quantity::Brdf,
                         "what the program takes them for", azimuths);
}

WriteReport writeText(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  const ScatteredSamples samples = collectRgbSamples(brdf, report);
  std::string text;
  const std::size_t count = samples.pairs.size();
  for (std::size_t i = 0; i < count; ++i) {
    const SampleAngles angles = sampleAngles(samples, i);
    for (const double angle : {angles.thetaI, angles.phiI, angles.thetaO, angles.phiO})
      text += formatNumber(angle) + ",";
    for (std::size_t channel = 0; channel < 3; ++channel)
      text += formatNumber(samples.values[channel * count + i]) + (channel < 2 ? "," : "\n");
  }
  writeBytes(path, text);
  return report;
}

// ----- the Qt export -------------------------------------------------------------------------------------------------

constexpr std::size_t kHeaderBytes = 12, kNumbers = 7;

template <class Word, class Number>
Number bigEndian(const char* bytes) {
  Word word = 0;
  for (std::size_t i = 0; i < sizeof(Word); ++i)
    word = static_cast<Word>(word << 8 | static_cast<unsigned char>(bytes[i]));
  return std::bit_cast<Number>(word);
}

template <class Word, class Number>
void appendBigEndian(std::string& bytes, Number number) {
  const auto word = std::bit_cast<Word>(number);
  for (std::size_t i = sizeof(Word); i-- > 0;) bytes += static_cast<char>(word >> (8 * i));
}

/// Bytes of a number, from the file's size: 8, 4, or 0 when neither fits.
std::size_t numberBytes(std::string_view head, std::uint64_t size) {
  if (head.size() < kHeaderBytes) return 0;
  std::int32_t header[3];
  for (std::size_t i = 0; i < 3; ++i) header[i] = bigEndian<std::uint32_t, std::int32_t>(head.data() + 4 * i);
  if (header[0] <= 0 || header[1] < 0 || header[2] < 0) return 0;
  for (const std::size_t bytes : {8, 4})
    if (kHeaderBytes + kNumbers * bytes * static_cast<std::uint64_t>(header[0]) == size) return bytes;
  return 0;
}

int recogniseExport(std::string_view head, std::uint64_t size) { return numberBytes(head, size) > 0 ? 80 : 0; }

ReadResult readExport(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  const std::size_t width = numberBytes(bytes, bytes.size());
  if (width == 0)
    throw Error(Error::Kind::Format, {"the file's size does not match its header", path.string() + ", offset 0",
                                      std::to_string(bytes.size()) + " bytes", "12 + 56 n or 12 + 28 n for n samples"});
  const std::size_t count = (bytes.size() - kHeaderBytes) / (kNumbers * width);
  SampleRows rows(1);
  for (std::size_t i = 0; i < count; ++i) {
    double n[kNumbers];
    for (std::size_t k = 0; k < kNumbers; ++k) {
      const char* at = bytes.data() + kHeaderBytes + (i * kNumbers + k) * width;
      n[k] = width == 8 ? bigEndian<std::uint64_t, double>(at) : bigEndian<std::uint32_t, float>(at);
    }
    rows.add({normalized({n[0], n[1], n[2]}), normalized({n[3], n[4], n[5]})}, std::span(n).last(1));
  }
  ReadReport report;
  report.metadata["numbers"] = std::to_string(width) + " bytes each";
  report.metadata["divisions"] = formatNumber(bigEndian<std::uint32_t, std::int32_t>(bytes.data() + 4)) + " in phi, " +
                                 formatNumber(bigEndian<std::uint32_t, std::int32_t>(bytes.data() + 8)) + " in theta";
  return finishScattered(rows.samples(Channels::monochrome(), false), path, std::move(report), options, Quantity::Brdf,
                         "the program divides by the cosine");
}

WriteReport writeExport(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  const ScatteredSamples samples = collectLuminanceSamples(brdf, report);
  if (samples.isotropic) report.losses.push_back("symmetry: read back, the samples count as an anisotropic surface's");
  const std::size_t count = samples.pairs.size();
  if (count > 0x7fffffff)
    throw Error(Error::Kind::Value, {"too many samples", path.string(), std::to_string(count), "2147483647"});
  std::string bytes;
  appendBigEndian<std::uint32_t>(bytes, static_cast<std::int32_t>(count));
  appendBigEndian<std::uint32_t>(bytes, std::int32_t{0});
  appendBigEndian<std::uint32_t>(bytes, std::int32_t{0});
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto* w : {&samples.pairs.wi, &samples.pairs.wo})
      for (std::size_t axis = 0; axis < 3; ++axis) appendBigEndian<std::uint64_t>(bytes, (*w)[axis][i]);
    appendBigEndian<std::uint64_t>(bytes, samples.values[i]);
  }
  writeBytes(path, bytes);
  return report;
}

}  // namespace

Format brdfLabTextFormat() {
  Format format{
      "brdflab-text",    "BRDFLab 0.8.2 sparse measurements, text", ".brdflab", recogniseText, readText, writeText,
      scatteredOptions()};
  format.takes.insert(format.takes.end(), {"angles", "colour"});
  format.coloursOnly = true;
  return format;
}

Format brdfLabExportFormat() {
  return {"brdflab-export",  "BRDFLab 0.8.2 exported simulation, binary",
          ".qbrdf",          recogniseExport,
          readExport,        writeExport,
          scatteredOptions()};
}

}  // namespace brdf
