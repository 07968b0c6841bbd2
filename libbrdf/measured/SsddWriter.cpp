// Writing SSDD (SsddFormat.cpp): text, every digit that a double needs.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/measured/GridWriting.h>
#include <brdf/measured/ScatteredText.h>
#include <brdf/measured/SsddWriter.h>

#include <algorithm>
#include <array>

namespace brdf {
namespace {

using Q = AxisQuantity;

/// PARAM0 to PARAM3 of a parametrisation.
std::array<Q, 4> parametersOf(const GridLayout& layout) {
  switch (layout.parametrisation) {
    case Parametrisation::HalfDifference:
      return {Q::ThetaH, Q::PhiH, Q::ThetaD, Q::PhiD};
    case Parametrisation::Specular:
      return {Q::ThetaI, Q::PhiI, Q::SpecularTheta, Q::SpecularPhi};
    default:
      return {Q::ThetaI, Q::PhiI, Q::ThetaO, layout.find(Q::PhiI) < layout.axes.size() ? Q::PhiO : Q::PhiDifference};
  }
}

bool fitting(const GridLayout& layout) {
  const std::array<Q, 4> known = parametersOf(layout);
  for (const GridAxis& axis : layout.axes)
    if (std::find(known.begin(), known.end(), axis.quantity) == known.end() || axis.nodes.front() < 0 ||
        axis.nodes.back() > 2 * kPi + 1e-9)
      return false;
  const bool turns = layout.find(known[1]) < layout.axes.size();
  if (!seamsShow(layout) || (layout.symmetry.mirror && turns)) return false;
  return !layout.symmetry.reciprocal || layout.parametrisation == Parametrisation::HalfDifference;
}

GridLayout fallback(const Brdf& brdf) {
  if (const auto* table = dynamic_cast<const TableBrdf*>(&brdf)) {
    GridLayout layout = GridLayout::fromTable(table->data().layout);
    for (GridAxis& axis : layout.axes) {
      axis.edges.clear();
      axis.scale = AxisScale::Linear;
    }
    return layout;
  }
  const auto upTo = [](double last, double step) {
    std::vector<double> values;
    for (int i = 0; i * step <= last; ++i) values.push_back(i * step);
    return values;
  };
  std::vector<double> half;
  for (int i = 0; i <= 45; ++i) half.push_back(90.0 * i * i / (45 * 45));  // fine near the mirror direction
  GridLayout layout{Parametrisation::HalfDifference, {GridAxis::listedDegrees(Q::ThetaH, half)}};
  layout.symmetry = {brdf.symmetry() == Symmetry::Isotropic, brdf.reciprocal()};
  if (brdf.symmetry() == Symmetry::Anisotropic)
    layout.axes.push_back(GridAxis::listedDegrees(Q::PhiH, upTo(360, 15)).periodic());
  layout.axes.push_back(GridAxis::listedDegrees(Q::ThetaD, upTo(90, 5)));
  const double turn = layout.symmetry.reciprocal ? 180 : 360;
  const bool mirror = layout.symmetry.mirror;
  layout.axes.push_back(GridAxis::listedDegrees(Q::PhiD, upTo(mirror ? turn / 2 : turn, 5)));
  if (!mirror) layout.axes.back().period = radians(turn);
  return layout;
}

std::string colourText(const Channels& channels) {
  if (channels.kind == Channels::Kind::Monochrome) return "COLOR_MODEL monochrome\n";
  if (channels.kind == Channels::Kind::Rgb) return "COLOR_MODEL rgb\n";
  std::string text = "COLOR_MODEL spectrum\nWAVELENGTH_LIST";
  for (const double wavelength : channels.wavelengths) text += " " + formatNumber(wavelength);
  return text + "\n";
}

std::string scatterText(const char* type, const Brdf& brdf, WriteReport& report) {
  const auto grid = gridFor(brdf, fitting, fallback(brdf), report);
  const GridLayout& layout = grid->layout();
  const std::array<Q, 4> known = parametersOf(layout);
  constexpr std::array<const char*, 3> types{"spherical", "half_difference", "specular"};
  std::string text = std::string("\nDATA_TYPE ") + type + "\n" + colourText(grid->channels()) + "PARAM_TYPE " +
                     types[static_cast<std::size_t>(layout.parametrisation)] + "_coordinate_system\n";
  if (layout.symmetry.mirror || layout.symmetry.reciprocal)
    text += std::string("REDUCTION_TYPE") + (layout.symmetry.mirror ? " bilateral_symmetry" : "") +
            (layout.symmetry.reciprocal ? " reciprocity" : "") + "\n";
  std::vector<FileAxis> axes;
  for (std::size_t p = 0; p < 4; ++p) {
    axes.emplace_back(layout, known[p]);
    if (p != 1 || axes[p].stride != 0) text += "PARAM" + std::to_string(p) + "_LIST " + axes[p].text() + "\n";
  }
  if (!layout.specularOffsets.empty()) {
    text += "PARAM4_LIST";
    for (const double offset : layout.specularOffsets) text += " " + degreesText(offset);
    text += "\n";
  }
  text += "NAME " + brdf.description() + "\nDATA ascii\n";
  const std::size_t cells = layout.cells();
  for (std::size_t i3 = 0; i3 < axes[3].size(); ++i3)
    for (std::size_t i2 = 0; i2 < axes[2].size(); ++i2)
      for (std::size_t i1 = 0; i1 < axes[1].size(); ++i1)
        for (std::size_t i0 = 0; i0 < axes[0].size(); ++i0) {
          const std::size_t cell =
              i0 * axes[0].stride + i1 * axes[1].stride + i2 * axes[2].stride + i3 * axes[3].stride;
          for (std::size_t c = 0; c < grid->channels().count(); ++c)
            text += (c ? " " : "") + formatNumber(grid->data().values[c * cells + cell]);
          text += "\n";
        }
  return text;
}

std::string specularText(const char* type, const SpecularComponent& specular) {
  std::string text = std::string("\nDATA_TYPE ") + type + "\n" + colourText(specular.channels) + "PARAM0_LIST";
  for (const double angle : specular.thetaI) text += " " + degreesText(angle);
  text += "\nDATA ascii\n";
  const std::size_t count = specular.thetaI.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < specular.channels.count(); ++c)
      text += (c ? " " : "") + formatNumber(specular.values[c * count + i]);
    text += "\n";
  }
  return text;
}

}  // namespace

