// Scattered samples of the ALTA library, text and binary (its files data_storage.cpp, args.h and params.h): header
// lines
// "#KEY value", then one sample a line (or in binary a row of doubles): coordinates in the parametrisation of
// #PARAM_IN, values as #PARAM_OUT says, and in text the intervals that #VS announces. Angles are radians. A key of our
// own, which ALTA passes over: "#WAVELENGTHS 400 410 ..." (nanometres) makes the values spectral.
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/AltaParameters.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/LineReader.h>
#include <brdf/measured/SampleRows.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

namespace brdf {
namespace {

constexpr std::size_t kMostValues = 10000;
constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kStream = "#BEGIN_STREAM";
constexpr std::string_view kWavelengths = "WAVELENGTHS";

/// All spellings of the line that ends a header.
bool endsHeader(std::string_view line) {
  return line == "#ALTA_END_HEADER" || line == "#ALTA HEADER END" || line == "#ALTA END HEADER";
}

struct Header {
  std::map<std::string, std::string, std::less<>> keys;
  bool has(std::string_view key) const { return keys.find(key) != keys.end(); }
  std::string_view operator[](std::string_view key) const {
    const auto found = keys.find(key);
    return found == keys.end() ? std::string_view() : std::string_view(found->second);
  }
  bool binary() const { return (*this)["FORMAT"] == "binary"; }
};

/// Reads the header; `first` becomes the first line of a text's data, empty in a binary file or when there is none.
Header readHeader(LineReader& lines, std::string_view& first) {
  Header header;
  first = {};
  LineReader before = lines;  // where a line that is no header line started
  for (std::string_view line; lines.next(line); before = lines) {
    if (line == kStream) return header;
    if (endsHeader(line)) {
      if (header.binary() && !lines.rest().starts_with(kStream)) return header;
      continue;
    }
    if (!line.starts_with('#')) {
      if (header.binary())
        lines = before;
      else
        first = line;
      return header;
    }
    const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
    if (end > 1) header.keys.emplace(std::string(line.substr(1, end - 1)), std::string(trimmed(line.substr(end))));
  }
  return header;
}

/// What the header says of a row.
struct Layout {
  const AltaParameters* parameters = nullptr;
  std::size_t outputs = 0;
  std::vector<std::size_t> intervals;  ///< columns of interval for each output: 0, 1 or 2
  std::size_t intervalColumns = 0;
  std::vector<std::size_t> column;  ///< output of each channel
  Channels channels;
  Quantity quantity = Quantity::Brdf;
  std::string evidence;
  bool xyz = false;
  std::size_t numbers() const { return parameters->dimension + outputs; }
};

void readOutput(const LineReader& lines, const Header& header, Layout& layout) {
  const std::string_view name = header["PARAM_OUT"];
  layout.evidence = "#PARAM_OUT " + std::string(name);
  const bool colour = name == "RGB_COLOR" || name == "XYZ_COLOR";
  layout.xyz = name == "XYZ_COLOR";
  if (name == "INV_STERADIAN_COSINE_FACTOR")
    layout.quantity = Quantity::BrdfCosine;
  else if (name == "ENERGY")
    layout.evidence = "#PARAM_OUT ENERGY has no unit of its own";
  else if (name == "UNKNOWN_OUTPUT" || !header.has("PARAM_OUT"))
    layout.evidence = "the file does not say";
  else if (name != "INV_STERADIAN" && !colour)
    lines.fail("unknown #PARAM_OUT", std::string(name.substr(0, 40)),
               "INV_STERADIAN, INV_STERADIAN_COSINE_FACTOR, ENERGY, RGB_COLOR, XYZ_COLOR");
  layout.column.resize(layout.outputs);
  for (std::size_t i = 0; i < layout.outputs; ++i) layout.column[i] = i;
  if (header.has(kWavelengths)) {
    std::vector<double> wavelengths;
    for (const std::string_view word : words(header[kWavelengths]))
      wavelengths.push_back(lines.number(word, "a wavelength"));
    if (wavelengths.size() != layout.outputs || colour)
      lines.fail("#WAVELENGTHS does not match the values", std::to_string(wavelengths.size()) + " wavelengths",
                 std::to_string(layout.outputs) + ", and no colour");
    WavelengthOrder order = orderWavelengths(wavelengths, "#WAVELENGTHS");
    layout.column = std::move(order.columns);
    layout.channels = Channels::spectral(std::move(order.wavelengths));
  } else if (layout.outputs == 3) {
    layout.channels = Channels::rgb();
  } else if (layout.outputs != 1 || colour) {
    lines.fail("the values of a sample have no meaning", std::to_string(layout.outputs) + " as " + std::string(name),
               "1, 3 (a colour), or a line #WAVELENGTHS");
  }
}

Layout readLayout(const LineReader& lines, const Header& header) {
  if (header.has("FUNC") || header.has("CMD") || header["ALTA"].starts_with("FUNC"))
    lines.fail("a fitted function of ALTA, not data", {}, "data: #DIM, #PARAM_IN, #PARAM_OUT and rows of numbers");
  Layout layout;
  layout.parameters = &altaParameters(header["PARAM_IN"], "#PARAM_IN");
  const auto dimensions = words(header["DIM"]);
  if (dimensions.size() != 2) lines.fail("wrong #DIM", std::string(header["DIM"].substr(0, 40)), "two whole numbers");
  const std::size_t inputs = lines.count(dimensions[0], "#DIM", 1, 6);
  layout.outputs = lines.count(dimensions[1], "#DIM", 1, kMostValues);
  if (inputs != layout.parameters->dimension)
    lines.fail("#DIM does not match #PARAM_IN", std::to_string(inputs),
               std::to_string(layout.parameters->dimension) + " for " + std::string(layout.parameters->name));
  readOutput(lines, header, layout);

  layout.intervals.assign(layout.outputs, 0);
  const auto vs = words(header["VS"]);
  if (vs.size() > layout.outputs)
    lines.fail("too many values of #VS", std::to_string(vs.size()), std::to_string(layout.outputs));
  for (std::size_t i = 0; i < layout.outputs && !vs.empty(); ++i) {
    layout.intervals[i] = lines.count(vs[std::min(i, vs.size() - 1)], "#VS", 0, 2);
    layout.intervalColumns += layout.intervals[i];
  }
  return layout;
}

/// Adds one row: coordinates, values, and interval columns unless `intervals` is null.
class RowTaker {
 public:
  RowTaker(const Layout& layout, AngleUnit unit, SampleRows& rows) : layout_(layout), rows_(rows) {
    factor_ = unit == AngleUnit::Degrees ? radians(1) : 1;
    bounded_ = layout.intervalColumns > 0;
    for (const std::size_t columns : layout.intervals) bounded_ = bounded_ && columns > 0;
  }
  void take(const LineReader& lines, const double* numbers, const double* intervals) {
    double x[6];
    const std::string_view name = layout_.parameters->name;
    const bool angles = !name.starts_with("COS") && name != "CARTESIAN" && name != "STEREOGRAPHIC" &&
                        name != "RUSIN_VH" && !name.starts_with("STARK") && !name.starts_with("NEUMANN");
    for (std::size_t i = 0; i < layout_.parameters->dimension; ++i) {
      if (!std::isfinite(numbers[i])) lines.fail("a coordinate is not finite", formatNumber(numbers[i]), "a number");
      x[i] = angles ? factor_ * numbers[i] : numbers[i];
      if (angles) largestAngle_ = std::max(largestAngle_, std::abs(x[i]));
    }
    const double* y = numbers + layout_.parameters->dimension;
    values_.clear();
    uncertainty_.clear();
    for (const std::size_t output : layout_.column) values_.push_back(y[output]);
    if (intervals && bounded_) {
      std::vector<double> half(layout_.outputs);
      for (std::size_t i = 0; i < layout_.outputs; ++i) {
        half[i] = layout_.intervals[i] == 1 ? std::abs(intervals[0]) : std::abs(intervals[1] - intervals[0]) / 2;
        intervals += layout_.intervals[i];
      }
      for (const std::size_t output : layout_.column) uncertainty_.push_back(half[output]);
    }
    rows_.add(layout_.parameters->pair(x), values_, uncertainty_);
  }
  double largestAngle() const { return largestAngle_; }
  /// Every value has an interval.
  bool bounded() const { return bounded_; }

