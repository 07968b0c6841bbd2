// Text of scattered isotropic spectral samples by Cornell's Program of Computer Graphics, as pbrt-v2 reads it: '#'
// starts a comment; the number of wavelengths; the wavelengths in nanometres; then records theta_i phi_i theta_o phi_o
// (radians) and one BRDF value (1/sr) for each wavelength. (Pharr and Humphreys, "Physically Based Rendering", 2nd
// edition 2010, section 8.6, "measured" material.)
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/SampleRows.h>
#include <brdf/measured/ScatteredText.h>
#include <brdf/measured/TokenReader.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr double kMostWavelengths = 10000;

/// The wavelengths, or an Error that says what is wrong.
std::vector<double> readWavelengths(TokenReader& numbers) {
  const double count = numbers.number("the number of wavelengths");
  if (!(count >= 1 && count <= kMostWavelengths && count == std::floor(count)))
    numbers.fail("wrong number of wavelengths", formatNumber(count), "a whole number from 1 to 10000");
  std::vector<double> wavelengths;
  while (wavelengths.size() < static_cast<std::size_t>(count)) {
    const double wavelength = numbers.number("a wavelength");
    if (!(wavelength >= 10 && wavelength <= 1e6) || (!wavelengths.empty() && wavelength <= wavelengths.back()))
      numbers.fail("wrong wavelength", formatNumber(wavelength) + " nm", "ascending, 10 to 1000000 nm");
    wavelengths.push_back(wavelength);
  }
  return wavelengths;
}

int recognise(std::string_view head, std::uint64_t size) {
  head = withoutByteOrderMark(head);
  if (head.find('\0') != std::string_view::npos) return 0;
  // A number cut by the end of the head is no evidence.
  if (head.size() < size) head = head.substr(0, head.find_last_of(" \t\r\n") + 1);
  TokenReader numbers(head, {}, '#');
  if (!numbers.more()) return 0;
  try {
    readWavelengths(numbers);
    return 70;
  } catch (const std::exception&) {
    return 0;
  }
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  TokenReader numbers(bytes, path, '#');
  ReadReport report;
  const bool inDegrees = choose(options, AngleUnit::Radians, "the format's definition", report) == AngleUnit::Degrees;
  const Channels channels = Channels::spectral(readWavelengths(numbers));
  const std::size_t channelCount = channels.count();
  SampleRows rows(channelCount);
  std::vector<double> values(channelCount);
  double largestAngle = 0;
  while (numbers.more()) {
    double angle[4];
    for (double& value : angle) {
      value = numbers.number("an angle");
      if (!std::isfinite(value)) numbers.fail("an angle is not finite", formatNumber(value), "a number");
      if (inDegrees) value = radians(value);
      largestAngle = std::max(largestAngle, std::abs(value));
    }
    for (double& value : values) value = numbers.number("a BRDF value");
    rows.add({fromSpherical(angle[0], angle[1]), fromSpherical(angle[2], angle[3])}, values);
  }
  if (rows.empty()) numbers.fail("the file holds no sample", {}, {});
  if (!inDegrees && largestAngle > 2 * kPi * (1 + 1e-6))
    report.warnings.push_back("angles up to " + formatNumber(largestAngle, 6) +
                              ": this format has radians, the file looks like degrees (option angles=degrees)");
  report.assumptions.push_back("between samples: moving least squares over the nearest");
  return finishScattered(rows.samples(channels, true), path, std::move(report), options);
}

WriteReport write(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  const ScatteredSamples samples = collectSamples(brdf, report);
  const auto [wavelengths, order] = spectralColumns(samples.channels, report);
  if (brdf.symmetry() == Symmetry::Anisotropic)
    report.losses.push_back("symmetry: the format's readers take the surface for isotropic");

  std::string text = "# " + brdf.description() + "\n# number of wavelengths\n" + std::to_string(wavelengths.size()) +
                     "\n# wavelengths (nm)\n";
  for (const double wavelength : wavelengths) text += formatNumber(wavelength) + "\n";
  text += "# theta_i, phi_i, theta_o, phi_o (radians), BRDF values (1/sr)\n";
  const std::size_t count = samples.pairs.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [wi, wo] = samples.pairs;
    const Spherical light = toSpherical({wi[0][i], wi[1][i], wi[2][i]});
    const Spherical viewer = toSpherical({wo[0][i], wo[1][i], wo[2][i]});
    text += formatNumber(light.theta);
    for (const double angle : {light.phi, viewer.theta, viewer.phi}) text += " " + formatNumber(angle);
    for (const std::size_t channel : order) text += " " + formatNumber(samples.values[channel * count + i]);
    text += "\n";
  }
  writeBytes(path, text);
  return report;
}

}  // namespace

Format cornellFormat() {
  Format format{"cornell",         "Cornell / pbrt-v2 scattered spectral text", ".brdf", recognise, read, write,
                scatteredOptions()};
  format.takes.push_back("angles");
  return format;
}

}  // namespace brdf
