// Comma-separated scattered samples, the layout of `brdf eval --out`: a header line with the columns wi_x, wi_y, wi_z,
// wo_x, wo_y, wo_z, value_0, ... in any order, then one sample a line; f_r in 1/sr without the cosine. Lines that start
// with '#' are comments; "# wavelengths_nm: 400 410 ..." makes the channels spectral and "# isotropic" says that the
// surface may be turned about its normal.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::array<std::string_view, 6> kDirectionColumns{"wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z"};
constexpr std::string_view kWavelengthsKey = "# wavelengths_nm:";
constexpr std::string_view kIsotropicKey = "# isotropic";
constexpr std::size_t kIgnored = ~std::size_t{0};

class Lines {
 public:
  Lines(std::string_view text, const std::filesystem::path& path) : text_(text), path_(path) {}
  /// The next line that is not blank, trimmed; false at the end.
  bool next(std::string_view& line) {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      line = trimmed(text_.substr(0, end));
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++number_;
      if (!line.empty()) return true;
    }
    return false;
  }
  [[noreturn]] void fail(std::string what, std::string found, std::string allowed) const {
    throw Error(Error::Kind::Format, {std::move(what), path_.string() + ", line " + std::to_string(number_),
                                      std::move(found), std::move(allowed)});
  }

 private:
  std::string_view text_;
  const std::filesystem::path& path_;
  std::size_t number_ = 0;
};

/// What each column holds: 0 to 5 a direction component, 6 + c channel c, or kIgnored.
struct Columns {
  std::vector<std::size_t> meaning;
  std::size_t channels = 0;
};

Columns readHeader(const Lines& lines, std::string_view header, ReadReport& report) {
  Columns columns;
  std::vector<bool> seen;
  for (const std::string_view name : split(header, ',')) {
    std::size_t meaning = kIgnored;
    const auto component = std::find(kDirectionColumns.begin(), kDirectionColumns.end(), name);
    if (component != kDirectionColumns.end()) {
      meaning = static_cast<std::size_t>(component - kDirectionColumns.begin());
    } else if (name.starts_with("value_")) {
      const auto channel = parseNumber(name.substr(6));
      if (!channel || *channel < 0 || *channel > 9999 || *channel != std::floor(*channel))
        lines.fail("wrong column name", std::string(name), "value_0, value_1, ...");
      meaning = 6 + static_cast<std::size_t>(*channel);
    } else {
      report.warnings.push_back("column \"" + std::string(name) + "\" is ignored");
    }
    columns.meaning.push_back(meaning);
    if (meaning == kIgnored) continue;
    if (meaning >= seen.size()) seen.resize(meaning + 1, false);
    if (seen[meaning]) lines.fail("a column stands twice", std::string(name), {});
    seen[meaning] = true;
  }
  if (seen.size() < 7 || !std::all_of(seen.begin(), seen.end(), [](bool s) { return s; }))
    lines.fail("a column is missing", std::string(header.substr(0, 80)), joined(kDirectionColumns) + ", value_0, ...");
  columns.channels = seen.size() - 6;
  return columns;
}

Channels channelsFor(const Lines& lines, std::size_t count, std::vector<double> wavelengths) {
  if (!wavelengths.empty()) {
    if (wavelengths.size() != count || !std::is_sorted(wavelengths.begin(), wavelengths.end(), std::less_equal<>()))
      lines.fail("wavelengths and value columns do not match", std::to_string(wavelengths.size()) + " wavelengths",
                 std::to_string(count) + ", ascending");
    return Channels::spectral(std::move(wavelengths));
  }
  if (count == 1) return Channels::monochrome();
  if (count != 3)
    lines.fail("the channels have no meaning", std::to_string(count) + " value columns",
               "1, 3 (linear sRGB), or a line \"# wavelengths_nm: ...\"");
  return Channels::rgb();
}