 private:
  const Layout& layout_;
  SampleRows& rows_;
  double factor_ = 1, largestAngle_ = 0;
  bool bounded_ = false;
  std::vector<double> values_, uncertainty_;
};

void readText(LineReader& lines, std::string_view line, const Layout& layout, RowTaker& taker) {
  const std::size_t width = layout.numbers() + layout.intervalColumns;
  std::vector<double> row(width);
  for (bool more = !line.empty(); more; more = lines.next(line)) {
    if (line.starts_with('#')) continue;
    const auto items = words(line);
    if (items.size() != width)
      lines.fail("wrong number of columns", std::to_string(items.size()), std::to_string(width));
    for (std::size_t i = 0; i < width; ++i) row[i] = lines.number(items[i], "a sample");
    taker.take(lines, row.data(), row.data() + layout.numbers());
  }
}

void readBinary(const LineReader& lines, const Header& header, const Layout& layout, RowTaker& taker) {
  const std::string_view precision = header["PRECISION"], endian = header["ENDIAN"];
  if (precision != "ieee754-double") lines.fail("unknown #PRECISION", std::string(precision), "ieee754-double");
  if (header["VERSION"] != "0") lines.fail("unknown #VERSION", std::string(header["VERSION"]), "0");
  if (endian != "little" && endian != "big") lines.fail("unknown #ENDIAN", std::string(endian), "little, big");
  const std::string_view bytes = lines.rest();
  const std::size_t width = layout.numbers(), fitting = bytes.size() / (8 * width);
  const std::size_t count = lines.count(header["SAMPLE_COUNT"], "#SAMPLE_COUNT", 0, std::size_t{1} << 40);
  if (count > fitting)
    lines.fail("the binary data are cut short", std::to_string(fitting) + " samples",
               std::to_string(count) + " samples");
  std::vector<double> row(width);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < width; ++k) {
      std::uint64_t word;
      std::memcpy(&word, bytes.data() + 8 * (i * width + k), 8);
      if (endian == "big") word = __builtin_bswap64(word);
      row[k] = std::bit_cast<double>(word);
    }
    taker.take(lines, row.data(), nullptr);
  }
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  LineReader lines(bytes, path);
  std::string_view first;
  const Header header = readHeader(lines, first);
  const Layout layout = readLayout(lines, header);
  ReadReport report;
  const AngleUnit unit = choose(options, AngleUnit::Radians, "the format's definition", report);
  SampleRows rows(layout.outputs);
  RowTaker taker(layout, unit, rows);
  if (header.binary())
    readBinary(lines, header, layout, taker);
  else
    readText(lines, first, layout, taker);
  if (rows.empty()) lines.fail("the file holds no sample", {}, {});

