// LightTools' BSDF text, as far as other readers accept it: '#' starts a comment; keys with counted lists in degrees;
// between DataBegin and DataEnd one block an incidence, side and kind: AOI, POI, Side, Wavelength, ScatterType,
// TristimulusValue (XYZ files), then "TIS value" and a row of radial angles for each azimuth. Outgoing directions are
// spherical: the radial angle is theta_o, and the light of the format stands at azimuth 90 degrees, so that phi_o -
// phi_i is the azimuth minus 90. Values are f_r in 1/sr.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridReading.h>
#include <brdf/measured/GridWriting.h>
#include <brdf/measured/ScatteredText.h>
#include <brdf/measured/TokenReader.h>

#include <algorithm>
#include <map>
#include <set>

namespace brdf {
namespace {

using Q = AxisQuantity;

constexpr double kLightAzimuth = 90;  // degrees
const std::vector<std::string> kTristimulus{"TrisX", "TrisY", "TrisZ"};

struct Block {
  double tis = 0;
  std::vector<double> values;  // radial fastest, then azimuth
};

/// The blocks of one component: by incidence (degrees), then channel.
using Blocks = std::map<double, std::map<std::size_t, Block>>;

struct File {
  bool plane = false, xyz = false;
  std::vector<double> azimuth, radial;
  std::map<ComponentKind, Blocks> parts;
  std::set<double> turns, wavelengths;
  std::size_t wideIncidences = 0;
};

void readHeader(TokenReader& tokens, File& file) {
  bool symmetry = false, content = false;
  while (!tokens.accept("DataBegin")) {
    const std::string key(tokens.next("DataBegin"));
    if (sameWord(key, "Symmetry")) {
      file.plane = tokens.oneOf("Symmetry", {"PlaneSymmetrical", "Asymmetric"}) == 0;
      symmetry = true;
    } else if (sameWord(key, "SpectralContent")) {
      file.xyz = tokens.oneOf("SpectralContent", {"Monochrome", "XYZ"}) == 1;
      content = true;
    } else if (sameWord(key, "ScatterAzimuth")) {
      tokens.list(file.azimuth, "ScatterAzimuth", -360, 450);
    } else if (sameWord(key, "ScatterRadial")) {
      tokens.list(file.radial, "ScatterRadial", 0, 90);
    } else {
      tokens.fail("unknown key", "\"" + key.substr(0, 40) + "\"",
                  "Symmetry, SpectralContent, ScatterAzimuth, ScatterRadial, DataBegin");
    }
  }
  const auto require = [&](bool said, const char* key) {
    if (!said) tokens.fail("a key is missing before DataBegin", {}, key);
  };
  require(symmetry, "Symmetry");
  require(content, "SpectralContent");
  require(!file.azimuth.empty(), "ScatterAzimuth");
  require(!file.radial.empty(), "ScatterRadial");
}

void readBlock(TokenReader& tokens, File& file) {
  double incidence = -1;
  bool back = false, transmitted = false, kind = false, side = false;
  std::size_t channel = 0;
  bool channelSaid = !file.xyz;
  while (!tokens.accept("TIS")) {
    const std::string key(tokens.next("a block's TIS"));
    if (sameWord(key, "AOI")) {
      incidence = tokens.number("AOI", 0, 180);
      if (incidence > 90) {
        incidence = 0;
        ++file.wideIncidences;
      }
    } else if (sameWord(key, "POI")) {
      file.turns.insert(tokens.number("POI", -360, 360));
    } else if (sameWord(key, "Side")) {
      back = tokens.oneOf("Side", {"Front", "Back"}) == 1;
      side = true;
    } else if (sameWord(key, "Wavelength")) {
      file.wavelengths.insert(tokens.number("Wavelength", 0, 1e9));
    } else if (sameWord(key, "ScatterType")) {
      transmitted = tokens.oneOf("ScatterType", {"BRDF", "BTDF"}) == 1;
      kind = true;
    } else if (sameWord(key, "TristimulusValue")) {
      channel = tokens.oneOf("TristimulusValue", kTristimulus);
      channelSaid = true;
      if (!file.xyz) tokens.fail("a TristimulusValue in a monochrome file", {}, "SpectralContent XYZ");
    } else {
      tokens.fail("unknown key", "\"" + key.substr(0, 40) + "\"",
                  "AOI, POI, Side, Wavelength, ScatterType, TristimulusValue, TIS, DataEnd");
    }
  }
  if (incidence < 0 || !side || !kind || !channelSaid)
    tokens.fail("a block without a key", {},
                incidence < 0 ? "AOI"
                : !side       ? "Side"
                : !kind       ? "ScatterType"
                              : "TristimulusValue");
  const ComponentKind component =
      back ? (transmitted ? ComponentKind::BackTransmission : ComponentKind::BackReflection)
           : (transmitted ? ComponentKind::FrontTransmission : ComponentKind::FrontReflection);
  Block block;
  block.tis = tokens.number("the TIS");
  const std::size_t count = tokens.room({file.azimuth.size(), file.radial.size()}, "the values");
  block.values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) block.values.push_back(tokens.number("a value"));
  auto& blocks = file.parts[component][incidence];
  if (!blocks.emplace(channel, std::move(block)).second)
    tokens.fail("a block stands twice", std::string(componentName(component)) + ", AOI " + formatNumber(incidence), {});
}

File readFile(TokenReader& tokens) {
  File file;
  readHeader(tokens, file);
  while (!tokens.accept("DataEnd")) {
    if (!tokens.more()) tokens.fail("the file ends where DataEnd should be", {}, {});
    readBlock(tokens, file);
  }
  if (tokens.more()) tokens.fail("something stands after DataEnd", std::string(tokens.peek().substr(0, 40)), {});
  if (file.parts.empty()) tokens.fail("the file holds no block", {}, {});
  // With several planes of incidence, or one that is not the plane of azimuth 90 degrees, the meaning of the azimuths
  // is not established.
  if (file.turns.size() > 1 || (file.turns.size() == 1 && *file.turns.begin() != 0))
    tokens.fail("planes of incidence (POI) other than 0: how they turn the azimuths is not established",
                formatNumber(*file.turns.rbegin()), "0");
  const std::size_t channels = file.xyz ? 3 : 1;
  for (const auto& [kind, blocks] : file.parts)
    for (const auto& [incidence, planes] : blocks)
      if (planes.size() != channels)
        tokens.fail("an incidence lacks tristimulus values",
                    std::string(componentName(kind)) + ", AOI " + formatNumber(incidence) + ": " +
                        std::to_string(planes.size()),
                    std::to_string(channels));
  return file;
}

/// The azimuths as phi_o - phi_i; `reversed`: they run the other way, and so must the values.
std::vector<double> differences(const TokenReader& tokens, const File& file, bool& mirrored, bool& reversed) {
  std::vector<double> result;
  for (const double azimuth : file.azimuth) result.push_back(azimuth - kLightAzimuth);
  mirrored = reversed = false;
  if (!file.plane || result.size() == 1 || fullTurn(result)) return result;
  mirrored = true;
  if (result.front() >= 0 && result.back() <= 180) return result;
  // The other side of the plane of incidence: from -180 to 0 or from 180 to 360.
  const double turn = result.front() >= 180 ? 360 : 0;
  reversed = true;
  std::vector<double> turned;
  for (std::size_t i = result.size(); i-- > 0;) turned.push_back(turn - result[i]);
  if (!(turned.front() >= 0 && turned.back() <= 180))
    tokens.fail("mirrored in the plane of incidence, but the azimuths lie on both sides of it",
                formatNumber(file.azimuth.front()) + " to " + formatNumber(file.azimuth.back()),
                "90 to 270, -90 to 90 or all around");
  return turned;
}

GridData dataOf(const File& file, const Blocks& blocks, GridLayout layout, bool reversed) {
  std::vector<double> incidences;
  for (const auto& [incidence, planes] : blocks) incidences.push_back(incidence);
  layout.axes.push_back(polarAxis(Q::ThetaI, incidences));
  GridData data{std::move(layout), file.xyz ? Channels::rgb() : Channels::monochrome(), {}, {}};
  const std::size_t radial = file.radial.size(), azimuths = file.azimuth.size();
  data.values.reserve(data.layout.cells() * data.channels.count());
  for (std::size_t c = 0; c < data.channels.count(); ++c)
    for (const auto& [incidence, planes] : blocks)
      for (std::size_t a = 0; a < azimuths; ++a) {
        const auto row =
            planes.at(c).values.begin() + static_cast<std::ptrdiff_t>((reversed ? azimuths - 1 - a : a) * radial);
        data.values.insert(data.values.end(), row, row + static_cast<std::ptrdiff_t>(radial));
      }
  return data;
}

int recognise(std::string_view head, std::uint64_t) {
  return hasWord(head, '#', "ScatterAzimuth") && hasWord(head, '#', "SpectralContent") &&
                 !hasWord(head, '#', "AngleOfIncidence")
             ? 90
             : 0;
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  TokenReader tokens(bytes, path, '#');
  ReadReport report;
  File file = readFile(tokens);
  file.plane = chooseMirror(options, file.plane, false, path, report);
  bool mirrored, reversed;
  const std::vector<double> azimuths = differences(tokens, file, mirrored, reversed);
  const GridConventions conventions =
      chooseConventions(options, Quantity::Brdf, "the format's definition",
                        file.xyz ? std::optional(ColourSpace::Xyz) : std::nullopt, "SpectralContent XYZ", report);
  report.assumptions.push_back("azimuths: the light stands at 90 degrees (as other readers do)");
  if (file.wideIncidences > 0)
    report.assumptions.push_back("angles of incidence above 90 degrees: taken for 0 (as other readers do), " +
                                 std::to_string(file.wideIncidences) + " blocks");
  if (!file.wavelengths.empty()) {
    std::vector<std::string> texts;
    for (const double wavelength : file.wavelengths) texts.push_back(formatNumber(wavelength));
    report.metadata["wavelengths as stated"] = joined(texts);
    if (!file.xyz && texts.size() > 1)
      report.warnings.push_back("blocks of several wavelengths count as one: their unit and order are not established");
  }
  const GridLayout layout{
      Parametrisation::Spherical,
      {polarAxis(Q::ThetaO, file.radial), azimuthAxis(Q::PhiDifference, azimuths, mirrored, report)},
      {.mirror = mirrored}};
  std::vector<ScatterComponent> parts;
  Components components;
  for (const auto& [kind, blocks] : file.parts) {
    if (!mirrored && file.azimuth.size() > 1 &&
        (kind == ComponentKind::BackReflection || kind == ComponentKind::BackTransmission))
      report.assumptions.push_back(
          "azimuths of the back side: counter-clockwise for who looks at the back; not "
          "established");
    TotalScatter total{kind, {}, {}};
    for (const auto& [incidence, planes] : blocks) {
      total.thetaI.push_back(radians(incidence));
      total.values.push_back(planes.at(file.xyz ? 1 : 0).tis);
    }
    components.totals.push_back(std::move(total));
    parts.push_back({kind, finishPart(dataOf(file, blocks, layout, reversed), conventions, path, report)});
  }
  return assemble(std::move(parts), std::move(components), conventions.sides, std::move(report));
}

// ----- writing -------------------------------------------------------------------------------------------------------

bool fitting(const GridLayout& layout) {
  return layout.parametrisation == Parametrisation::Spherical &&
         hasOnly(layout, {Q::ThetaI, Q::ThetaO, Q::PhiDifference});
}

std::vector<double> every(double step, double first, double last) {
  std::vector<double> values;
  for (int i = 0; first + i * step <= last; ++i) values.push_back(first + i * step);
  return values;
}

GridLayout fallback(const Brdf& brdf) {
  const bool mirror = brdf.symmetry() == Symmetry::Isotropic;
  GridAxis phi = GridAxis::listedDegrees(Q::PhiDifference, every(5, 0, mirror ? 180 : 360));
  if (!mirror) phi.period = 2 * kPi;
  return {
      Parametrisation::Spherical,
      {GridAxis::listedDegrees(Q::ThetaO, every(2.5, 0, 90)), phi, GridAxis::listedDegrees(Q::ThetaI, every(5, 0, 85))},
      {.mirror = mirror}};
}

/// The blocks of one component.
std::string blocksText(const GridBrdf& written, ComponentKind kind, bool xyz) {
  const GridLayout& layout = written.layout();
  const FileAxis incidence(layout, Q::ThetaI), azimuth(layout, Q::PhiDifference), radial(layout, Q::ThetaO);
  const bool back = kind == ComponentKind::BackReflection || kind == ComponentKind::BackTransmission;
  const bool transmitted = kind == ComponentKind::FrontTransmission || kind == ComponentKind::BackTransmission;
  std::vector<double> polar = radial.nodes;
  if (polar.size() == 1) polar = {0, kPi / 2};
  const std::size_t cells = layout.cells();
  std::string text;
  for (std::size_t i = 0; i < incidence.size(); ++i) {
    const std::vector<double> tis =
        directionalReflectance(written, fromSpherical(incidence.nodes[i], 0), {0, 0, 1}, polar);
    for (std::size_t c = 0; c < written.channels().count(); ++c) {
      text += "AOI " + degreesText(incidence.nodes[i]) + "\nPOI 0\nSide " + (back ? "Back" : "Front") +
              "\nScatterType " + (transmitted ? "BTDF" : "BRDF") + "\n";
      if (xyz) text += "TristimulusValue " + kTristimulus[c] + "\n";
      text += "TIS " + formatNumber(tis[c]) + "\n";
      for (std::size_t a = 0; a < azimuth.size(); ++a)
        for (std::size_t t = 0; t < radial.size(); ++t)
          text +=
              formatNumber(
                  written.data().values[c * cells + i * incidence.stride + a * azimuth.stride + t * radial.stride]) +
              (t + 1 < radial.size() ? " " : "\n");
    }
  }
  return text;
}

WriteReport write(const Brdf* front, const Components& components, const std::filesystem::path& path) {
  WriteReport report;
  std::vector<std::pair<ComponentKind, const Brdf*>> parts;
  if (front) parts.push_back({ComponentKind::FrontReflection, front});
  for (const ScatterComponent& part : components.scatter) parts.push_back({part.kind, part.brdf.get()});
  if (parts.empty())
    throw Error(Error::Kind::Value, {"the material has no distribution", path.string(), {}, "at least one"});
  Components unkept = components;
  unkept.scatter.clear();
  reportUnkept(unkept, {}, false, true, "lighttools", report);

  // One header holds the angles of all parts, and one of the two spectral contents.
  std::vector<std::shared_ptr<const GridBrdf>> grids;
  bool xyz = false;
  for (const auto& [kind, brdf] : parts) {
    if (brdf->symmetry() == Symmetry::Anisotropic)
      report.losses.push_back("anisotropy of the " + std::string(componentName(kind)) +
                              ": only light over the tangent (phi_i = 0) is kept");
    std::shared_ptr<const GridBrdf> grid = gridFor(*brdf, fitting, fallback(*brdf), report);
    if (!grids.empty()) {
      const FileAxis radial(grid->layout(), Q::ThetaO), first(grids[0]->layout(), Q::ThetaO);
      const FileAxis azimuth(grid->layout(), Q::PhiDifference), firstAzimuth(grids[0]->layout(), Q::PhiDifference);
      if (radial.nodes != first.nodes || azimuth.nodes != firstAzimuth.nodes ||
          grid->layout().symmetry != grids[0]->layout().symmetry) {
        grid = GridBrdf::tabulate(*grid, grids[0]->layout());
        report.losses.push_back("the " + std::string(componentName(kind)) + " is resampled at the angles of the " +
                                std::string(componentName(parts[0].first)));
      }
    }
    xyz = xyz || grid->channels().kind != Channels::Kind::Monochrome;
    grids.push_back(std::move(grid));
  }
  const GridLayout& layout = grids[0]->layout();
  const FileAxis azimuth(layout, Q::PhiDifference), radial(layout, Q::ThetaO);
  std::string text = "# " + parts[0].second->description() + "\nSymmetry ";
  text += layout.symmetry.mirror ? "PlaneSymmetrical" : "Asymmetric";
  text += std::string("\nSpectralContent ") + (xyz ? "XYZ" : "Monochrome") + "\nScatterAzimuth " +
          std::to_string(azimuth.size()) + "\n";
  for (const double angle : azimuth.nodes) text += degreesText(angle, kLightAzimuth) + " ";
  text += "\nScatterRadial " + std::to_string(radial.size()) + "\n" + radial.text() + "\nDataBegin\n";
  for (std::size_t i = 0; i < grids.size(); ++i) {
    GridData data = grids[i]->data();
    data.values = xyzOf(grids[i]->data());
    data.standardError.clear();
    if (xyz && data.channels.kind == Channels::Kind::Monochrome) {  // grey: XYZ of the white
      const Matrix3 matrix = linearSrgbToXyz();
      std::vector<double> triples;
      for (std::size_t c = 0; c < 3; ++c)
        for (const double value : data.values) triples.push_back(value * (matrix[c][0] + matrix[c][1] + matrix[c][2]));
      data.values = std::move(triples);
    }
    data.channels = xyz ? Channels::rgb() : Channels::monochrome();
    text += blocksText(GridBrdf(std::move(data), "as written"), parts[i].first, xyz);
  }
  writeBytes(path, text + "DataEnd\n");
  return report;
}

}  // namespace

Format lightToolsFormat() {
  Format format{"lighttools", "LightTools BSDF text", ".bsdf", recognise, read, nullptr, gridOptions()};
  format.write = [](const Brdf& brdf, const auto& path) { return write(&brdf, {}, path); };
  format.writeMaterial = write;
  format.coloursOnly = true;
  return format;
}

}  // namespace brdf