WriteReport writeSsdd(const Brdf* front, const Components& components, const std::filesystem::path& path) {
  WriteReport report;
  std::string text = "VERSION 0.3\nSOFTWARE BRDFLab\n";
  if (front) text += scatterText("brdf", *front, report);
  if (const BrdfPointer transmitted = components.find(ComponentKind::FrontTransmission))
    text += scatterText("btdf", *transmitted, report);
  Components unkept = components;
  unkept.specular.clear();
  std::array<bool, 2> have{};
  for (const SpecularComponent& specular : components.specular) {
    const bool transmitted = specular.kind == ComponentKind::FrontTransmission;
    if ((!transmitted && specular.kind != ComponentKind::FrontReflection) || have[transmitted]) {
      unkept.specular.push_back(specular);
      continue;
    }
    have[transmitted] = true;
    text += specularText(transmitted ? "specular_transmittance" : "specular_reflectance", specular);
  }
  if (text.find("DATA_TYPE") == std::string::npos)
    throw Error(Error::Kind::Value, {"the material has no part that the format takes",
                                     path.string(),
                                     {},
                                     "reflection, transmission or specular fractions of the front"});
  reportUnkept(unkept, {ComponentKind::FrontTransmission}, false, false, "ssdd", report);
  writeBytes(path, text);
  return report;
}

}  // namespace brdf
