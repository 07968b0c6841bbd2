// Comma-separated scattered samples, the layout of `brdf eval --out`: a header line, then one sample a line. Columns in
// any order: the directions as wi_x, wi_y, wi_z, wo_x, wo_y, wo_z or as angles theta_i, phi_i, theta_o, phi_o (phi_i
// may be missing: 0), the values value_0, value_1, ..., and uncertainty_0, ... where known. Lines that start with '#'
// are comments, except
//   # wavelengths_nm: 400 410 ...   the channels are spectral
//   # isotropic                     the surface may be turned about its normal
//   # quantity: brdf_cos            any of the read options' keys and values (ReadOptions.h) but incident and sides;
//                                   without: brdf, degrees, anisotropic, linear_srgb
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/LineReader.h>
#include <brdf/measured/SampleRows.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::array<std::string_view, 6> kVectorColumns{"wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z"};
constexpr std::array<std::string_view, 4> kAngleColumns{"theta_i", "phi_i", "theta_o", "phi_o"};
constexpr std::string_view kWavelengthsKey = "# wavelengths_nm:";
constexpr std::string_view kIsotropicKey = "# isotropic";
constexpr std::string_view kValue = "value_", kUncertainty = "uncertainty_";
constexpr std::size_t kMissing = ~std::size_t{0};
constexpr std::size_t kMostChannels = 10000;

/// Where each number of a sample stands in a line.
struct Columns {
  std::size_t count = 0;                         ///< columns of a line
  std::array<std::size_t, 6> vectors;            ///< of kVectorColumns; unused where there are angles
  std::array<std::size_t, 4> angles;             ///< of kAngleColumns
  std::vector<std::size_t> values, uncertainty;  ///< by channel; uncertainty as many, or none
  bool byAngles = false;
};

Columns readHeader(const LineReader& lines, std::string_view header, ReadReport& report) {
  Columns columns;
  columns.vectors.fill(kMissing);
  columns.angles.fill(kMissing);
  const auto numbered = [&](std::string_view name, std::vector<std::size_t>& list) -> std::size_t& {
    const auto channel = parseNumber(name.substr(name.find('_') + 1));
    if (!channel || !(*channel >= 0 && *channel < kMostChannels) || *channel != std::floor(*channel))
      lines.fail("wrong column name", std::string(name.substr(0, 40)), "value_0, value_1, ...");
    const auto index = static_cast<std::size_t>(*channel);
    if (index >= list.size()) list.resize(index + 1, kMissing);
    return list[index];
  };
  for (const std::string_view name : split(header, ',')) {
    const auto component = std::find(kVectorColumns.begin(), kVectorColumns.end(), name);
    const auto angle = std::find(kAngleColumns.begin(), kAngleColumns.end(), name);
    std::size_t* place = nullptr;
    if (component != kVectorColumns.end())
      place = &columns.vectors[static_cast<std::size_t>(component - kVectorColumns.begin())];
    else if (angle != kAngleColumns.end())
      place = &columns.angles[static_cast<std::size_t>(angle - kAngleColumns.begin())];
    else if (name.starts_with(kValue))
      place = &numbered(name, columns.values);
    else if (name.starts_with(kUncertainty))
      place = &numbered(name, columns.uncertainty);
    else
      report.warnings.push_back("column \"" + std::string(name.substr(0, 40)) + "\" is ignored");
    if (place && *place != kMissing) lines.fail("a column stands twice", std::string(name.substr(0, 40)), {});
    if (place) *place = columns.count;
    ++columns.count;
  }
  const auto complete = [](const auto& list) { return std::find(list.begin(), list.end(), kMissing) == list.end(); };
  columns.byAngles = !complete(columns.vectors);
  if (columns.angles[1] == kMissing && columns.angles[0] != kMissing && columns.byAngles)
    columns.angles[1] = columns.count;  // a column of zeros behind the line
  if ((columns.byAngles && !complete(columns.angles)) || columns.values.empty() || !complete(columns.values) ||
      !complete(columns.uncertainty))
    lines.fail("a column is missing", std::string(header.substr(0, 80)),
               joined(kVectorColumns) + " (or " + joined(kAngleColumns) + "), value_0, ...");
  if (!columns.uncertainty.empty() && columns.uncertainty.size() != columns.values.size())
    lines.fail("uncertainties and values do not match", std::to_string(columns.uncertainty.size()) + " columns",
               std::to_string(columns.values.size()));
  return columns;
}

