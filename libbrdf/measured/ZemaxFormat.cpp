// Zemax OpticStudio's tabular BSDF text, which began as Radiant Imaging's "BSDF Data Interchange" (Zemax knowledge
// base, "Zemax Tabular BSDF data file format"): '#' starts a comment; keys with counted lists in degrees; then for each
// channel DataBegin, for each sample rotation and angle of incidence "TIS value" and a row of radial angles for each
// azimuth, DataEnd. Values are the BSDF in 1/sr. Radial and azimuth angle are about the specular direction (straight
// through for a BTDF), azimuth 0 towards the normal and counter-clockwise: Parametrisation::Specular.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridReading.h>
#include <brdf/measured/GridWriting.h>
#include <brdf/measured/ScatteredText.h>
#include <brdf/measured/TokenReader.h>

#include <array>

namespace brdf {
namespace {

using Q = AxisQuantity;

const std::vector<std::string> kChannels{"Monochrome", "TristimulusX", "TristimulusY", "TristimulusZ"};

struct Header {
  bool plane = false, turns = false, xyz = false, transmitted = false;
  std::vector<double> rotation, incidence, azimuth, radial;

  std::size_t incidences() const { return boundedProduct({rotation.size(), incidence.size()}); }
};

bool startsChannel(std::string_view word) {
  for (const std::string& name : kChannels)
    if (sameWord(word, name)) return true;
  return false;
}

Header readHeader(TokenReader& tokens, ReadReport& report) {
  Header header;
  bool symmetry = false, content = false, type = false;
  while (tokens.more() && !startsChannel(tokens.peek())) {
    const std::string key(tokens.next("a key"));
    if (sameWord(key, "Source")) {
      report.metadata["source"] = tokens.next("Source");
    } else if (sameWord(key, "Symmetry")) {
      const std::size_t kind = tokens.oneOf("Symmetry", {"PlaneSymmetrical", "ASymmetrical", "ASymmetrical4D"});
      header.plane = kind == 0;
      header.turns = kind == 2;
      symmetry = true;
    } else if (sameWord(key, "SpectralContent")) {
      header.xyz = tokens.oneOf("SpectralContent", {"Monochrome", "XYZ"}) == 1;
      content = true;
    } else if (sameWord(key, "ScatterType")) {
      header.transmitted = tokens.oneOf("ScatterType", {"BRDF", "BTDF"}) == 1;
      type = true;
    } else if (sameWord(key, "SampleRotation")) {
      tokens.list(header.rotation, "SampleRotation", -360, 360);
    } else if (sameWord(key, "AngleOfIncidence")) {
      tokens.list(header.incidence, "AngleOfIncidence", 0, 90);
    } else if (sameWord(key, "ScatterAzimuth")) {
      tokens.list(header.azimuth, "ScatterAzimuth", -360, 360);
    } else if (sameWord(key, "ScatterRadial")) {
      tokens.list(header.radial, "ScatterRadial", 0, 180);
    } else {
      tokens.fail("unknown key", "\"" + key.substr(0, 40) + "\"",
                  "Source, Symmetry, SpectralContent, ScatterType, SampleRotation, AngleOfIncidence, ScatterAzimuth, "
                  "ScatterRadial, " +
                      joined(kChannels));
    }
  }
  const auto require = [&](bool said, const char* key) {
    if (!said) tokens.fail("a key is missing before the values", {}, key);
  };
  require(symmetry, "Symmetry");
  require(content, "SpectralContent");
  require(type, "ScatterType");
  require(!header.incidence.empty(), "AngleOfIncidence");
  require(!header.azimuth.empty(), "ScatterAzimuth");
  require(!header.radial.empty(), "ScatterRadial");
  if (header.rotation.empty()) header.rotation = {0};
  return header;
}

/// All channels in the order of the file: radial fastest, then azimuth, incidence, rotation; and each one's TIS.
void readValues(TokenReader& tokens, const Header& header, std::vector<double>& values, std::vector<double>& tis) {
  const std::size_t channels = header.xyz ? 3 : 1, row = header.radial.size() * header.azimuth.size();
  values.reserve(tokens.room({row, header.incidences(), channels}, "the values"));
  for (std::size_t c = 0; c < channels; ++c) {
    tokens.oneOf("channel", {kChannels[header.xyz ? c + 1 : 0]});
    tokens.oneOf("start of the values", {"DataBegin"});
    for (std::size_t i = 0; i < header.incidences(); ++i) {
      tokens.oneOf("start of an incidence", {"TIS"});
      tis.push_back(tokens.number("the TIS"));
      for (std::size_t k = 0; k < row; ++k) values.push_back(tokens.number("a value"));
    }
    tokens.oneOf("end of the values", {"DataEnd"});
  }
  if (tokens.more())
    tokens.fail("something stands after the last channel", std::string(tokens.peek().substr(0, 40)), {});
}

int recognise(std::string_view head, std::uint64_t) {
  return hasWord(head, '#', "AngleOfIncidence") && hasWord(head, '#', "ScatterType") ? 95 : 0;
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  TokenReader tokens(bytes, path, '#');
  ReadReport report;
  Header header = readHeader(tokens, report);
  const bool turns = header.rotation.size() > 1;
  header.plane = chooseMirror(options, header.plane, turns, path, report);
  if (header.plane && !(header.azimuth.front() >= 0 && header.azimuth.back() <= 180))
    tokens.fail("mirrored in the plane of incidence, with azimuths on both sides",
                formatNumber(header.azimuth.front()) + " to " + formatNumber(header.azimuth.back()), "0 to 180");
  std::vector<double> values, tis;
  readValues(tokens, header, values, tis);

  if (turns && !header.turns)
    report.warnings.push_back(std::to_string(header.rotation.size()) +
                              " sample rotations, though Symmetry is not ASymmetrical4D");
  GridData data{
      {Parametrisation::Specular,
       {polarAxis(Q::SpecularTheta, header.radial), azimuthAxis(Q::SpecularPhi, header.azimuth, header.plane, report),
        polarAxis(Q::ThetaI, header.incidence)},
       {.mirror = header.plane && !turns}},
      header.xyz ? Channels::rgb() : Channels::monochrome(),
      std::move(values),
      {}};
  if (turns) {
    data.layout.axes.push_back(azimuthAxis(Q::PhiI, header.rotation, false, report));
    report.assumptions.push_back(
        "SampleRotation: taken for the azimuth of the light in the sample's frame; its zero and sense are not "
        "established");
    if (header.plane) mirrorAzimuth(data, Q::SpecularPhi);
  }
  if (header.transmitted)
    report.assumptions.push_back(
        "AngleOfIncidence: the light's, and that of the straight-through direction; Zemax calls it the angle of the "
        "specular beam, which refraction would part from the light's");
  const GridConventions conventions =
      chooseConventions(options, Quantity::Brdf, "the format's definition",
                        header.xyz ? std::optional(ColourSpace::Xyz) : std::nullopt, "SpectralContent XYZ", report);
  const ComponentKind kind = header.transmitted ? ComponentKind::FrontTransmission : ComponentKind::FrontReflection;
  Components components;
  const std::size_t firstTis = header.xyz ? header.incidences() : 0;  // luminance
  if (turns) {
    for (std::size_t r = 0; r < header.rotation.size(); ++r) {
      std::string text;
      for (std::size_t i = 0; i < header.incidence.size(); ++i)
        text += (i ? " " : "") + formatNumber(tis[firstTis + r * header.incidence.size() + i]);
      report.metadata["TIS at rotation " + formatNumber(header.rotation[r])] = text;
    }
  } else {
    TotalScatter total{kind, {}, {}};
    for (std::size_t i = 0; i < header.incidence.size(); ++i) {
      total.thetaI.push_back(radians(header.incidence[i]));
      total.values.push_back(tis[firstTis + i]);
    }
    components.totals.push_back(std::move(total));
  }
  const BrdfPointer brdf = finishPart(std::move(data), conventions, path, report);
  return assemble({{kind, brdf}}, std::move(components), conventions.sides, std::move(report));
}

// ----- writing -------------------------------------------------------------------------------------------------------

bool fitting(const GridLayout& layout) {
  return layout.parametrisation == Parametrisation::Specular && layout.specularOffsets.empty() &&
         hasOnly(layout, {Q::ThetaI, Q::PhiI, Q::SpecularTheta, Q::SpecularPhi});
}

WriteReport write(const Brdf* front, const Components& components, const std::filesystem::path& path) {
  WriteReport report;
  // One part a file: the front reflection, else the front transmission.
  const BrdfPointer transmitted = components.find(ComponentKind::FrontTransmission);
  const Brdf* brdf = front ? front : transmitted.get();
  if (!brdf)
    throw Error(Error::Kind::Value, {"the material has no part that the format takes",
                                     path.string(),
                                     {},
                                     "front reflection or front transmission"});
  const ComponentKind kind = front ? ComponentKind::FrontReflection : ComponentKind::FrontTransmission;
  reportUnkept(components, {kind}, false, true, "zemax", report);

  const auto grid = gridFor(*brdf, fitting, specularFallback(*brdf, true), report);
  const GridLayout& layout = grid->layout();
  const FileAxis rotation(layout, Q::PhiI), incidence(layout, Q::ThetaI), azimuth(layout, Q::SpecularPhi),
      radial(layout, Q::SpecularTheta);
  std::string text = "# " + brdf->description() + "\nSource Measured\nSymmetry ";
  text += layout.symmetry.mirror ? "PlaneSymmetrical" : rotation.stride ? "ASymmetrical4D" : "ASymmetrical";
  text += std::string("\nSpectralContent ") +
          (grid->channels().kind != Channels::Kind::Monochrome ? "XYZ" : "Monochrome") + "\nScatterType " +
          (front ? "BRDF" : "BTDF") + "\n";
  const auto list = [&](const char* key, const FileAxis& axis) {
    text += std::string(key) + " " + std::to_string(axis.size()) + "\n" + axis.text() + "\n";
  };
  list("SampleRotation", rotation);
  list("AngleOfIncidence", incidence);
  list("ScatterAzimuth", azimuth);
  list("ScatterRadial", radial);

  const bool xyz = grid->channels().kind != Channels::Kind::Monochrome;
  // As written: the channels are X, Y and Z.
  GridData data = grid->data();
  data.values = xyzOf(grid->data());
  data.channels = xyz ? Channels::rgb() : Channels::monochrome();
  data.standardError.clear();
  const GridBrdf written(std::move(data), brdf->description());
  const std::vector<double>& values = written.data().values;
  std::vector<double> polar = radial.nodes;
  if (polar.size() == 1) polar = {0, kPi};
  std::vector<std::vector<double>> tis;
  for (const double phi : rotation.nodes)
    for (const double theta : incidence.nodes)
      tis.push_back(directionalReflectance(written, fromSpherical(theta, phi), fromSpherical(theta, phi + kPi), polar));
  const std::size_t cells = layout.cells();
  for (std::size_t c = 0; c < (xyz ? 3u : 1u); ++c) {
    text += "\n" + kChannels[xyz ? c + 1 : 0] + "\nDataBegin\n";
    for (std::size_t r = 0; r < rotation.size(); ++r)
      for (std::size_t i = 0; i < incidence.size(); ++i) {
        text += "TIS " + formatNumber(tis[r * incidence.size() + i][c]) + "\n";
        for (std::size_t a = 0; a < azimuth.size(); ++a)
          for (std::size_t t = 0; t < radial.size(); ++t)
            text += formatNumber(values[c * cells + r * rotation.stride + i * incidence.stride + a * azimuth.stride +
                                        t * radial.stride]) +
                    (t + 1 < radial.size() ? " " : "\n");
      }
    text += "DataEnd\n";
  }
  writeBytes(path, text);
  return report;
}

}  // namespace

Format zemaxFormat() {
  Format format{"zemax", "Zemax tabular BSDF text", ".bsdf", recognise, read, nullptr, gridOptions()};
  format.write = [](const Brdf& brdf, const auto& path) { return write(&brdf, {}, path); };
  format.writeMaterial = write;
  format.coloursOnly = true;
  return format;
}

}  // namespace brdf
