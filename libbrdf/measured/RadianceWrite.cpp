#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/material/ChannelView.h>
#include <brdf/measured/GridWriting.h>
#include <brdf/measured/RadianceData.h>
#include <brdf/measured/RadianceXml.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <array>

namespace brdf {
namespace {

using Structure = RadianceWriteOptions::Structure;

constexpr int kAverageDigits = 7;                           ///< of means, whose quadrature is not as good
constexpr int kChromaticityDigits = 10;                     ///< of u' and v': equal colours become equal numbers
constexpr std::array<double, 2> kGrey{4.0 / 19, 9.0 / 19};  ///< u', v' of X = Y = Z

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result;
}

std::string element(const char* name, std::string_view content) {
  return "<" + std::string(name) + ">" + std::string(content) + "</" + name + ">\n";
}

/// A component made ready: one of the two.
struct Part {
  ComponentKind kind;
  std::shared_ptr<const PatchBrdf> patches;
  std::shared_ptr<const TreeBrdf> tree;
  bool exact = false;
  const Brdf& brdf() const { return patches ? static_cast<const Brdf&>(*patches) : *tree; }
};

bool isBack(ComponentKind kind) {
  return kind == ComponentKind::BackReflection || kind == ComponentKind::BackTransmission;
}
bool isTransmission(ComponentKind kind) {
  return kind == ComponentKind::FrontTransmission || kind == ComponentKind::BackTransmission;
}

std::string percent(double share) { return formatNumber(100 * share, 2) + " %"; }

class Writer {
 public:
  Writer(const RadianceWriteOptions& options, WriteReport& report) : options_(options), report_(report) {}

  std::string run(const Brdf* front, const Components& components) {
    std::vector<std::pair<ComponentKind, const Brdf*>> all;
    if (front) all.emplace_back(ComponentKind::FrontReflection, front);
    for (const ScatterComponent& component : components.scatter) all.emplace_back(component.kind, component.brdf.get());
    if (all.empty())
      throw Error(Error::Kind::Value, {"nothing to write", "Radiance XML", "no distribution", "at least one"});
    structure_ = options_.structure;
    if (structure_ == Structure::Keep)
      structure_ = dynamic_cast<const TreeBrdf*>(all[0].second) ? Structure::Tree : Structure::Matrix;
    rank_ = structure_ == Structure::Matrix ? 0 : std::all_of(all.begin(), all.end(), turns) ? 3 : 4;
    for (const auto& [kind, brdf] : all) add(kind, *brdf);
    reportUnkept(components,
                 {ComponentKind::FrontReflection, ComponentKind::BackReflection, ComponentKind::FrontTransmission,
                  ComponentKind::BackTransmission},
                 false, false, "Radiance XML", report_);
    if (negative_ > 0) report_.losses.push_back(std::to_string(negative_) + " negative values will be read as 0");
    return document(all[0].second->description());
  }

 private:
  /// Whether rank 3 holds a component.
  static bool turns(const std::pair<ComponentKind, const Brdf*>& part) {
    const auto* tree = dynamic_cast<const TreeBrdf*>(part.second);
    return tree ? tree->tree().rank() == 3 : part.second->symmetry() == Symmetry::Isotropic;
  }

  void add(ComponentKind kind, const Brdf& brdf) {
    Part part{kind, nullptr, nullptr};
    const BrdfPointer borrowed(BrdfPointer{}, &brdf);
    const std::string name(componentName(kind));
    if (brdf.channels().kind == Channels::Kind::Spectral)
      report_.losses.push_back("spectrum of the " + name + ": reduced to linear sRGB under D65");
    const BrdfPointer seen = brdf.channels().kind == Channels::Kind::Spectral ? asRgb(borrowed) : borrowed;
    AverageReport average;
    if (structure_ == Structure::Matrix) {
      part.patches = std::dynamic_pointer_cast<const PatchBrdf>(seen);
      part.exact =
          part.patches && (options_.structure == Structure::Keep || (part.patches->data().incident == options_.basis &&
                                                                     part.patches->data().outgoing == options_.basis));
      if (!part.exact)
        part.patches = averageOverPatches(*seen, options_.basis, options_.basis, options_.patches, average);
    } else {
      part.tree = std::dynamic_pointer_cast<const TreeBrdf>(seen);
      part.exact = part.tree && part.tree->tree().rank() == rank_;
      if (!part.exact) part.tree = averageOverTree(*seen, rank_, options_.tree, average);
    }
    if (!part.exact) stateAverage(part, name, average);
    checkEnergy(part, name);
    parts_.push_back(std::move(part));
  }