Channels channelsFor(const LineReader& lines, std::size_t count, std::vector<double> wavelengths) {
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
  bool directions = false, values = false;
  for (const std::string_view name : split(head.substr(0, head.find('\n')), ',')) {
    directions = directions || name == kVectorColumns[0] || name == kAngleColumns[0];
    values = values || name.starts_with(kValue);
  }
  return directions && values ? 90 : directions ? 50 : 0;
}

/// "# key: value" of a read option, as the text that parseReadOptions takes; empty when the comment is none.
std::string statedOption(std::string_view comment) {
  const std::size_t colon = comment.find(':');
  if (colon == std::string_view::npos) return {};
  const std::string_view key = trimmed(comment.substr(1, colon - 1));
  for (const ReadOptionKey& known : readOptionKeys())
    if (known.key == key && key != "incident" && key != "sides")
      return std::string(key) + "=" + std::string(trimmed(comment.substr(colon + 1)));
  return {};
}

/// What the lines above the header say.
struct Preamble {
  std::vector<double> wavelengths;
  ReadOptions stated;
};

Preamble readPreamble(LineReader& lines, std::string_view& line) {
  Preamble preamble;
  std::vector<std::string> stated;
  bool header = false;
  while (!header && lines.next(line)) {
    if (line.starts_with(kWavelengthsKey)) {
      for (const std::string_view item : split(line.substr(kWavelengthsKey.size()), ' '))
        if (!item.empty()) preamble.wavelengths.push_back(lines.number(item, "a wavelength"));
    } else if (line == kIsotropicKey) {
      preamble.stated.symmetry = Symmetry::Isotropic;
    } else if (line.starts_with('#')) {
      if (std::string option = statedOption(line); !option.empty()) stated.push_back(std::move(option));
    } else {
      header = true;
    }
  }
  if (!header) lines.fail("the file holds no header line", {}, joined(kVectorColumns) + ", value_0, ...");
  try {
    const auto symmetry = preamble.stated.symmetry;
    preamble.stated = parseReadOptions(stated);
    if (!preamble.stated.symmetry) preamble.stated.symmetry = symmetry;
  } catch (const Error& error) {
    lines.fail("a line above says what is not known", error.details().found, error.details().allowed);
  }
  return preamble;
}

