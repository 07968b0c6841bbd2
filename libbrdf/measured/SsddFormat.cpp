// SSDD, "Surface scattering distribution data", version 0.3 (public specification by the authors of libbsdf): a header
// that starts with VERSION, then up to four blocks (BRDF, BTDF, specular reflectance, specular transmittance) of keys
// and values. Lists are in degrees, values f_r in 1/sr or fractions, PARAM0 fastest; one colour a line in text, float32
// little-endian in binary. '#' and a blank start a comment.
// distorted_spherical_coordinate_system is refused: the specification names it but does not define it.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridFile.h>
#include <brdf/measured/GridReading.h>
#include <brdf/measured/LineReader.h>
#include <brdf/measured/ScatteredText.h>
#include <brdf/measured/SsddWriter.h>
#include <brdf/measured/TokenReader.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>

namespace brdf {
namespace {

using Q = AxisQuantity;

struct DataType {
  const char* name;
  ComponentKind kind;
  bool specular;
};
constexpr std::array<DataType, 4> kDataTypes{{{"brdf", ComponentKind::FrontReflection, false},
                                              {"btdf", ComponentKind::FrontTransmission, false},
                                              {"specular_reflectance", ComponentKind::FrontReflection, true},
                                              {"specular_transmittance", ComponentKind::FrontTransmission, true}}};
constexpr std::array<const char*, 3> kParamTypes{"spherical_coordinate_system", "half_difference_coordinate_system",
                                                 "specular_coordinate_system"};

struct Block {
  const DataType* type = nullptr;
  std::string colour, parameters;
  std::vector<double> wavelengths;
  std::array<std::vector<double>, 5> lists;
  bool mirror = false, reciprocal = false, binary = false;

  bool turns() const { return lists[1].size() > 1; }
};

template <class Table>
std::string namesOf(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry);
  return joined(names);
}

/// `line` without a comment; a line that starts with '#' is one, blank after it or not.
std::string_view withoutComment(std::string_view line) {
  if (line.starts_with('#')) return {};
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
    if (at + 1 >= line.size() || line[at + 1] == ' ' || line[at + 1] == '\t') return trimmed(line.substr(0, at));
  return line;
}

std::vector<double> readList(const LineReader& lines, std::string_view text, const std::string& key) {
  std::vector<double> list;
  for (const std::string_view word : words(text)) {
    const double value = lines.number(word, key.c_str());
    if (!(value >= -360 && value <= 1e6)) lines.fail("out of range: " + key, formatNumber(value), "angles in degrees");
    list.push_back(value);
  }
  if (list.empty()) lines.fail("an empty list", key, "at least one number");
  return list;
}

void checkAscending(const LineReader& lines, const std::vector<double>& list, const std::string& key, double low,
                    double high) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!(list[i] >= low && list[i] <= high))
      lines.fail("out of range: " + key, formatNumber(list[i]), formatNumber(low) + " to " + formatNumber(high));
    if (i > 0 && !(list[i] > list[i - 1]))
      lines.fail("not ascending: " + key, formatNumber(list[i]) + " after " + formatNumber(list[i - 1]), {});
  }
}