  void stateAverage(const Part& part, const std::string& name, const AverageReport& average) {
    std::string text = name + ": ";
    if (part.patches)
      text += "means over " + std::to_string(part.patches->data().incident.count()) + " x " +
              std::to_string(part.patches->data().outgoing.count()) + " patches of directions";
    else
      text += "means over the cells of a tensor tree of rank " + std::to_string(rank_) + ", " +
              std::to_string(part.tree->tree().cells()) + " of " + std::to_string(average.pairs) +
              " cells left, values within " + percent(options_.tree.tolerance);
    report_.losses.push_back(text + "; estimated error of the means at most " + percent(average.error) +
                             " of the light reflected from one direction");
    if (average.invalid > 0)
      report_.losses.push_back(name + ": " + std::to_string(average.invalid) + " means without a valid value are 0");
  }

  void checkEnergy(const Part& part, const std::string& name) {
    const bool coloured = part.brdf().channels().count() == 3;
    double most = 0;
    if (part.tree) {
      static constexpr std::array<double, 1> one{1};
      most = part.tree->largestAlbedo(coloured ? std::span<const double>(kRgbLuminanceWeights) : one);
    } else {
      const std::vector<double> albedos = part.patches->directionalAlbedos();
      const std::size_t lights = part.patches->data().incident.count();
      for (std::size_t i = 0; i < lights; ++i)
        most =
            std::max(most, coloured ? luminance(albedos[i], albedos[lights + i], albedos[2 * lights + i]) : albedos[i]);
    }
    if (most > 1)
      report_.losses.push_back(name + ": returns up to " + formatNumber(most, 4) +
                               " of the light from one direction; Radiance expects at most 1");
  }

  // ----- text ------------------------------------------------------------------------------------------------------

  std::string document(const std::string& description) {
    std::string blocks;
    for (const Part& part : parts_) blocks += part.patches ? matrixBlocks(part) : treeBlocks(part);
    const char* structure = rank_ == 0 ? "Columns" : rank_ == 3 ? "TensorTree3" : "TensorTree4";
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<WindowElement xmlns=\"http://windows.lbl.gov\">\n"
           "<WindowElementType>System</WindowElementType>\n<Optical>\n<Layer>\n"
           "<!-- Values: f_r in 1/sr. \"Back\" is the front of the surface, as Radiance reads it. -->\n<Material>\n" +
           element("Name", escaped(description)) + element("Manufacturer", "") + "</Material>\n<DataDefinition>\n" +
           element("IncidentDataStructure", structure) + baseDefinitions() + "</DataDefinition>\n" + blocks +
           "</Layer>\n</Optical>\n</WindowElement>\n";
  }

  std::string block(ComponentKind kind, const char* wavelength, const std::string& basis, const std::string& data) {
    // Front and back change places, see RadianceFormat.cpp.
    const std::string direction =
        std::string(isTransmission(kind) ? "Transmission" : "Reflection") + (isBack(kind) ? " Front" : " Back");
    return "<WavelengthData>\n" + element("LayerNumber", "System") + "<Wavelength unit=\"Integral\">" + wavelength +
           "</Wavelength>\n<WavelengthDataBlock>\n" + element("WavelengthDataDirection", direction) + basis +
           element("ScatteringDataType", isTransmission(kind) ? "BTDF" : "BRDF") + "<ScatteringData>\n" + data +
           "</ScatteringData>\n</WavelengthDataBlock>\n</WavelengthData>\n";
  }

  /// The name under which the file defines a basis.
  std::string nameOf(const PatchBasis& basis) {
    for (const auto& [name, known] : bases_)
      if (known == basis) return name;
    std::string name = basis.name();
    const auto taken = [&](const auto& entry) { return radiance::sameText(entry.first, name); };
    for (int number = 2; std::any_of(bases_.begin(), bases_.end(), taken); ++number)
      name = basis.name() + " " + std::to_string(number);
    bases_.emplace_back(name, basis);
    return name;
  }

