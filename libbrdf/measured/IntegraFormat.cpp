// Integra's text of scattering (.ddr reflected, .ddt transmitted) and of specular fractions (.sdr, .sdt), as far as
// other readers accept it; the official description is not public. Tokens, ';' starts a comment. Angles in degrees:
// psi and sigma are the azimuth and polar angle of the light, theta the angle from the specular direction, phi the
// azimuth about it (Parametrisation::Specular), sigmaT the polar angle of that direction where it is not sigma. Values
// of each channel: psi, sigma, phi, theta from slowest to fastest, "kbdf" a factor for each sigma and psi.
// Nothing in a file says whether it is of reflected or transmitted light; only its name does.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridFile.h>
#include <brdf/measured/GridReading.h>
#include <brdf/measured/IntegraWriter.h>
#include <brdf/measured/TokenReader.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdf {
namespace {

using Q = AxisQuantity;

struct Header {
  enum Symmetry { Axi, Dir, Plane, Asymmetric, Unsaid } symmetry = Unsaid;
  bool intensity = false, relative = false, unitSaid = false;
  std::string colour;  // "rgb", "bw", "spectral"; empty: unsaid
  std::size_t channels = 0;
  std::vector<double> psi, sigma, phi, theta, offsets;
};

bool startsChannel(std::string_view word) {
  for (const char* name : {"wl", "bw", "red", "gre", "green", "blu", "blue"})
    if (sameWord(word, name)) return true;
  return false;
}

/// sigmaT: one polar angle for each sigma, with or without their number before them.
std::vector<double> readOffsets(TokenReader& tokens, const std::vector<double>& sigma) {
  std::vector<double> numbers;
  while (tokens.numberNext() && numbers.size() < sigma.size() + 2) numbers.push_back(tokens.number("sigmaT"));
  if (numbers.size() == sigma.size() + 1 && numbers.front() == static_cast<double>(sigma.size()))
    numbers.erase(numbers.begin());
  if (sigma.empty() || numbers.size() != sigma.size())
    tokens.fail("sigmaT does not match sigma", std::to_string(numbers.size()) + " angles",
                std::to_string(sigma.size()) + ", after sigma");
  for (std::size_t i = 0; i < sigma.size(); ++i) {
    if (!(numbers[i] >= 0 && numbers[i] <= 180))
      tokens.fail("out of range: sigmaT", formatNumber(numbers[i]), "0 to 180");
    numbers[i] = radians(numbers[i]) - radians(sigma[i]);
  }
  return numbers;
}

Header readHeader(TokenReader& tokens, ReadReport& report) {
  Header header;
  while (tokens.more() && !startsChannel(tokens.peek())) {
    const std::string key(tokens.next("a key"));
    if (sameWord(key, "Source")) {
      report.metadata["source"] = tokens.next("Source");
    } else if (sameWord(key, "TypeSym")) {
      header.symmetry = static_cast<Header::Symmetry>(
          tokens.oneOf("TypeSym", {"AxiSymmetrical", "DirSymmetrical", "PlaneSymmetrical", "ASymmetrical"}));
      tokens.accept("4D");
    } else if (sameWord(key, "TypeColorModel")) {
      const std::size_t model = tokens.oneOf("TypeColorModel", {"rgb", "bw", "spectral"});
      header.colour = std::vector<std::string>{"rgb", "bw", "spectral"}[model];
      header.channels = model == 0 ? 3 : model == 1 ? 1 : tokens.count("number of wavelengths");
    } else if (sameWord(key, "TypeData")) {
      header.intensity = tokens.oneOf("TypeData", {"Luminance", "Intensity"}) == 1;
      if (tokens.accept("Relative"))
        header.relative = true;
      else
        tokens.accept("Absolute");
      header.unitSaid = true;
    } else if (sameWord(key, "psi")) {
      tokens.list(header.psi, "psi", -360, 360);
    } else if (sameWord(key, "sigma")) {
      tokens.list(header.sigma, "sigma", 0, 90);
    } else if (sameWord(key, "sigmaT")) {
      header.offsets = readOffsets(tokens, header.sigma);
    } else if (sameWord(key, "phi")) {
      tokens.list(header.phi, "phi", -360, 360);
    } else if (sameWord(key, "theta")) {
      tokens.list(header.theta, "theta", 0, 180);
    } else if (report.warnings.size() < 20) {
      report.warnings.push_back("\"" + key.substr(0, 40) + "\" is ignored: its meaning is not known");
    }
  }
  if (header.sigma.empty()) tokens.fail("a key is missing before the values", {}, "sigma");
  if (header.colour.empty()) tokens.fail("a key is missing before the values", {}, "TypeColorModel");
  return header;
}

/// The channels of a file, planar, in the file's order of values; those of a spectrum by ascending wavelength.
struct Planes {
  Channels channels;
  std::vector<double> values;  // `size` a channel
  std::vector<double> kbdf;    // `factors` a channel; empty: none
};

Planes readPlanes(TokenReader& tokens, const Header& header, std::size_t size, std::size_t factors) {
  tokens.room({size, header.channels}, "the values");
  std::vector<std::vector<double>> planes(header.channels), kbdf(header.channels);
  std::vector<double> wavelengths;
  for (std::size_t n = 0; n < header.channels; ++n) {
    std::size_t channel = n;
    if (header.colour == "rgb") {
      channel =
          std::vector<std::size_t>{0, 1, 1, 2, 2}[tokens.oneOf("channel", {"red", "gre", "green", "blu", "blue"})];
    } else if (header.colour == "bw") {
      tokens.oneOf("channel", {"bw"});
    } else {
      tokens.oneOf("channel", {"wl"});
      wavelengths.push_back(tokens.number("a wavelength", 10, 1e6));
    }
    if (!planes[channel].empty()) tokens.fail("a channel stands twice", std::to_string(channel), "once");
    if (tokens.accept("kbdf"))
      for (std::size_t i = 0; i < factors; ++i) kbdf[channel].push_back(tokens.number("kbdf", 0, 1e30));
    tokens.accept("def");
    planes[channel].reserve(size);
    for (std::size_t i = 0; i < size; ++i) planes[channel].push_back(tokens.number("a value"));
    tokens.accept("enddef");
  }
  if (tokens.more())
    tokens.fail("something stands after the last channel", std::string(tokens.peek().substr(0, 40)), {});

  Planes result{header.colour == "rgb" ? Channels::rgb() : Channels::monochrome(), {}, {}};
  std::vector<std::size_t> order(header.channels);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (header.colour == "spectral") {
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return wavelengths[a] < wavelengths[b]; });
    std::sort(wavelengths.begin(), wavelengths.end());
    if (std::adjacent_find(wavelengths.begin(), wavelengths.end()) != wavelengths.end())
      tokens.fail("a wavelength stands twice", {}, "each once");
    result.channels = Channels::spectral(wavelengths);
  }
  const bool factored = std::any_of(kbdf.begin(), kbdf.end(), [](const auto& list) { return !list.empty(); });
  for (const std::size_t channel : order) {
    result.values.insert(result.values.end(), planes[channel].begin(), planes[channel].end());
    if (!factored) continue;
    if (kbdf[channel].empty()) kbdf[channel].assign(factors, 1);
    result.kbdf.insert(result.kbdf.end(), kbdf[channel].begin(), kbdf[channel].end());
  }
  return result;
}