/// The keys of a block from DATA_TYPE (already read) to DATA.
Block readBlock(LineReader& lines, std::string_view type, ReadReport& report) {
  Block block;
  for (const DataType& known : kDataTypes)
    if (type == known.name) block.type = &known;
  if (!block.type)
    lines.fail("unknown DATA_TYPE", std::string(type.substr(0, 40)),
               "brdf, btdf, specular_reflectance, specular_transmittance");
  std::string_view line;
  while (lines.next(line)) {
    const std::string_view bare = withoutComment(line);
    if (bare.empty()) continue;
    const std::string key(words(bare).front());
    const std::string_view value = trimmed(bare.substr(key.size()));
    const auto choice = [&](std::initializer_list<const char*> names) {
      for (const char* name : names)
        if (value == name) return std::string(value);
      lines.fail("unknown " + key, std::string(value.substr(0, 60)), namesOf(names));
    };
    if (key == "COLOR_MODEL") {
      block.colour = choice({"monochrome", "rgb", "xyz", "spectrum"});
    } else if (key == "WAVELENGTH_LIST") {
      block.wavelengths = readList(lines, value, key);
      checkAscending(lines, block.wavelengths, key, 10, 1e6);
    } else if (key == "PARAM_TYPE") {
      if (value == "distorted_spherical_coordinate_system")
        lines.fail("PARAM_TYPE distorted_spherical_coordinate_system is refused: the specification does not define it",
                   {}, namesOf(kParamTypes));
      block.parameters = choice({kParamTypes[0], kParamTypes[1], kParamTypes[2]});
    } else if (key == "REDUCTION_TYPE") {
      for (const std::string_view word : words(value)) {
        const bool mirror = word == "bilateral_symmetry";
        if (!mirror && word != "reciprocity")
          lines.fail("unknown REDUCTION_TYPE", std::string(word.substr(0, 60)), "bilateral_symmetry, reciprocity");
        (mirror ? block.mirror : block.reciprocal) = true;
      }
    } else if (key.size() == 11 && key.starts_with("PARAM") && key.ends_with("_LIST") && key[5] >= '0' &&
               key[5] <= '4') {
      block.lists[static_cast<std::size_t>(key[5] - '0')] = readList(lines, value, key);
    } else if (key == "DATA") {
      block.binary = choice({"ascii", "binary"}) == "binary";
      return block;
    } else if (key == "DATA_TYPE") {
      lines.fail("a block without DATA", block.type->name, "DATA ascii or DATA binary before the next DATA_TYPE");
    } else if (key == "NAME" || key == "SOURCE_TYPE" || key == "DEVICE" || key == "CREATION_DATE" ||
               key == "MEASUREMENT_DATE") {
      report.metadata[std::string(block.type->name) + " " + key] = trimmed(line.substr(key.size()));
    } else if (report.warnings.size() < 20) {
      report.warnings.push_back("\"" + key.substr(0, 40) + "\" is ignored: the specification does not know it");
    }
  }
  lines.fail("the file ends where DATA should be", block.type->name, {});
}

/// Layout and channels of a block whose keys are complete; the position is still at DATA.
Channels channelsOf(const LineReader& lines, const Block& block) {
  if (block.colour.empty()) lines.fail("a key is missing before DATA", {}, "COLOR_MODEL");
  if (block.colour == "monochrome") return Channels::monochrome();
  if (block.colour != "spectrum") return Channels::rgb();
  if (block.wavelengths.empty()) lines.fail("a key is missing before DATA", {}, "WAVELENGTH_LIST");
  return Channels::spectral(block.wavelengths);
}

GridLayout layoutOf(const LineReader& lines, const Block& block, ReadReport& report) {
  const auto list = [&](std::size_t which, double low, double high) {
    const std::string key = "PARAM" + std::to_string(which) + "_LIST";
    if (block.lists[which].empty()) lines.fail("a key is missing before DATA", {}, key);
    checkAscending(lines, block.lists[which], key, low, high);
    return block.lists[which];
  };
  if (block.parameters.empty()) lines.fail("a key is missing before DATA", {}, "PARAM_TYPE");
  const bool spherical = block.parameters == kParamTypes[0], half = block.parameters == kParamTypes[1];
  const bool specular = !spherical && !half, turns = block.turns();
  if (block.reciprocal && !half)
    lines.fail("REDUCTION_TYPE reciprocity of another system", block.parameters, kParamTypes[1]);
  if (block.mirror && turns && !specular)
    lines.fail("REDUCTION_TYPE bilateral_symmetry with several PARAM1: which azimuths it mirrors is not established",
               block.parameters, kParamTypes[2]);
  if (spherical && block.lists[1].size() == 1 && block.lists[1][0] != 0)
    lines.fail("one PARAM1 that is not 0", formatNumber(block.lists[1][0]), "0, or several");
  GridLayout layout;
  layout.parametrisation = half        ? Parametrisation::HalfDifference
                           : spherical ? Parametrisation::Spherical
                                       : Parametrisation::Specular;
  layout.symmetry = {block.mirror && !(turns && specular), block.reciprocal};
  layout.axes.push_back(polarAxis(half ? Q::ThetaH : Q::ThetaI, list(0, 0, 90)));
  if (turns) layout.axes.push_back(azimuthAxis(half ? Q::PhiH : Q::PhiI, list(1, 0, 360), false, report));
  layout.axes.push_back(polarAxis(half        ? Q::ThetaD
                                  : spherical ? Q::ThetaO
                                              : Q::SpecularTheta,
                                  list(2, 0, specular ? 180 : 90)));
  const double end = block.mirror ? (block.reciprocal ? 90 : 180) : block.reciprocal ? 180 : 360;
  const std::vector<double> azimuths = list(3, 0, end);
  const Q azimuth = half ? Q::PhiD : specular ? Q::SpecularPhi : turns ? Q::PhiO : Q::PhiDifference;
  if (block.reciprocal) {
    GridAxis axis = GridAxis::listedDegrees(azimuth, azimuths);
    if (!block.mirror) axis.period = kPi;
    layout.axes.push_back(std::move(axis));
  } else {
    layout.axes.push_back(azimuthAxis(azimuth, azimuths, block.mirror, report));
  }
  if (!block.lists[4].empty()) {
    if (!specular) lines.fail("PARAM4_LIST of another system", block.parameters, kParamTypes[2]);
    if (block.lists[4].size() != block.lists[0].size())
      lines.fail("PARAM4_LIST does not match PARAM0_LIST", std::to_string(block.lists[4].size()),
                 std::to_string(block.lists[0].size()));
    for (const double offset : block.lists[4]) {
      if (!(offset >= -90 && offset <= 90)) lines.fail("out of range: PARAM4_LIST", formatNumber(offset), "-90 to 90");
      layout.specularOffsets.push_back(radians(offset));
    }
  }
  return layout;
}

