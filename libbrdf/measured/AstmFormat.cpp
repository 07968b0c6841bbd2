// ASTM E1392-96 text: lines "KEY value" in any order, among them NUM_POINTS n and last VARS with the names of the
// columns: theta_i, phi_i, theta_s, phi_s, then R, G, B or X, Y, Z or wavelengths ("400nm") or one integrated value;
// then n lines of comma-separated numbers. Values are f_r in 1/sr; files at large have radians. (ASTM E1392-96,
// "Standard Practice for Angle Resolved Optical Scatter Measurements on Specular or Diffuse Surfaces".)
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/LineReader.h>
#include <brdf/measured/SampleRows.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace brdf {
namespace {

constexpr std::array<std::string_view, 4> kAngles{"theta_i", "phi_i", "theta_s", "phi_s"};
constexpr std::size_t kMissing = ~std::size_t{0};
constexpr std::size_t kMostColumns = 10000;
constexpr double kMostRadians = 2;  ///< a polar angle above this is in degrees

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// The rest of the line when its first word is `key`, else null.
bool keyed(std::string_view line, std::string_view key, std::string_view& value) {
  if (!lower(line.substr(0, key.size())).starts_with(lower(key))) return false;
  value = line.substr(std::min(key.size(), line.size()));
  if (!value.empty() && std::string_view(" \t:=,").find(value.front()) == std::string_view::npos) return false;
  while (!value.empty() && std::string_view(" \t:=,").find(value.front()) != std::string_view::npos)
    value.remove_prefix(1);
  return true;
}

struct Columns {
  std::size_t count = 0;
  std::array<std::size_t, 4> angles;
  std::vector<std::size_t> values;  ///< by channel
  Channels channels;
  bool xyz = false;
};

Columns readColumns(const LineReader& lines, std::string_view vars) {
  Columns columns;
  columns.angles.fill(kMissing);
  std::vector<std::string> names;
  std::vector<std::size_t> places;
  std::vector<double> wavelengths;
  for (std::string_view name : split(vars, ',')) {
    while (!name.empty() && (name.front() == '"' || name.back() == '"'))
      name = trimmed(name.front() == '"' ? name.substr(1) : name.substr(0, name.size() - 1));
    const std::string plain = lower(name);
    const auto angle = std::find(kAngles.begin(), kAngles.end(),
                                 plain == "theta_r" ? "theta_s"
                                 : plain == "phi_r" ? "phi_s"
                                                    : plain);
    if (angle != kAngles.end()) {
      std::size_t& place = columns.angles[static_cast<std::size_t>(angle - kAngles.begin())];
      if (place != kMissing) lines.fail("a column of VARS stands twice", plain, {});
      place = columns.count;
    } else {
      names.push_back(plain);
      places.push_back(columns.count);
      if (plain.ends_with("nm"))
        if (const auto wavelength = parseNumber(std::string_view(plain).substr(0, plain.size() - 2)))
          wavelengths.push_back(*wavelength);
    }
    if (++columns.count > kMostColumns) lines.fail("too many columns in VARS", {}, std::to_string(kMostColumns));
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (columns.angles[i] == kMissing) lines.fail("VARS lacks a column", std::string(kAngles[i]), joined(kAngles));
  const auto triple = [&](const char* a, const char* b, const char* c) {
    columns.values.clear();
    for (const char* wanted : {a, b, c}) {
      const auto found = std::find(names.begin(), names.end(), wanted);
      if (found == names.end()) return false;
      columns.values.push_back(places[static_cast<std::size_t>(found - names.begin())]);
    }
    return names.size() == 3;
  };
  if (triple("r", "g", "b")) {
    columns.channels = Channels::rgb();
  } else if (triple("x", "y", "z")) {
    columns.channels = Channels::rgb();
    columns.xyz = true;
  } else if (!wavelengths.empty() && wavelengths.size() == names.size()) {
    WavelengthOrder order = orderWavelengths(wavelengths, "VARS");
    columns.values.clear();
    for (const std::size_t column : order.columns) columns.values.push_back(places[column]);
    columns.channels = Channels::spectral(std::move(order.wavelengths));
  } else if (names.size() == 1) {
    columns.values = {places[0]};
    columns.channels = Channels::monochrome();
  } else {
    lines.fail("the value columns of VARS have no meaning", std::string(vars.substr(0, 80)),
               "R,G,B or X,Y,Z or wavelengths such as 400nm, or one column");
  }
  return columns;
}

int recognise(std::string_view head, std::uint64_t) {
  LineReader lines(head, {});
  bool points = false;
  std::string_view value;
  for (std::string_view line; lines.next(line);) {
    points = points || keyed(line, "NUM_POINTS", value);
    if (keyed(line, "VARS", value) && lower(value).find("theta_i") != std::string::npos) return points ? 95 : 80;
  }
  return 0;
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  LineReader lines(bytes, path);
  ReadReport report;
  std::string_view line, value;
  std::size_t points = kMissing;
  bool vars = false;
  while (!vars && lines.next(line)) {
    if (keyed(line, "VARS", value)) {
      vars = true;
    } else if (keyed(line, "NUM_POINTS", value)) {
      points = lines.count(value, "NUM_POINTS", 0, std::size_t{1} << 40);
    } else if (const std::size_t end = line.find_first_of(" \t:="); end != std::string_view::npos && end < 40) {
      report.metadata.emplace(std::string(line.substr(0, end)),
                              std::string(trimmed(line.substr(end + 1)).substr(0, 200)));
    }
  }
  if (!vars) lines.fail("the file has no line VARS", {}, "VARS theta_i,phi_i,theta_s,phi_s,...");
  const Columns columns = readColumns(lines, value);

  std::vector<double> numbers;  // line after line
  double largestPolar = 0;
  while (lines.next(line)) {
    if (std::string_view rest; keyed(line, "NUM_POINTS", rest)) {
      points = lines.count(rest, "NUM_POINTS", 0, std::size_t{1} << 40);
      continue;
    }
    const auto cells = split(line, ',');
    if (cells.size() != columns.count)
      lines.fail("wrong number of columns", std::to_string(cells.size()), std::to_string(columns.count));
    for (const std::string_view cell : cells) numbers.push_back(lines.number(cell, "a sample"));
    const double* row = numbers.data() + numbers.size() - columns.count;
    for (std::size_t i = 0; i < 4; ++i) {
      const double angle = row[columns.angles[i]];
      if (!std::isfinite(angle)) lines.fail("an angle is not finite", formatNumber(angle), "a number");
      if (i % 2 == 0) largestPolar = std::max(largestPolar, std::abs(angle));
    }
  }
  if (numbers.empty()) lines.fail("the file holds no sample", {}, {});
  const std::size_t count = numbers.size() / columns.count;
  if (points != kMissing && points != count)
    report.warnings.push_back("NUM_POINTS says " + std::to_string(points) + ", the file holds " +
                              std::to_string(count));

  const AngleUnit seen = largestPolar > kMostRadians ? AngleUnit::Degrees : AngleUnit::Radians;
  const double toRadians =
      choose(options, seen, "polar angles up to " + formatNumber(largestPolar, 6), report) == AngleUnit::Degrees
          ? radians(1)
          : 1;
  SampleRows rows(columns.values.size());
  std::vector<double> values(columns.values.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double* row = numbers.data() + i * columns.count;
    for (std::size_t c = 0; c < values.size(); ++c) values[c] = row[columns.values[c]];
    const auto angle = [&](std::size_t k) { return toRadians * row[columns.angles[k]]; };
    rows.add({fromSpherical(angle(0), angle(1)), fromSpherical(angle(2), angle(3))}, values);
  }
  ScatteredSamples samples = rows.samples(columns.channels, true);
  samples.isotropic = oneIncidentAzimuth(samples);
  const std::string_view azimuths = azimuthEvidence(samples.isotropic);
  toLinearSrgb(samples, options, columns.xyz ? ColourSpace::Xyz : ColourSpace::LinearSrgb, "the columns of VARS",
               report);
  report.assumptions.push_back("between samples: moving least squares over the nearest");
  return finishScattered(std::move(samples), path, std::move(report), options, Quantity::Brdf,
                         "the format's definition", azimuths);
}

WriteReport write(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  const ScatteredSamples samples = collectSamples(brdf, report);
  if (!samples.uncertainty.empty()) report.losses.push_back("uncertainties");
  const std::size_t count = samples.pairs.size(), channels = samples.channels.count();
  std::string text = "NUM_POINTS " + std::to_string(count) + "\nVARS " + joined(kAngles, ",");
  if (samples.channels.kind == Channels::Kind::Rgb) text += ",R,G,B";
  if (samples.channels.kind == Channels::Kind::Monochrome) text += ",Integrated";
  for (const double wavelength : samples.channels.wavelengths) text += "," + formatNumber(wavelength) + "nm";
  text += "\n";
  for (std::size_t i = 0; i < count; ++i) {
    const SampleAngles angles = sampleAngles(samples, i);
    for (const double angle : {angles.thetaI, angles.phiI, angles.thetaO, angles.phiO})
      text += formatNumber(angle) + ",";
    for (std::size_t channel = 0; channel < channels; ++channel)
      text += formatNumber(samples.values[channel * count + i]) + (channel + 1 < channels ? "," : "\n");
  }
  writeBytes(path, text);
  return report;
}

}  // namespace

Format astmFormat() {
  Format format{"astm", "ASTM E1392 scattered samples, text", ".astm", recognise, read, write, scatteredOptions()};
  format.takes.insert(format.takes.end(), {"angles", "colour"});
  return format;
}

}  // namespace brdf