  std::string baseDefinitions() const {
    std::string text;
    for (const auto& [name, basis] : bases_) {
      text += "<AngleBasis>\n" + element("AngleBasisName", escaped(name));
      std::size_t patch = 0;
      for (std::size_t r = 0; r < basis.rings().size(); ++r) {
        const auto angle = [](double theta) { return formatNumber(degrees(theta), 12); };
        text += "<AngleBasisBlock>" + ("<Theta>" + angle(toSpherical(basis.centre(patch)).theta)) + "</Theta><nPhis>" +
                std::to_string(basis.rings()[r].count) + "</nPhis><ThetaBounds><LowerTheta>" +
                angle(basis.lowerTheta(r)) + "</LowerTheta><UpperTheta>" + angle(basis.rings()[r].upperTheta) +
                "</UpperTheta></ThetaBounds></AngleBasisBlock>\n";
        patch += basis.rings()[r].count;
      }
      text += "</AngleBasis>\n";
    }
    return text;
  }

  std::string matrixBlocks(const Part& part) {
    const PatchData& data = part.patches->data();
    const std::string basis = element("ColumnAngleBasis", escaped(nameOf(data.incident))) +
                              element("RowAngleBasis", escaped(nameOf(data.outgoing)));
    const std::size_t lights = data.incident.count(), viewers = data.outgoing.count(), cells = lights * viewers;
    const bool coloured = data.channels.count() == 3;
    std::array<std::string, 3> text;
    for (std::size_t k = 0; k < cells; ++k) {
      std::size_t o = k / lights, i = k % lights;
      if (isBack(part.kind)) {
        o = data.outgoing.mirrored(o);
        i = data.incident.mirrored(i);
      }
      const double* value = data.values.data() + o * lights + i;
      std::array<double, 3> xyz{0, value[0], 0};
      if (coloured) xyz = radiance::tristimulusFromRgb(value[0], value[cells], value[2 * cells]);
      for (std::size_t plane = 0; plane < (coloured ? 3u : 1u); ++plane) {
        const double number = xyz[coloured ? plane : 1];
        negative_ += number < 0;
        text[plane] += part.exact ? formatNumber(number) : formatNumber(number, kAverageDigits);
        text[plane] += k % lights + 1 == lights ? '\n' : ' ';
      }
    }
    if (!coloured) return block(part.kind, "Visible", basis, text[0]);
    return block(part.kind, "CIE-X", basis, text[0]) + block(part.kind, "Visible", basis, text[1]) +
           block(part.kind, "CIE-Z", basis, text[2]);
  }

  std::string treeBlocks(const Part& part) {
    const std::string basis = element("AngleBasis", "LBNL/Shirley-Chiu");
    TensorTree tree = part.tree->tree();
    if (isBack(part.kind)) tree = tree.reversed(rank_ == 3 ? 4u : 10u);
    const int digits = part.exact ? 0 : kAverageDigits;
    const bool coloured = tree.channels() == 3;
    for (std::size_t cell = 0; cell < tree.cells(); ++cell) {
      double* values = tree.values(cell);
      if (coloured) {
        const auto [x, y, z] = radiance::tristimulusFromRgb(values[0], values[1], values[2]);
        const double sum = x + 15 * y + 3 * z;
        values[0] = y;
        values[1] = y > 0 && sum > 0 ? 4 * x / sum : kGrey[0];
        values[2] = y > 0 && sum > 0 ? 9 * y / sum : kGrey[1];
        negative_ += values[1] < 0;
      }
      negative_ += values[0] < 0;
    }
    const std::string visible = block(part.kind, "Visible", basis, radiance::treeText(tree, 0, digits));
    if (!coloured) return visible;
    return visible + block(part.kind, "CIE-u", basis, radiance::treeText(tree, 1, kChromaticityDigits)) +
           block(part.kind, "CIE-v", basis, radiance::treeText(tree, 2, kChromaticityDigits));
  }

  const RadianceWriteOptions& options_;
  WriteReport& report_;
  Structure structure_ = Structure::Matrix;
  int rank_ = 0;  ///< of trees; 0 for matrices
  std::vector<Part> parts_;
  std::vector<std::pair<std::string, PatchBasis>> bases_;
  std::size_t negative_ = 0;
};

}  // namespace

WriteReport writeRadiance(const Brdf* front, const Components& components, const std::filesystem::path& path,
                          const RadianceWriteOptions& options) {
  WriteReport report;
  writeBytes(path, Writer(options, report).run(front, components));
  return report;
}

}  // namespace brdf