  for (const auto& [key, value] : header.keys)
    if (key == "SAMPLE" || key == "ORIGIN" || key == "URL" || key == "PARAM_IN" || key == "PARAM_OUT" || key == "VS")
      report.metadata[key] = value;
  if (!layout.parameters->completed.empty())
    report.assumptions.push_back(std::string(layout.parameters->name) +
                                 " leaves a coordinate open: " + std::string(layout.parameters->completed));
  if (layout.quantity == Quantity::BrdfCosine)
    report.assumptions.push_back("the cosine in the values is the viewer's, as ALTA documents");
  if (!header.binary() && taker.bounded())
    report.assumptions.push_back("uncertainties are the half widths of the file's intervals");
  else if (layout.intervalColumns > 0)
    report.warnings.push_back("the intervals of #VS do not cover every value and are left aside");
  if (unit == AngleUnit::Radians && taker.largestAngle() > 2 * kPi * (1 + 1e-6))
    report.warnings.push_back("angles up to " + formatNumber(taker.largestAngle(), 6) +
                              ": this format has radians, the file looks like degrees (option angles=degrees)");
  ScatteredSamples samples = rows.samples(layout.channels, layout.parameters->isotropic);
  toLinearSrgb(samples, options, layout.xyz ? ColourSpace::Xyz : ColourSpace::LinearSrgb, layout.evidence, report);
  return finishScattered(std::move(samples), path, std::move(report), options, layout.quantity, layout.evidence,
                         "#PARAM_IN");
}