/// The values of `cells` colours, planar.
std::vector<double> readValues(LineReader& lines, const Block& block, std::size_t cells, std::size_t channels) {
  const std::size_t count = boundedProduct({cells, channels});
  if (block.binary) {
    if (count > lines.rest().size() / 4)
      lines.fail("the file is too short for the values", std::to_string(lines.rest().size()) + " bytes follow",
                 std::to_string(count) + " float32");
    const std::string_view bytes = lines.bytes(4 * count, "the values");
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t bits = 0;
      for (std::size_t b = 4; b-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[4 * i + b]);
      values[i % channels * cells + i / channels] = static_cast<double>(std::bit_cast<float>(bits));
    }
    return values;
  }
  if (count > lines.rest().size() / 2 + 1)
    lines.fail("the file is too short for the values", std::to_string(lines.rest().size()) + " bytes follow",
               std::to_string(count) + " numbers");
  std::vector<double> values(count);
  std::string_view line;
  for (std::size_t i = 0; i < cells;) {
    if (!lines.next(line))
      lines.fail("the file ends within the values", std::to_string(i) + " colours", std::to_string(cells));
    const std::vector<std::string_view> numbers = words(withoutComment(line));
    if (numbers.empty()) continue;
    if (numbers.size() != channels)
      lines.fail("wrong number of values in a line", std::to_string(numbers.size()), std::to_string(channels));
    for (std::size_t c = 0; c < channels; ++c) values[c * cells + i] = lines.number(numbers[c], "a value");
    ++i;
  }
  return values;
}

int recognise(std::string_view head, std::uint64_t) {
  head = withoutByteOrderMark(head);
  while (!(head = trimmed(head)).empty() && head.front() == '#')
    head.remove_prefix(std::min(head.find('\n'), head.size()));
  if (!head.starts_with("VERSION ") && !head.starts_with("VERSION\t")) return 0;
  return head.find("DATA_TYPE") != std::string_view::npos ? 95 : 40;
}