int recognise(std::string_view head, std::uint64_t) {
  head = withoutByteOrderMark(head);
  while (head.starts_with('#')) head.remove_prefix(std::min(head.find('\n'), head.size() - 1) + 1);
  const std::string_view header = head.substr(0, head.find('\n'));
  for (const std::string_view name : split(header, ','))
    if (name == "wi_x") return 90;
  return 0;
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  Lines lines(withoutByteOrderMark(bytes), path);
  ReadReport report;
  ScatteredSamples samples;
  samples.isotropic = false;
  std::vector<double> wavelengths;
  std::string_view line;
  bool header = false;
  while (!header && lines.next(line)) {
    if (line.starts_with(kWavelengthsKey)) {
      for (const std::string_view item : split(line.substr(kWavelengthsKey.size()), ' '))
        if (const auto value = parseNumber(item)) wavelengths.push_back(*value);
    } else if (line == kIsotropicKey) {
      samples.isotropic = true;
    } else {
      header = !line.starts_with('#');
    }
  }
  if (!header) lines.fail("the file holds no header line", {}, joined(kDirectionColumns) + ", value_0, ...");
  const Columns columns = readHeader(lines, line, report);
  samples.channels = channelsFor(lines, columns.channels, std::move(wavelengths));

  std::vector<double> records;  // six direction components and the values of a sample together
  const std::size_t width = 6 + columns.channels;
  std::size_t scaled = 0;
  while (lines.next(line)) {
    if (line.starts_with('#')) continue;
    const auto cells = split(line, ',');
    if (cells.size() != columns.meaning.size())
      lines.fail("wrong number of columns", std::to_string(cells.size()), std::to_string(columns.meaning.size()));
    records.resize(records.size() + width);
    double* record = records.data() + records.size() - width;
    for (std::size_t column = 0; column < cells.size(); ++column) {
      if (columns.meaning[column] == kIgnored) continue;
      const auto value = parseNumber(cells[column]);
      if (!value) lines.fail("no number", "\"" + std::string(cells[column].substr(0, 40)) + "\"", {});
      record[columns.meaning[column]] = *value;
    }
    for (double* w : {record, record + 3}) {
      const double length = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
      if (!(std::abs(length - 1) < 1e-2)) lines.fail("a direction is not of unit length", formatNumber(length, 6), "1");
      if (std::abs(length - 1) < 1e-6) continue;
      ++scaled;
      for (std::size_t axis = 0; axis < 3; ++axis) w[axis] /= length;
    }
  }
  const std::size_t count = records.size() / width;
  if (count == 0) lines.fail("the file holds no sample", {}, {});

  samples.pairs.resize(count);
  samples.values.resize(columns.channels * count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* record = records.data() + i * width;
    samples.pairs.set(i, {record[0], record[1], record[2]}, {record[3], record[4], record[5]});
    for (std::size_t channel = 0; channel < columns.channels; ++channel)
      samples.values[channel * count + i] = record[6 + channel];
  }
  if (scaled > 0) report.warnings.push_back(std::to_string(scaled) + " directions scaled to unit length");
  report.assumptions.push_back("between samples: moving least squares over the nearest");
  return finishScattered(std::move(samples), path, std::move(report), options);
}

WriteReport write(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  const ScatteredSamples samples = collectSamples(brdf, report);
  std::string text;
  if (samples.channels.kind == Channels::Kind::Spectral) {
    text += kWavelengthsKey;
    for (const double wavelength : samples.channels.wavelengths) text += " " + formatNumber(wavelength);
    text += "\n";
  }
  if (samples.isotropic) text += std::string(kIsotropicKey) + "\n";
  text += joined(kDirectionColumns, ",");
  for (std::size_t channel = 0; channel < samples.channels.count(); ++channel)
    text += ",value_" + std::to_string(channel);
  text += "\n";
  const std::size_t count = samples.pairs.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) text += formatNumber(samples.pairs.wi[axis][i]) + ",";
    for (std::size_t axis = 0; axis < 3; ++axis)
      text += formatNumber(samples.pairs.wo[axis][i]) + (axis < 2 ? "," : "");
    for (std::size_t channel = 0; channel < samples.channels.count(); ++channel)
      text += "," + formatNumber(samples.values[channel * count + i]);
    text += "\n";
  }
  writeBytes(path, text);
  return report;
}

}  // namespace

Format csvFormat() {
  return {"csv", "Comma-separated direction pairs and values", ".csv", recognise, read, write, scatteredOptions()};
}

}  // namespace brdf