/// 90 where the head is ALTA's of the kind asked for.
int recogniseKind(std::string_view head, bool binary) {
  LineReader lines(head, {});
  std::string_view first;
  if (!withoutByteOrderMark(head).starts_with('#')) return 0;
  const Header header = readHeader(lines, first);
  return header.has("DIM") && header.has("PARAM_IN") && header.binary() == binary ? 90 : 0;
}
int recogniseText(std::string_view head, std::uint64_t) { return recogniseKind(head, false); }
int recogniseBinary(std::string_view head, std::uint64_t) { return recogniseKind(head, true); }

WriteReport write(const Brdf& brdf, const std::filesystem::path& path, bool binary) {
  WriteReport report;
  const ScatteredSamples samples = collectSamples(brdf, report);
  const std::size_t count = samples.pairs.size(), channels = samples.channels.count();
  const bool intervals = !samples.uncertainty.empty() && !binary;
  if (!samples.uncertainty.empty() && binary) report.losses.push_back("uncertainties: ALTA's binary rows have none");
  std::string text = "#DIM " + std::to_string(samples.isotropic ? 3 : 4) + " " + std::to_string(channels) + "\n";
  text += std::string("#PARAM_IN ") + (samples.isotropic ? "ISOTROPIC_TV_TL_DPHI" : "SPHERICAL_TL_PL_TV_PV") + "\n";
  text += std::string("#PARAM_OUT ") + (samples.channels.kind == Channels::Kind::Rgb ? "RGB_COLOR" : "INV_STERADIAN") +
          "\n";
  text += std::string("#VS ") + (intervals ? "1" : "0") + "\n";
  if (samples.channels.kind == Channels::Kind::Spectral) {
    text += "#" + std::string(kWavelengths);
    for (const double wavelength : samples.channels.wavelengths) text += " " + formatNumber(wavelength);
    text += "\n";
    report.losses.push_back("wavelengths: in a line #WAVELENGTHS that ALTA itself passes over");
  }
  if (binary)
    text += "#FORMAT binary\n#VERSION 0\n#PRECISION ieee754-double\n#SAMPLE_COUNT " + std::to_string(count) +
            "\n#ENDIAN " + (std::endian::native == std::endian::little ? "little" : "big") + "\n" +
            std::string(kStream) + "\n";
  std::vector<double> row;
  for (std::size_t i = 0; i < count; ++i) {
    const SampleAngles angles = sampleAngles(samples, i);
    if (samples.isotropic)
      row = {angles.thetaO, angles.thetaI, -angles.phiO};
    else
      row = {angles.thetaI, angles.phiI, angles.thetaO, angles.phiO};
    for (std::size_t c = 0; c < channels; ++c) row.push_back(samples.values[c * count + i]);
    for (std::size_t c = 0; c < channels && intervals; ++c) row.push_back(samples.uncertainty[c * count + i]);
    if (binary) {
      text.append(reinterpret_cast<const char*>(row.data()), 8 * row.size());
    } else {
      for (std::size_t k = 0; k < row.size(); ++k) text += (k > 0 ? "\t" : "") + formatNumber(row[k]);
      text += "\n";
    }
  }
  if (binary) text += "\n#END_STREAM\n";
  writeBytes(path, text);
  return report;
}

std::vector<std::string> options() {
  std::vector<std::string> keys = scatteredOptions();
  keys.insert(keys.end(), {"angles", "colour"});
  return keys;
}

}  // namespace

Format altaFormat() {
  return {"alta",   "ALTA scattered samples, text",
          ".alta",  recogniseText,
          read,     [](const Brdf& brdf, const std::filesystem::path& path) { return write(brdf, path, false); },
          options()};
}

Format altaBinaryFormat() {
  return {"alta-binary", "ALTA scattered samples, binary",
          ".altabin",    recogniseBinary,
          read,          [](const Brdf& brdf, const std::filesystem::path& path) { return write(brdf, path, true); },
          options()};
}

}  // namespace brdf
