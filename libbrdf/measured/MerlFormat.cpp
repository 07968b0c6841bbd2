// The MERL BRDF database (Matusik, Pfister, Brand, McMillan 2003, "A Data-Driven Reflectance Model"), binary, little
// endian: three int32 counts (theta_h, theta_d, phi_d), then complete planes of red, green and blue in float64, cell
// phi_d + n(phi_d) * (theta_d + n(theta_d) * theta_h). A value times 1/1500, 1.15/1500 or 1.66/1500 (red, green, blue)
// is f_r in 1/sr; negative means invalid. The database has 90 x 90 x 180 cells; 90 x 90 x 360 is its non-reciprocal
// variant.
#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridFile.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace brdf {
namespace {

static_assert(std::endian::native == std::endian::little, "the planes are copied as they are");

constexpr std::size_t kHeaderBytes = 12;
constexpr std::array<double, 3> kScale{1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
constexpr double kInvalid = -1;

struct Header {
  std::array<std::int32_t, 3> count;  ///< theta_h, theta_d, phi_d
  bool positive() const { return count[0] > 0 && count[1] > 0 && count[2] > 0; }
  /// Size of a file with this header, in double because the product may be anything.
  double bytes() const { return kHeaderBytes + 24.0 * count[0] * count[1] * count[2]; }
  std::string text() const {
    return std::to_string(count[0]) + " x " + std::to_string(count[1]) + " x " + std::to_string(count[2]);
  }
};

Header readHeader(std::string_view bytes) {
  Header header;
  std::memcpy(header.count.data(), bytes.data(), kHeaderBytes);
  return header;
}

int recognise(std::string_view head, std::uint64_t size) {
  if (head.size() < kHeaderBytes) return 0;
  const Header header = readHeader(head);
  if (!header.positive()) return 0;
  if (header.bytes() == static_cast<double>(size)) return 95;
  // Cut short or with something behind: the reader says so.
  constexpr std::int32_t plausible = 10000;
  return header.count[0] <= plausible && header.count[1] <= plausible && header.count[2] <= plausible ? 40 : 0;
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  const auto fail = [&](const char* what, std::string found, std::string allowed) {
    throw Error(Error::Kind::Format, {what, path.string() + ", offset 0", std::move(found), std::move(allowed)});
  };
  if (bytes.size() < kHeaderBytes)
    fail("the MERL header is cut short", std::to_string(bytes.size()) + " bytes", "12 bytes");
  const Header header = readHeader(bytes);
  if (!header.positive()) fail("wrong MERL dimensions", header.text(), "positive, such as 90 x 90 x 180");
  if (header.bytes() != static_cast<double>(bytes.size()))
    fail("the file's size does not match its dimensions",
         header.text() + " in " + std::to_string(bytes.size()) + " bytes",
         header.bytes() < 1e15 ? std::to_string(static_cast<std::uint64_t>(header.bytes())) + " bytes"
                               : "a smaller table");

  TableData data;
  data.layout.thetaH = static_cast<std::size_t>(header.count[0]);
  data.layout.thetaD = static_cast<std::size_t>(header.count[1]);
  data.layout.phiD = static_cast<std::size_t>(header.count[2]);
  // 90 theta_d of 1 degree with 180 phi_d of 1 degree cover half a turn; twice as many phi_d cover a full one.
  data.layout.reciprocal = data.layout.phiD <= 2 * data.layout.thetaD;
  data.channels = Channels::rgb();
  const std::size_t cells = data.layout.cells();
  data.values.resize(3 * cells);
  data.valid.assign(cells, 1);

  parallelFor(cells, 65536, [&](std::size_t first, std::size_t last) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      double* values = data.values.data() + channel * cells + first;
      std::memcpy(values, bytes.data() + kHeaderBytes + 8 * (channel * cells + first), 8 * (last - first));
      for (std::size_t i = 0; i < last - first; ++i) values[i] *= kScale[channel];
    }
  });
  ReadReport report;
  const TableDirections directions(data.layout);
  inspectCells(data.values, data.valid, choose(options, InvalidRule::Negative, "the database's marker is -1", report),
               std::bind_front(&TableDirections::aboveHorizon, &directions), report);
  warnOfCells(report);
  const std::vector<std::string> conventions = {
      "values times 1/1500, 1.15/1500, 1.66/1500 are f_r in 1/sr without the cosine",
      "colours are linear sRGB (the database does not define them)",
      data.layout.reciprocal ? "phi_d spans half a turn: reciprocity is assumed" : "phi_d spans a full turn",
      "the surface is isotropic", "between cells: trilinear, each value at the centre of its cell"};
  report.assumptions.insert(report.assumptions.end(), conventions.begin(), conventions.end());
  report.metadata["dimensions"] = header.text() + " (theta_h x theta_d x phi_d)";
  return {std::make_shared<TableBrdf>(std::move(data), path.filename().string()), std::move(report)};
}

/// `brdf` as a MERL-shaped RGB table: itself where it is one, else resampled.
std::shared_ptr<const TableBrdf> merlTable(const Brdf& brdf, WriteReport& report) {
  const BrdfPointer borrowed(BrdfPointer{}, &brdf);
  if (brdf.symmetry() == Symmetry::Anisotropic)
    report.losses.push_back("anisotropy: only half vectors over the tangent (phi_h = 0) are kept");
  const TableLayout layout{.phiD = brdf.reciprocal() ? 180u : 360u, .reciprocal = brdf.reciprocal()};
  const auto* table = dynamic_cast<const TableBrdf*>(&brdf);
  const bool same = table && table->data().layout == layout;
  if (same && brdf.channels().kind == Channels::Kind::Rgb) return table->with(table->lookup(), table->position());
  if (!same) report.losses.push_back("resampled at the centres of 90 x 90 x " + std::to_string(layout.phiD) + " cells");
  // Nearest: a table of the same layout keeps its cells untouched while its colours change.
  const BrdfPointer source = same ? BrdfPointer(table->with(TableBrdf::Lookup::Nearest)) : borrowed;
  return TableBrdf::tabulate(*asRgb(source), layout);
}

WriteReport write(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  const auto table = merlTable(brdf, report);
  const TableData& data = table->data();
  const std::size_t cells = data.layout.cells();
  const Header header{{static_cast<std::int32_t>(data.layout.thetaH), static_cast<std::int32_t>(data.layout.thetaD),
                       static_cast<std::int32_t>(data.layout.phiD)}};
  std::string bytes(kHeaderBytes + 24 * cells, '\0');
  std::memcpy(bytes.data(), header.count.data(), kHeaderBytes);
  std::size_t negative = 0;
  for (std::size_t channel = 0; channel < 3; ++channel)
    for (std::size_t i = 0; i < cells; ++i) {
      const double value = data.values[channel * cells + i];
      negative += value < 0;
      const double raw = data.valid[i] ? value / kScale[channel] : kInvalid;
      std::memcpy(bytes.data() + kHeaderBytes + 8 * (channel * cells + i), &raw, 8);
    }
  const auto extrapolated = std::count(data.valid.begin(), data.valid.end(), stateByte(CellState::Extrapolated));
  if (extrapolated > 0)
    report.losses.push_back(std::to_string(extrapolated) + " extrapolated cells will read as measured ones");
  if (negative > 0) report.losses.push_back(std::to_string(negative) + " negative values will read as invalid cells");
  writeBytes(path, bytes);
  return report;
}

}  // namespace

Format merlFormat() {
  Format format{"merl", "MERL BRDF database, binary", ".binary", recognise, read, write, {"invalid"}};
  format.coloursOnly = true;
  return format;
}

}  // namespace brdf
