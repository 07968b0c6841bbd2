// Writing what IntegraFormat.cpp reads.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/GridWriting.h>
#include <brdf/measured/IntegraWriter.h>
#include <brdf/measured/ScatteredText.h>
#include <brdf/measured/TokenReader.h>

#include <array>

namespace brdf {
namespace {

using Q = AxisQuantity;

bool fitting(const GridLayout& layout) {
  return layout.parametrisation == Parametrisation::Specular &&
         hasOnly(layout, {Q::ThetaI, Q::PhiI, Q::SpecularTheta, Q::SpecularPhi});
}

std::string colourModel(const Channels& channels) {
  switch (channels.kind) {
    case Channels::Kind::Rgb:
      return "RGB";
    case Channels::Kind::Spectral:
      return "spectral " + std::to_string(channels.count());
    default:
      return "BW";
  }
}

std::string channelName(const Channels& channels, std::size_t channel) {
  constexpr std::array<const char*, 3> names{"red", "gre", "blu"};
  if (channels.kind == Channels::Kind::Rgb) return names[channel];
  if (channels.kind == Channels::Kind::Monochrome) return "bw";
  return "wl " + formatNumber(channels.wavelengths[channel]);
}

}  // namespace

bool integraNamesTransmission(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return sameWord(extension, ".ddt") || sameWord(extension, ".sdt");
}

WriteReport writeIntegra(const Brdf* front, const Components& components, const std::filesystem::path& path) {
  WriteReport report;
  const ComponentKind kind =
      integraNamesTransmission(path) ? ComponentKind::FrontTransmission : ComponentKind::FrontReflection;
  const BrdfPointer transmitted = components.find(ComponentKind::FrontTransmission);
  const Brdf* brdf = kind == ComponentKind::FrontReflection ? front : transmitted.get();
  if (!brdf)
    throw Error(Error::Kind::Value, {"the material has no such part", path.string(), std::string(componentName(kind)),
                                     ".ddr reflection, .ddt transmission"});
  if (kind == ComponentKind::FrontTransmission && front)
    report.losses.push_back("front reflection: a .ddt file has no place for it");
  reportUnkept(components, {kind}, false, false, "integra", report);

  const auto grid = gridFor(*brdf, fitting, specularFallback(*brdf, true), report);
  const GridLayout& layout = grid->layout();
  const FileAxis psi(layout, Q::PhiI), sigma(layout, Q::ThetaI), phi(layout, Q::SpecularPhi),
      theta(layout, Q::SpecularTheta);
  const bool turns = psi.stride != 0;
  std::string text = "; " + brdf->description() + "\nSource Generated\nTypeSym ";
  text += layout.symmetry.mirror ? "PlaneSymmetrical" : turns ? "ASymmetrical 4D" : "ASymmetrical";
  text += "\nTypeColorModel " + colourModel(grid->channels()) + "\nTypeData Luminance Absolute\n";
  const auto list = [&](const char* key, const FileAxis& axis) {
    text += key + (" " + std::to_string(axis.size())) + "\n " + axis.text() + "\n";
  };
  if (turns) list("psi", psi);
  list("sigma", sigma);
  if (!layout.specularOffsets.empty()) {
    text += "sigmaT\n";
    for (std::size_t i = 0; i < sigma.size(); ++i)
      text += " " + degreesText(sigma.nodes[i] + layout.specularOffsets[i]);
    text += "\n";
  }
  list("phi", phi);
  list("theta", theta);
  const std::size_t cells = layout.cells();
  for (std::size_t c = 0; c < grid->channels().count(); ++c) {
    text += channelName(grid->channels(), c) + "\n kbdf\n";
    for (std::size_t i = 0; i < psi.size() * sigma.size(); ++i) text += " 1";
    text += "\n def\n";
    for (std::size_t p = 0; p < psi.size(); ++p)
      for (std::size_t s = 0; s < sigma.size(); ++s)
        for (std::size_t a = 0; a < phi.size(); ++a) {
          for (std::size_t t = 0; t < theta.size(); ++t)
            text += " " + formatNumber(kPi * grid->data().values[c * cells + p * psi.stride + s * sigma.stride +
                                                                 a * phi.stride + t * theta.stride]);
          text += "\n";
        }
    text += " enddef\n";
  }
  writeBytes(path, text);
  return report;
}

WriteReport writeIntegraSpecular(const Brdf* front, const Components& components, const std::filesystem::path& path) {
  WriteReport report;
  const ComponentKind kind =
      integraNamesTransmission(path) ? ComponentKind::FrontTransmission : ComponentKind::FrontReflection;
  const SpecularComponent* specular = nullptr;
  for (const SpecularComponent& part : components.specular)
    if (part.kind == kind)
      specular = &part;
    else
      report.losses.push_back("specular " + std::string(componentName(part.kind)) + ": a file holds one component");
  if (!specular)
    throw Error(Error::Kind::Value,
                {"the material has no such part", path.string(), "specular " + std::string(componentName(kind)),
                 ".sdr reflection, .sdt transmission"});
  if (front) report.losses.push_back("front reflection: the format holds specular fractions only");
  reportUnkept(components, {}, true, false, "integra-specular", report);
  const std::size_t count = specular->thetaI.size();
  std::string text =
      "Source Generated\nTypeColorModel " + colourModel(specular->channels) + "\nsigma " + std::to_string(count) + "\n";
  for (const double angle : specular->thetaI) text += " " + degreesText(angle);
  text += "\n";
  for (std::size_t c = 0; c < specular->channels.count(); ++c) {
    text += channelName(specular->channels, c) + "\n def\n";
    for (std::size_t i = 0; i < count; ++i) text += " " + formatNumber(specular->values[c * count + i]);
    text += "\n enddef\n";
  }
  writeBytes(path, text);
  return report;
}

}  // namespace brdf