/// Scales each incidence of each channel so that its directional reflectance (or transmittance) is kbdf.
void scaleToReflectance(GridData& data, const Header& header, const std::vector<double>& kbdf, Quantity quantity,
                        const std::filesystem::path& path, ReadReport& report) {
  ReadReport unused;
  const auto shape = finishPart(data, {.quantity = quantity}, path, unused);
  const std::size_t rows = kbdf.size() / data.channels.count(), row = data.values.size() / kbdf.size();
  std::vector<double> polar;
  for (const double angle : header.theta) polar.push_back(radians(angle));
  if (polar.size() == 1) polar = {0, kPi};
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t s = i % header.sigma.size(), p = i / header.sigma.size();
    const double psi = header.psi.empty() ? 0 : radians(header.psi[p]), sigma = radians(header.sigma[s]);
    const Direction pole = fromSpherical(sigma + (header.offsets.empty() ? 0 : header.offsets[s]), psi + kPi);
    const std::vector<double> reflectance = directionalReflectance(*shape, fromSpherical(sigma, psi), pole, polar);
    for (std::size_t c = 0; c < reflectance.size(); ++c) {
      const double target = kbdf[c * rows + i];
      if (!(reflectance[c] > 0)) {
        if (target > 0)
          report.warnings.push_back("sigma " + formatNumber(header.sigma[s]) + ": no light to scale to kbdf");
        continue;
      }
      for (std::size_t k = 0; k < row; ++k) data.values[(c * rows + i) * row + k] *= target / reflectance[c];
    }
  }
}

