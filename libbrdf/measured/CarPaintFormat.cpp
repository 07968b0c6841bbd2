// The car paint database of the MPI Informatik (J. Guenther, T. Chen, M. Goesele, I. Wald, H.-P. Seidel, "Efficient
// Acquisition and Realistic Rendering of Car Paint", VMV 2005): 84 bytes of unknown content, then red, green, blue in
// little-endian float32, cell by cell: phi_d in 180 steps outermost, theta_h in 90, theta_d in 90 innermost. Colours
// are uncalibrated and the scale is not normalised. That theta_h is spaced as in MERL's tables is how BRDFLab 0.8.2
// read them; whether it is so is not established, and there is no writer.
#include <brdf/base/Error.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridFile.h>

#include <bit>
#include <cstring>

namespace brdf {
namespace {

static_assert(std::endian::native == std::endian::little, "values are copied as they are");

constexpr std::size_t kHeaderBytes = 84, kPhiD = 180, kThetaH = 90, kThetaD = 90;
constexpr std::size_t kCells = kPhiD * kThetaH * kThetaD;
constexpr std::size_t kBytes = kHeaderBytes + 3 * sizeof(float) * kCells;

int recognise(std::string_view, std::uint64_t size) { return size == kBytes ? 65 : 0; }

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  if (bytes.size() != kBytes)
    throw Error(Error::Kind::Format, {"wrong size of a car paint file", path.string(),
                                      std::to_string(bytes.size()) + " bytes", std::to_string(kBytes) + " bytes"});
  ReadReport report;
  TableData data;  // phi_d fastest, then theta_d, then theta_h
  data.channels = Channels::rgb();
  data.values.resize(3 * kCells);
  data.valid.assign(kCells, 1);
  const InvalidRule rule = choose(options, InvalidRule::Negative, "the database's marker is -1", report);
  const char* next = bytes.data() + kHeaderBytes;
  for (std::size_t p = 0; p < kPhiD; ++p)
    for (std::size_t h = 0; h < kThetaH; ++h)
      for (std::size_t d = 0; d < kThetaD; ++d)
        for (std::size_t channel = 0; channel < 3; ++channel, next += sizeof(float)) {
          float value;
          std::memcpy(&value, next, sizeof value);
          data.values[channel * kCells + p + kPhiD * (d + kThetaD * h)] = value;
        }
  const TableDirections directions(data.layout);
  inspectCells(data.values, data.valid, rule, std::bind_front(&TableDirections::aboveHorizon, &directions), report);
  toLinearSrgb(data.values, choose(options, ColourSpace::LinearSrgb, "the database does not define it", report));
  report.assumptions.push_back("phi_d spans half a turn: reciprocity is assumed");
  report.assumptions.push_back("theta_h is spaced as its square root, as BRDFLab 0.8.2 read these files");
  report.warnings.push_back("colours and scale of car paint files are not calibrated");
  report.warnings.push_back("whether theta_h is spaced so is not established: compare the width of the highlight");
  warnOfCells(report);
  return {std::make_shared<TableBrdf>(std::move(data), path.filename().string()), std::move(report)};
}

}  // namespace

Format carPaintFormat() {
  return {"carpaint", "MPI Informatik car paint database", {}, recognise, read, nullptr, {"colour", "invalid"}};
}

}  // namespace brdf