/// The unit vector of three columns, scaled when it is nearly one.
Direction unitVector(const LineReader& lines, const double* w, std::size_t& scaled) {
  const double length = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  if (!(std::abs(length - 1) < 1e-2)) lines.fail("a direction is not of unit length", formatNumber(length, 6), "1");
  if (std::abs(length - 1) < 1e-6) return {w[0], w[1], w[2]};
  ++scaled;
  return {w[0] / length, w[1] / length, w[2] / length};
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  LineReader lines(bytes, path);
  ReadReport report;
  std::string_view line;
  Preamble preamble = readPreamble(lines, line);
  const ReadOptions& stated = preamble.stated;
  const Columns columns = readHeader(lines, line, report);
  const std::size_t channelCount = columns.values.size();
  const Channels channels = channelsFor(lines, channelCount, std::move(preamble.wavelengths));
  const auto evidence = [](bool said) { return said ? "the file says so" : "the format's definition"; };
  if (!columns.byAngles && options.angles)
    throw Error(Error::Kind::Value,
                {"the file's directions are vectors", path.string(), "option angles", "no such option"});
  double toRadians = 1;
  if (columns.byAngles && choose(options, stated.angles.value_or(AngleUnit::Degrees),
                                 evidence(stated.angles.has_value()), report) == AngleUnit::Degrees)
    toRadians = radians(1);

  SampleRows rows(channelCount);
  std::vector<double> numbers(columns.count + 1), values(channelCount), uncertainty(columns.uncertainty.size());
  std::vector<bool> wanted(columns.count, false);
  for (const std::size_t column : columns.values) wanted[column] = true;
  for (const std::size_t column : columns.uncertainty) wanted[column] = true;
  const auto want = [&](const auto& list) {
    for (const std::size_t column : list)
      if (column < columns.count) wanted[column] = true;
  };
  if (columns.byAngles)
    want(columns.angles);
  else
    want(columns.vectors);
  std::size_t scaled = 0;
  while (lines.next(line)) {
    if (line.starts_with('#')) continue;
    const auto cells = split(line, ',');
    if (cells.size() != columns.count)
      lines.fail("wrong number of columns", std::to_string(cells.size()), std::to_string(columns.count));
    for (std::size_t column = 0; column < columns.count; ++column)
      if (wanted[column]) numbers[column] = lines.number(cells[column], "a sample");
    for (std::size_t channel = 0; channel < channelCount; ++channel) values[channel] = numbers[columns.values[channel]];
    for (std::size_t channel = 0; channel < uncertainty.size(); ++channel)
      uncertainty[channel] = numbers[columns.uncertainty[channel]];
    double w[6];
    for (std::size_t k = 0; k < (columns.byAngles ? 4u : 6u); ++k) {
      w[k] = numbers[columns.byAngles ? columns.angles[k] : columns.vectors[k]];
      if (columns.byAngles && !std::isfinite(w[k]))
        lines.fail("an angle is not finite", formatNumber(w[k]), "a number");
    }
    if (columns.byAngles)
      rows.add({fromSpherical(toRadians * w[0], toRadians * w[1]), fromSpherical(toRadians * w[2], toRadians * w[3])},
               values, uncertainty);
    else
      rows.add({unitVector(lines, w, scaled), unitVector(lines, w + 3, scaled)}, values, uncertainty);
  }
  if (rows.empty()) lines.fail("the file holds no sample", {}, {});

  if (scaled > 0) report.warnings.push_back(std::to_string(scaled) + " directions scaled to unit length");
  report.assumptions.push_back("between samples: moving least squares over the nearest");
  ScatteredSamples samples =
      rows.samples(channels, stated.symmetry.value_or(Symmetry::Anisotropic) == Symmetry::Isotropic);
  toLinearSrgb(samples, options, stated.colour.value_or(ColourSpace::LinearSrgb), evidence(stated.colour.has_value()),
               report);
  ReadOptions said = options;
  if (!said.invalid) said.invalid = stated.invalid;
  return finishScattered(std::move(samples), path, std::move(report), said, stated.quantity.value_or(Quantity::Brdf),
                         evidence(stated.quantity.has_value()), evidence(stated.symmetry.has_value()));
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
  text += joined(kVectorColumns, ",");
  for (std::size_t channel = 0; channel < samples.channels.count(); ++channel)
    text += ",value_" + std::to_string(channel);
  if (!samples.uncertainty.empty())
    for (std::size_t channel = 0; channel < samples.channels.count(); ++channel)
      text += ",uncertainty_" + std::to_string(channel);
  text += "\n";
  const std::size_t count = samples.pairs.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) text += formatNumber(samples.pairs.wi[axis][i]) + ",";
    for (std::size_t axis = 0; axis < 3; ++axis)
      text += formatNumber(samples.pairs.wo[axis][i]) + (axis < 2 ? "," : "");
    for (std::size_t channel = 0; channel < samples.channels.count(); ++channel)
      text += "," + formatNumber(samples.values[channel * count + i]);
    for (std::size_t at = i; at < samples.uncertainty.size(); at += count)
      text += "," + formatNumber(samples.uncertainty[at]);
    text += "\n";
  }
  writeBytes(path, text);
  return report;
}

}  // namespace

Format csvFormat() {
  Format format{
      "csv", "Comma-separated direction pairs and values", ".csv", recognise, read, write, scatteredOptions()};
  format.takes.insert(format.takes.end(), {"angles", "colour"});
  return format;
}

}  // namespace brdf