ComponentKind kindOf(const std::filesystem::path& path, ReadReport& report) {
  const bool transmitted = integraNamesTransmission(path);
  report.assumptions.push_back(std::string("component: ") + (transmitted ? "front transmission" : "front reflection") +
                               " (the file's name; nothing in the content tells)");
  return transmitted ? ComponentKind::FrontTransmission : ComponentKind::FrontReflection;
}

ReadResult readSpecular(TokenReader& tokens, const Header& header, const std::filesystem::path& path,
                        const ReadOptions& options, ReadReport report) {
  const auto colour = header.colour == "rgb" ? std::optional(ColourSpace::LinearSrgb) : std::nullopt;
  const ComponentKind kind = kindOf(path, report);
  if (options.quantity || options.invalid || options.symmetry)
    throw Error(Error::Kind::Value, {"the file holds specular fractions only", path.string(),
                                     "option " + options.keys().front(), "colour, sides"});
  Planes planes = readPlanes(tokens, header, header.sigma.size(), header.sigma.size());
  SpecularComponent specular{kind, planes.channels, {}, std::move(planes.values)};
  for (const double angle : header.sigma) specular.thetaI.push_back(radians(angle));
  if (!planes.kbdf.empty()) tokens.fail("kbdf among specular fractions", "kbdf", "none: its meaning is not known");
  const GridConventions conventions =
      chooseConventions(options, Quantity::Brdf, "not used: the file holds specular fractions", colour,
                        "the format names red, green and blue, not their primaries", report);
  if (colour) toLinearSrgb(specular.values, conventions.colour);
  Components components;
  components.specular.push_back(std::move(specular));
  return assemble({}, std::move(components), conventions.sides, std::move(report));
}

