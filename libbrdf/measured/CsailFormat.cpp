// The anisotropic measurements of A. Ngan, F. Durand and W. Matusik, "Experimental Analysis of BRDF Models" (EGSR
// 2005), as published by MIT CSAIL: 16 little-endian int32, then complete planes of red, green and blue in float32,
// cell phi_i + n(phi_i) * (phi_difference + n(phi_difference) * (theta_o + n(theta_o) * theta_i)). Of the header, 0 to
// 3 count theta_i, theta_o, phi_difference and phi_i, 6 is 1 (these coordinates), 7 is 0 (equal bins), 9 says that
// phi_difference spans half a turn, 10 counts the colours. What 4, 5, 8 and 11 to 15 mean and the absolute scale are
// not established, so there is no writer.
#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridFile.h>

#include <array>
#include <bit>
#include <cstring>

namespace brdf {
namespace {

static_assert(std::endian::native == std::endian::little, "the planes are copied as they are");

using Header = std::array<std::int32_t, 16>;

Header readHeader(std::string_view bytes) {
  Header header;
  std::memcpy(header.data(), bytes.data(), sizeof header);
  return header;
}

double bytesOf(const Header& h) { return sizeof(Header) + 12.0 * h[0] * h[1] * h[2] * h[3]; }

bool plausible(const Header& h) {
  for (std::size_t axis = 0; axis < 4; ++axis)
    if (h[axis] < 1 || h[axis] > 10000) return false;
  return h[6] == 1 && h[7] == 0 && (h[9] == 0 || h[9] == 1) && h[10] == 3;
}

int recognise(std::string_view head, std::uint64_t size) {
  if (head.size() < sizeof(Header)) return 0;
  const Header header = readHeader(head);
  if (!plausible(header)) return 0;
  return bytesOf(header) == static_cast<double>(size) ? 92 : 45;
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  const auto fail = [&](const char* what, std::string found, std::string allowed) {
    throw Error(Error::Kind::Format, {what, path.string() + ", offset 0", std::move(found), std::move(allowed)});
  };
  if (bytes.size() < sizeof(Header)) fail("the header is cut short", std::to_string(bytes.size()) + " bytes", "64");
  const Header header = readHeader(bytes);
  std::string shape;
  for (std::size_t axis = 0; axis < 4; ++axis) shape += (axis ? " x " : "") + std::to_string(header[axis]);
  if (!plausible(header)) fail("not a header of MIT CSAIL data", shape, "e.g. 45 x 45 x 180 x 90, 3 colours");
  if (bytesOf(header) != static_cast<double>(bytes.size()))
    fail("the file's size does not match its dimensions", shape + " in " + std::to_string(bytes.size()) + " bytes",
         std::to_string(static_cast<std::uint64_t>(bytesOf(header))) + " bytes");

  const auto count = [&](std::size_t axis) { return static_cast<std::size_t>(header[axis]); };
  const bool half = header[9] == 1;
  ReadReport report;
  GridData data;
  data.layout.parametrisation = Parametrisation::Spherical;
  data.layout.axes = {GridAxis::uniformCells(AxisQuantity::PhiI, 0, radians(360), count(3)).periodic(),
                      GridAxis::uniformCells(AxisQuantity::PhiDifference, 0, radians(half ? 180 : 360), count(2)),
                      GridAxis::uniformCells(AxisQuantity::ThetaO, 0, radians(90), count(1)),
                      GridAxis::uniformCells(AxisQuantity::ThetaI, 0, radians(90), count(0))};
  if (half)
    data.layout.axes[1].outside = Outside::Invalid;
  else
    data.layout.axes[1].period = radians(360);
  data.channels = Channels::rgb();
  const std::size_t cells = data.layout.cells();
  data.values.resize(3 * cells);
  for (std::size_t i = 0; i < 3 * cells; ++i) {
    float value;
    std::memcpy(&value, bytes.data() + sizeof(Header) + sizeof(float) * i, sizeof value);
    data.values[i] = value;
  }
  const Quantity quantity = choose(options, Quantity::Brdf, "the database gives a BRDF", report);
  const InvalidRule rule = choose(options, InvalidRule::Negative, "the database's marker is negative", report);
  toLinearSrgb(data.values, choose(options, ColourSpace::LinearSrgb, "the database does not define it", report));
  report.assumptions.push_back("bins are equal and values belong to their centres");
  report.assumptions.push_back("phi_difference is phi_o - phi_i");
  if (half)
    report.warnings.push_back(
        "phi_difference spans half a turn, as the header says; by which symmetry the rest follows is not established, "
        "so "
        "it is invalid");
  report.warnings.push_back("the absolute scale of this format is not established: values are as in the file");
  report.metadata["dimensions"] = shape + " (theta_i x theta_o x phi_difference x phi_i)";
  return finishGrid(std::move(data), path, std::move(report), quantity, rule);
}

}  // namespace

Format csailFormat() {
  return {"csail", "MIT CSAIL anisotropic BRDFs", {}, recognise, read, nullptr, {"quantity", "colour", "invalid"}};
}

}  // namespace brdf