/// Adds the fractions of a specular block.
void addSpecular(const LineReader& lines, const Block& block, Channels channels, std::vector<double> values,
                 Components& components, ReadReport& report) {
  const std::size_t count = block.lists[0].size(), turns = std::max<std::size_t>(1, block.lists[1].size());
  checkAscending(lines, block.lists[0], "PARAM0_LIST", 0, 90);
  SpecularComponent specular{block.type->kind, std::move(channels), {}, {}};
  for (const double angle : block.lists[0]) specular.thetaI.push_back(radians(angle));
  for (std::size_t c = 0; c < specular.channels.count(); ++c)
    for (std::size_t i = 0; i < count; ++i) specular.values.push_back(values[c * count * turns + i]);
  if (turns > 1)
    report.warnings.push_back(std::string(block.type->name) + ": only the values at azimuth " +
                              formatNumber(block.lists[1][0]) + " are kept of " + std::to_string(turns) + " azimuths");
  components.specular.push_back(std::move(specular));
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  LineReader lines(bytes, path);
  ReadReport report;
  std::vector<ScatterComponent> parts;
  Components components;
  std::vector<const DataType*> seen;
  std::optional<GridConventions> plain, colours[2];  // colours: rgb, xyz
  Sides sides = Sides::AsStated;
  std::string_view line;
  bool version = false;
  const auto conventionsOf = [&](const Block& block) {
    const bool rgb = block.colour == "rgb", xyz = block.colour == "xyz";
    auto& known = rgb || xyz ? colours[xyz] : plain;
    if (!known) {
      ReadOptions asked = options;
      if (!rgb && !xyz) asked.colour.reset();
      ReadReport mine;
      known = chooseConventions(
          asked, Quantity::Brdf, "the format's definition",
          rgb   ? std::optional(ColourSpace::LinearSrgb)
          : xyz ? std::optional(ColourSpace::Xyz)
                : std::nullopt,
          rgb ? "COLOR_MODEL rgb; the specification leaves its primaries open" : "COLOR_MODEL xyz", mine);
      for (std::string& sentence : mine.assumptions)
        if (std::find(report.assumptions.begin(), report.assumptions.end(), sentence) == report.assumptions.end())
          report.assumptions.push_back(std::move(sentence));
      sides = known->sides;
    }
    return *known;
  };
  while (lines.next(line)) {
    const std::string_view bare = withoutComment(line);
    if (bare.empty()) continue;
    const std::string key(words(bare).front());
    const std::string_view value = trimmed(bare.substr(key.size()));
    if (!version) {
      if (key != "VERSION") lines.fail("the file does not start with VERSION", key.substr(0, 40), "VERSION");
      version = true;
      report.metadata["VERSION"] = value;
      if (!value.starts_with("0."))
        report.warnings.push_back("version " + std::string(value.substr(0, 20)) + ": read as version 0.3");
      continue;
    }
    if (key != "DATA_TYPE") {
      if (!seen.empty()) lines.fail("something stands between the blocks", key.substr(0, 40), "DATA_TYPE");
      report.metadata[key.substr(0, 40)] = trimmed(line.substr(key.size()));
      continue;
    }
    Block block = readBlock(lines, value, report);
    if (!block.type->specular) block.mirror = chooseMirror(options, block.mirror, block.turns(), path, report);
    if (std::find(seen.begin(), seen.end(), block.type) != seen.end())
      lines.fail("a DATA_TYPE stands twice", block.type->name, "once");
    seen.push_back(block.type);
    Channels channels = channelsOf(lines, block);
    const GridConventions conventions = conventionsOf(block);
    if (block.type->specular) {
      if (block.lists[0].empty()) lines.fail("a key is missing before DATA", {}, "PARAM0_LIST");
      const std::size_t cells =
          boundedProduct({block.lists[0].size(), std::max<std::size_t>(1, block.lists[1].size())});
      std::vector<double> values = readValues(lines, block, cells, channels.count());
      if (channels.kind == Channels::Kind::Rgb) toLinearSrgb(values, conventions.colour);
      addSpecular(lines, block, std::move(channels), std::move(values), components, report);
      continue;
    }
    GridData data{layoutOf(lines, block, report), std::move(channels), {}, {}};
    std::vector<std::size_t> sizes;
    for (const GridAxis& axis : data.layout.axes) sizes.push_back(axis.size());
    data.values = readValues(lines, block, boundedProduct(sizes), data.channels.count());
    if (block.mirror && block.turns()) mirrorAzimuth(data, Q::SpecularPhi);
    parts.push_back({block.type->kind, finishPart(std::move(data), conventions, path, report)});
  }
  if (seen.empty()) lines.fail("the file holds no block", {}, "DATA_TYPE");
  if (options.colour && !colours[0] && !colours[1])
    throw Error(Error::Kind::Value, {"the file's values are no colours", "option colour", {}, "no such option"});
  return assemble(std::move(parts), std::move(components), sides, std::move(report));
}

}  // namespace

Format ssddFormat() {
  Format format{"ssdd", "SSDD, surface scattering distribution data", ".ssdd", recognise, read, nullptr, gridOptions()};
  format.write = [](const Brdf& brdf, const auto& path) { return writeSsdd(&brdf, {}, path); };
  format.writeMaterial = writeSsdd;
  return format;
}

}  // namespace brdf