int recognise(std::string_view head, std::uint64_t) {
  return hasWord(head, ';', "TypeColorModel") && hasWord(head, ';', "sigma") ? 90 : 0;
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  TokenReader tokens(bytes, path, ';');
  ReadReport report;
  Header header = readHeader(tokens, report);
  if (header.phi.empty() && header.theta.empty()) return readSpecular(tokens, header, path, options, std::move(report));
  if (header.phi.empty() || header.theta.empty())
    tokens.fail("a key is missing before the values", {}, header.phi.empty() ? "phi" : "theta");
  if (header.symmetry == Header::Unsaid) tokens.fail("a key is missing before the values", {}, "TypeSym");
  const bool turns = header.psi.size() > 1;
  const bool plane = chooseMirror(options, header.symmetry == Header::Plane, turns, path, report);
  if (header.symmetry == Header::Axi && turns)
    tokens.fail("AxiSymmetrical with several psi", std::to_string(header.psi.size()), "1");
  if (header.symmetry == Header::Dir && header.phi.size() > 1 && !fullTurn(header.phi))
    tokens.fail("DirSymmetrical: how it completes the azimuths phi is not established",
                formatNumber(header.phi.front()) + " to " + formatNumber(header.phi.back()), "phi all around");
  if (plane && !(header.phi.front() >= 0 && header.phi.back() <= 180))
    tokens.fail("mirrored in the plane of incidence, with phi on both sides",
                formatNumber(header.phi.front()) + " to " + formatNumber(header.phi.back()), "0 to 180");
  const std::size_t incidences = boundedProduct({header.sigma.size(), std::max<std::size_t>(1, header.psi.size())});
  const std::size_t cells = tokens.room({header.theta.size(), header.phi.size(), incidences}, "the values");
  Planes planes = readPlanes(tokens, header, cells, incidences);

  const ComponentKind kind = kindOf(path, report);
  GridData data{{Parametrisation::Specular,
                 {polarAxis(Q::SpecularTheta, header.theta), azimuthAxis(Q::SpecularPhi, header.phi, plane, report),
                  polarAxis(Q::ThetaI, header.sigma)},
                 {.mirror = plane && !turns},
                 header.offsets},
                planes.channels,
                std::move(planes.values),
                {}};
  if (turns) data.layout.axes.push_back(azimuthAxis(Q::PhiI, header.psi, false, report));
  const GridConventions conventions = chooseConventions(
      options, header.intensity ? Quantity::BrdfCosine : Quantity::ReflectanceFactor,
      std::string(header.unitSaid ? "" : "TypeData is missing: taken for Luminance; ") +
          (header.intensity ? "Intensity: f_r cos(theta_o) with kbdf" : "Luminance: pi f_r with kbdf"),
      planes.channels.kind == Channels::Kind::Rgb ? std::optional(ColourSpace::LinearSrgb) : std::nullopt,
      "the format names red, green and blue, not their primaries", report);
  if (plane && turns) mirrorAzimuth(data, Q::SpecularPhi);
  if (header.relative && planes.kbdf.empty())
    tokens.fail("Relative values without kbdf", {}, "kbdf: nothing else gives their scale");
  if (header.relative) {
    data.layout.check(path.string());
    scaleToReflectance(data, header, planes.kbdf, conventions.quantity, path, report);
    report.assumptions.push_back(
        "scale: each incidence scaled so that its directional reflectance over the listed angles is kbdf (Relative)");
  } else if (!planes.kbdf.empty()) {
    const std::size_t row = data.values.size() / planes.kbdf.size();
    for (std::size_t i = 0; i < data.values.size(); ++i) data.values[i] *= planes.kbdf[i / row];
  }
  report.assumptions.push_back(
      "azimuth phi: 0 from the specular direction towards the normal, right-handed about it (as other readers do; the "
      "format's description is not public)");
  const BrdfPointer brdf = finishPart(std::move(data), conventions, path, report);
  return assemble({{kind, brdf}}, {}, conventions.sides, std::move(report));
}

}  // namespace

Format integraFormat() {
  Format format{
      "integra",    "Integra scattering text (.ddr, .ddt; reads .sdr, .sdt)", ".ddr", recognise, read, nullptr,
      gridOptions()};
  format.write = [](const Brdf& brdf, const auto& path) { return writeIntegra(&brdf, {}, path); };
  format.writeMaterial = writeIntegra;
  return format;
}

Format integraSpecularFormat() {
  Format format{"integra-specular",
                "Integra specular fractions (.sdr, .sdt), for writing; integra reads them",
                ".sdr",
                [](std::string_view, std::uint64_t) { return 0; },
                read,
                nullptr,
                gridOptions()};
  format.write = [](const Brdf& brdf, const auto& path) { return writeIntegraSpecular(&brdf, {}, path); };
  format.writeMaterial = writeIntegraSpecular;
  return format;
}

}  // namespace brdf
