// The UTIA BRDF database (J. Filip, R. Vavra, "Template-Based Sampling of Anisotropic BRDFs", Computer Graphics Forum
// 33(7), 2014): theta_i and theta_o in 6 steps of 15 degrees, phi_i and phi_o in 48 steps of 7.5 degrees.
// - Binary: no header, little-endian float64, three planes of [theta_i][phi_i][theta_o][phi_o], the last one fastest.
// - OpenEXR: 288 x 288 pixels, the row counting lights (48 theta_i + phi_i), the column viewers.
// Readers of the binary files disagree on whether they are encoded as sRGB: dj_brdf and the usual Python reader decode
// them, ALTA's takes them as linear; which is right is not established. The scale is taken for f_r in 1/sr; the
// database does not calibrate it to that.
#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/ImageFile.h>
#include <brdf/material/ChannelView.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridFile.h>
#include <brdf/measured/GridWriting.h>
#include <brdf/measured/ScatteredText.h>

#include <bit>
#include <cstring>

namespace brdf {
namespace {

static_assert(std::endian::native == std::endian::little, "the planes are copied as they are");

constexpr std::size_t kDirections = 6 * 48;
constexpr std::size_t kCells = kDirections * kDirections;
constexpr std::size_t kBytes = 3 * kCells * sizeof(double);

GridLayout layout() {
  const auto theta = [](AxisQuantity quantity) { return GridAxis::uniformNodes(quantity, 0, radians(75), 6); };
  const auto phi = [](AxisQuantity quantity) {
    return GridAxis::uniformNodes(quantity, 0, radians(352.5), 48).periodic();
  };
  return {Parametrisation::Spherical,
          {phi(AxisQuantity::PhiO), theta(AxisQuantity::ThetaO), phi(AxisQuantity::PhiI), theta(AxisQuantity::ThetaI)}};
}

ReadResult finish(std::vector<double> values, ColourSpace byFormat, std::string_view evidence,
                  const std::filesystem::path& path, const ReadOptions& options) {
  ReadReport report;
  GridData data;
  data.layout = layout();
  data.channels = Channels::rgb();
  data.values = std::move(values);
  toLinearSrgb(data.values, choose(options, byFormat, evidence, report));
  const Quantity quantity = choose(options, Quantity::Brdf, "the database gives a BRDF", report);
  const InvalidRule rule = choose(options, InvalidRule::NotFinite, "the format has no marker", report);
  report.assumptions.push_back("phi_i and phi_o are azimuths about the normal from the sample's own tangent");
  report.assumptions.push_back("beyond 75 degrees the value at 75 degrees stands in: nothing was measured there");
  report.warnings.push_back("the scale of UTIA files is not calibrated: compare it with a known albedo");
  return finishGrid(std::move(data), path, std::move(report), quantity, rule);
}

int recogniseBinary(std::string_view head, std::uint64_t size) {
  if (size != kBytes || head.size() < sizeof(double)) return 0;
  // No magic number: the size, and first values that can be reflectances.
  for (std::size_t i = 0; i < std::min<std::size_t>(head.size() / sizeof(double), 64); ++i) {
    double value;
    std::memcpy(&value, head.data() + i * sizeof value, sizeof value);
    if (!(value > -1e3 && value < 1e6)) return 0;
  }
  return 60;
}

ReadResult readBinary(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  if (bytes.size() != kBytes)
    throw Error(Error::Kind::Format, {"wrong size of a UTIA binary file", path.string(),
                                      std::to_string(bytes.size()) + " bytes", std::to_string(kBytes) + " bytes"});
  std::vector<double> values(3 * kCells);
  std::memcpy(values.data(), bytes.data(), kBytes);
  return finish(std::move(values), ColourSpace::EncodedSrgb, "as most readers take it, not all", path, options);
}

/// `brdf` on the database's grid in RGB, invalid cells 0: its own cells where it has them.
std::vector<double> onGrid(const Brdf& brdf, WriteReport& report) {
  const auto* own = dynamic_cast<const GridBrdf*>(&brdf);
  std::shared_ptr<const GridBrdf> made;
  if (!own || own->layout() != layout() || own->channels().kind != Channels::Kind::Rgb) {
    report.losses.push_back("resampled at 15 degrees of theta and 7.5 of phi; nothing beyond theta 75 degrees");
    made = GridBrdf::tabulate(*asRgb(BrdfPointer(BrdfPointer{}, &brdf)), layout());
    own = made.get();
  }
  reportCells(own->data(), report);
  return own->data().values;
}

WriteReport writeBinary(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  std::vector<double> values = onGrid(brdf, report);
  fromLinearSrgb(values, ColourSpace::EncodedSrgb);
  writeBytes(path, {reinterpret_cast<const char*>(values.data()), kBytes});
  return report;
}

int recogniseExr(std::string_view head, std::uint64_t) {
  constexpr std::string_view magic("\x76\x2f\x31\x01", 4);
  if (!head.starts_with(magic)) return 0;
  // The data window of 288 x 288 pixels: attribute name, type, 16 bytes, four int32.
  constexpr std::string_view window("dataWindow\0box2i\0\x10\0\0\0", 21);
  const std::size_t at = head.find(window);
  std::int32_t box[4];
  if (at == head.npos || head.size() < at + window.size() + sizeof box) return 0;
  std::memcpy(box, head.data() + at + window.size(), sizeof box);
  const auto span = [&](int from, int to) { return std::int64_t{box[to]} - box[from]; };
  return span(0, 2) == 287 && span(1, 3) == 287 ? 70 : 0;
}

ReadResult readExr(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  const Image image = readImage(bytes, path);
  if (image.width != kDirections || image.height != kDirections || image.channels < 3)
    throw Error(Error::Kind::Format, {"wrong shape of a UTIA picture", path.string(),
                                      std::to_string(image.width) + " x " + std::to_string(image.height) + " x " +
                                          std::to_string(image.channels),
                                      "288 x 288 pixels of three channels"});
  std::vector<double> values(3 * kCells);
  for (std::size_t i = 0; i < kCells; ++i)
    for (std::size_t channel = 0; channel < 3; ++channel)
      values[channel * kCells + i] = image.values[i * image.channels + channel];
  return finish(std::move(values), ColourSpace::Xyz, "the database says so of its OpenEXR texture data", path, options);
}

WriteReport writeExrFile(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  std::vector<double> values = onGrid(brdf, report);
  fromLinearSrgb(values, ColourSpace::Xyz);
  report.losses.push_back("values are rounded to single precision");
  Image image(kDirections, kDirections, 3);
  for (std::size_t i = 0; i < kCells; ++i)
    for (std::size_t channel = 0; channel < 3; ++channel)
      image.values[i * 3 + channel] = static_cast<float>(values[channel * kCells + i]);
  writeExr(image, path);
  return report;
}

}  // namespace

Format utiaFormat() {
  Format format{"utia",      "UTIA BRDF database, binary",     ".bin", recogniseBinary, readBinary,
                writeBinary, {"quantity", "colour", "invalid"}};
  format.coloursOnly = true;
  return format;
}

Format utiaExrFormat() {
  Format format{"utia-exr",   "UTIA BRDF database, OpenEXR",    ".exr", recogniseExr, readExr,
                writeExrFile, {"quantity", "colour", "invalid"}};
  format.coloursOnly = true;
  return format;
}

}  // namespace brdf
