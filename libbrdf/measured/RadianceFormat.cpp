// Radiance / WINDOW6 XML of scattering distributions, f_r in 1/sr without the cosine: root WindowElement, in it
// Optical, Layer with Material, DataDefinition and WavelengthData. IncidentDataStructure "Columns" or "Rows" is a
// matrix over the patches of angle bases (material/PatchBasis.h), "TensorTree3" or "TensorTree4" a tensor tree
// (material/TreeBrdf.h). (Sources: Radiance's bsdf_m.c, bsdf_t.c; the angle bases of J. H. Klems 1994, ASHRAE
// Transactions 100(1).)
// - Columns: each column is one incident patch; number k is (outgoing = k / nIn, incident = k % nIn). Rows: (incident =
//   k / nOut, outgoing = k % nOut). ColumnAngleBasis is the incident one either way, as in Radiance.
// - Incident directions are those of travel: the light's x and y negated.
// - Front and back change places between WINDOW and Radiance: "Reflection Back" is Radiance's front reflection. On the
//   back x and y remain those of the front; our components turn the sheet over about x, so that azimuths are negated.
// - Colour: a matrix for Visible (Y), CIE-X and CIE-Z; a tree for Visible (Y), CIE-u and CIE-v (u', v' of CIE 1976).
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/TreeBrdf.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/RadianceData.h>
#include <brdf/measured/RadianceXml.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

using radiance::Counts;
using radiance::sameText;
using radiance::Source;

constexpr double kEnergySlack = 1e-3;  ///< above 1: what rounded numbers may come to

int recognise(std::string_view head, std::uint64_t) {
  head = withoutByteOrderMark(head);
  // The first tag that is no declaration, comment or document type.
  while (true) {
    const std::size_t tag = head.find('<');
    if (tag == std::string_view::npos || !trimmed(head.substr(0, tag)).empty()) return 0;
    head.remove_prefix(tag);
    const bool comment = head.starts_with("<!--");
    if (!comment && !head.starts_with("<?") && !head.starts_with("<!")) break;
    const std::size_t end = head.find(comment ? "-->" : ">");
    if (end == std::string_view::npos) return 0;
    head.remove_prefix(end + (comment ? 3 : 1));
  }
  constexpr std::string_view root = "<WindowElement";
  return head.starts_with(root) && head.substr(root.size()).find_first_of(" \t\r\n/>") == 0 ? 95 : 0;
}

/// One reading of a file.
class Reader {
 public:
  Reader(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options)
      : source_{bytes, path}, options_(options) {}

  ReadResult run() {
    const pugi::xml_node layer = openLayer();
    readMaterial(layer.child("Material"));
    const pugi::xml_node definition = layer.child("DataDefinition");
    const pugi::xml_node structure = definition.child("IncidentDataStructure");
    structure_ = std::string(trimmed(structure.text().get()));
    rank_ = sameText(structure_, "TensorTree3") ? 3 : sameText(structure_, "TensorTree4") ? 4 : 0;
    if (rank_ == 0 && !sameText(structure_, "Columns") && !sameText(structure_, "Rows"))
      source_.fail(structure ? structure : layer, "wrong IncidentDataStructure", "'" + structure_.substr(0, 40) + "'",
                   "Columns, Rows, TensorTree3, TensorTree4");
    result_.report.metadata["structure"] = structure_;
    bases_ = radiance::readBases(source_, definition);
    state();
    collect(layer);
    readComponents(layer);
    return std::move(result_);
  }

 private:
  using Blocks = std::array<pugi::xml_node, 3>;  ///< Visible, and the two that make it colour

  pugi::xml_node openLayer() {
    const pugi::xml_parse_result parsed = document_.load_buffer(source_.bytes.data(), source_.bytes.size());
    if (!parsed)
      throw Error(Error::Kind::Format,
                  {"not well-formed XML",
                   source_.path.string() + ", line " + std::to_string(source_.lineAt(parsed.offset)),
                   parsed.description(),
                   {}});
    const pugi::xml_node root = document_.document_element();
    if (std::string_view(root.name()) != "WindowElement")
      source_.fail(root, "wrong root element", "<" + std::string(root.name()).substr(0, 40) + ">", "<WindowElement>");
    const pugi::xml_node layer = root.child("Optical").child("Layer");
    if (!layer) source_.fail(root, "no Optical with a Layer");
    if (layer.next_sibling("Layer"))
      result_.report.warnings.push_back("the file has several layers: only the first is read");
    return layer;
  }

  void readMaterial(const pugi::xml_node& material) {
    for (const char* name : {"Name", "Manufacturer", "Thickness", "Width", "Height"}) {
      const pugi::xml_node node = material.child(name);
      std::string text(trimmed(node.text().get()).substr(0, 200));
      if (text.empty()) continue;
      if (node.attribute("unit")) text += std::string(" ") + node.attribute("unit").value();
      result_.report.metadata[name] = text;
    }
  }

  void state() {
    auto& assumptions = result_.report.assumptions;
    swapped_ = choose(options_, Sides::Swapped,
                      "Radiance's reading of WINDOW's names: 'Reflection Back' is the front reflection",
                      result_.report) == Sides::Swapped;
    assumptions.push_back("values are f_r in 1/sr without the cosine");
    assumptions.push_back(rank_ == 0 ? "ColumnAngleBasis is the incident one, " + structure_ +
                                           " hold one incident direction each (as Radiance reads them)"
                                     : "the first coordinates are the incident ones (as Radiance reads them)");
    assumptions.push_back("incident directions are those of travel: the light's azimuth plus 180 degrees");
    assumptions.push_back(rank_ == 0 ? "between directions: constant on each pair of patches, as Radiance"
                                     : "between directions: constant on each cell of the tree, as Radiance");
    if (rank_ == 3) assumptions.push_back("the surface may be turned about its normal (rank 3)");
  }

  /// Sorts the blocks by direction and by what they hold.
  void collect(const pugi::xml_node& layer) {
    const std::array<const char*, 3> names =
        rank_ == 0 ? std::array{"Visible", "CIE-X", "CIE-Z"} : std::array{"Visible", "CIE-u", "CIE-v"};
    std::vector<std::string> skipped;
    for (const pugi::xml_node wavelength : layer.children("WavelengthData")) {
      const std::string_view name = trimmed(wavelength.child("Wavelength").text().get());
      const auto which = std::find_if(names.begin(), names.end(), [&](const char* n) { return sameText(n, name); });
      if (which == names.end()) {
        std::string shown(name.substr(0, 40));
        if (std::find(skipped.begin(), skipped.end(), shown) == skipped.end() && skipped.size() < 20)
          skipped.push_back(std::move(shown));
        continue;
      }
      for (const pugi::xml_node block : wavelength.children("WavelengthDataBlock")) {
        ComponentKind kind;
        if (!kindOf(block, kind)) continue;
        pugi::xml_node& slot = blocks_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(which - names.begin())];
        if (slot)
          result_.report.warnings.push_back("two blocks for " + std::string(name) + " of the " +
                                            std::string(componentName(kind)) + ": the last is read");
        slot = block;
      }
    }
    if (!skipped.empty()) result_.report.metadata["wavelengths not read"] = joined(skipped);
  }

  /// Which component a block holds, as the options name the sides; false for one of an unknown direction.
  bool kindOf(const pugi::xml_node& block, ComponentKind& kind) {
    const std::string_view direction = trimmed(block.child("WavelengthDataDirection").text().get());
    const bool transmission = sameText(direction, "Transmission Front") || sameText(direction, "Transmission Back");
    const bool back = sameText(direction, "Reflection Back") || sameText(direction, "Transmission Back");
    if (!transmission && !back && !sameText(direction, "Reflection Front")) {
      result_.report.warnings.push_back("a block of the unknown direction '" + std::string(direction.substr(0, 40)) +
                                        "' is not read");
      return false;
    }
    const bool front = back == swapped_;
    kind = transmission ? (front ? ComponentKind::FrontTransmission : ComponentKind::BackTransmission)
                        : (front ? ComponentKind::FrontReflection : ComponentKind::BackReflection);
    const std::string_view type = trimmed(block.child("ScatteringDataType").text().get());
    if (!type.empty() && !sameText(type, transmission ? "BTDF" : "BRDF"))
      result_.report.warnings.push_back(std::string(direction) + " has the ScatteringDataType " +
                                        std::string(type.substr(0, 40)));
    return true;
  }

  void readComponents(const pugi::xml_node& layer) {
    for (const ComponentKind kind : {ComponentKind::FrontReflection, ComponentKind::BackReflection,
                                     ComponentKind::FrontTransmission, ComponentKind::BackTransmission}) {
      Blocks blocks = blocks_[static_cast<std::size_t>(kind)];
      if (!blocks[0]) {
        if (blocks[1] || blocks[2])
          result_.report.warnings.push_back("the " + std::string(componentName(kind)) +
                                            " has colour but no Visible data: not read");
        continue;
      }
      if (!blocks[1] != !blocks[2])
        result_.report.warnings.push_back("the " + std::string(componentName(kind)) +
                                          " has one of two colour channels: read without colour");
      const bool coloured = blocks[1] && blocks[2];
      if (coloured && !colourStated_) stateColour();
      BrdfPointer brdf = rank_ == 0 ? readMatrices(blocks, kind, coloured) : readTrees(blocks, kind, coloured);
      if (kind == ComponentKind::FrontReflection)
        result_.brdf = std::move(brdf);
      else
        result_.components.scatter.push_back({kind, std::move(brdf)});
    }
    result_.components.front = result_.brdf != nullptr;
    if (!result_.brdf && !result_.components.scatter.empty()) {
      result_.brdf = result_.components.scatter[0].brdf;
      result_.report.warnings.push_back("the file has no front reflection: this is the " +
                                        std::string(componentName(result_.components.scatter[0].kind)));
    }
    if (!result_.brdf) source_.fail(layer, "no Visible data of a known direction");
    result_.report.negative = counts_.negative;
    result_.report.notFinite = counts_.notFinite;
    if (counts_.negative + counts_.notFinite > 0)
      result_.report.warnings.push_back(std::to_string(counts_.negative) + " negative and " +
                                        std::to_string(counts_.notFinite) + " not finite values are taken as 0");
  }

  void stateColour() {
    colourStated_ = true;
    if (options_.colour && *options_.colour != ColourSpace::Xyz)
      throw Error(Error::Kind::Value, {"this colour has no meaning for tristimulus values", source_.path.string(),
                                       "another assumption than xyz", "colour=xyz, or none"});
    const bool equalEnergy = !options_.colour;
    result_.report.assumptions.push_back(
        equalEnergy ? "colour: a grey has X = Y = Z, as Radiance writes them; scaled to D65 and linear sRGB"
                    : "colour: xyz (given; Radiance's own has X = Y = Z for a grey): relative to D65, to linear sRGB");
    rgb_ = equalEnergy ? radiance::rgbFromTristimulus : [](double x, double y, double z) {
      static const Matrix3 matrix = xyzToLinearSrgb();
      std::array<double, 3> rgb;
      for (std::size_t r = 0; r < 3; ++r) rgb[r] = matrix[r][0] * x + matrix[r][1] * y + matrix[r][2] * z;
      return rgb;
    };
  }

  std::string description(ComponentKind kind) const {
    const std::string file = source_.path.filename().string();
    return kind == ComponentKind::FrontReflection ? file : file + ", " + std::string(componentName(kind));
  }
  /// Radiance's back side, which our turning over mirrors.
  bool mirrored(ComponentKind kind) const {
    const bool back = kind == ComponentKind::BackReflection || kind == ComponentKind::BackTransmission;
    return back == swapped_;
  }

  // ----- matrices --------------------------------------------------------------------------------------------------

  PatchBasis basisOf(const pugi::xml_node& block, const char* element) {
    const pugi::xml_node node = block.child(element);
    const std::string_view name = trimmed(node.text().get());
    for (const PatchBasis& basis : bases_)
      if (sameText(basis.name(), name)) return basis;
    for (const PatchBasis* basis : {&PatchBasis::klemsFull(), &PatchBasis::klemsHalf(), &PatchBasis::klemsQuarter()}) {
      if (!sameText(basis->name(), name)) continue;
      const std::string assumption = "the file does not define " + basis->name() + ": " +
                                     std::to_string(basis->count()) + " patches, as Radiance has it";
      auto& all = result_.report.assumptions;
      if (std::find(all.begin(), all.end(), assumption) == all.end()) all.push_back(assumption);
      return *basis;
    }
    std::vector<std::string> known{"LBNL/Klems Full", "LBNL/Klems Half", "LBNL/Klems Quarter"};
    for (const PatchBasis& basis : bases_) known.push_back(basis.name());
    source_.fail(node ? node : block, std::string("unknown ") + element, "'" + std::string(name.substr(0, 40)) + "'",
                 joined(known));
  }

  BrdfPointer readMatrices(const Blocks& blocks, ComponentKind kind, bool coloured) {
    PatchData data{basisOf(blocks[0], "ColumnAngleBasis"),
                   basisOf(blocks[0], "RowAngleBasis"),
                   coloured ? Channels::rgb() : Channels::monochrome(),
                   {}};
    const std::size_t lights = data.incident.count(), viewers = data.outgoing.count(), cells = lights * viewers;
    std::array<std::vector<double>, 3> planes;
    for (std::size_t plane = 0; plane < (coloured ? 3u : 1u); ++plane) {
      const pugi::xml_node& block = blocks[plane];
      if (plane > 0 &&
          !(basisOf(block, "ColumnAngleBasis") == data.incident && basisOf(block, "RowAngleBasis") == data.outgoing))
        source_.fail(block, "the angle bases of the colour channels differ");
      planes[plane] = radiance::readNumbers(source_, dataOf(block), cells, counts_);
    }
    const bool rows = sameText(structure_, "Rows"), mirror = mirrored(kind);
    data.values.resize(data.channels.count() * cells);
    for (std::size_t k = 0; k < cells; ++k) {
      std::size_t o = rows ? k % viewers : k / lights, i = rows ? k / viewers : k % lights;
      if (mirror) {
        o = data.outgoing.mirrored(o);
        i = data.incident.mirrored(i);
      }
      const std::size_t cell = o * lights + i;
      data.values[cell] = planes[0][k];
      if (!coloured) continue;
      const auto rgb = rgb_(planes[1][k], planes[0][k], planes[2][k]);
      for (std::size_t c = 0; c < 3; ++c) data.values[c * cells + cell] = rgb[c];
    }
    if (result_.report.samples == 0)
      result_.report.metadata["patches"] = std::to_string(lights) + " incident (" + data.incident.name() + ") x " +
                                           std::to_string(viewers) + " outgoing (" + data.outgoing.name() + ")";
    result_.report.samples += cells;
    auto brdf = std::make_shared<const PatchBrdf>(std::move(data), description(kind));
    const std::vector<double> albedos = brdf->directionalAlbedos();
    double most = 0;
    for (std::size_t i = 0; i < lights; ++i)
      most =
          std::max(most, coloured ? luminance(albedos[i], albedos[lights + i], albedos[2 * lights + i]) : albedos[i]);
    checkEnergy(most, kind);
    return brdf;
  }

  // ----- trees -----------------------------------------------------------------------------------------------------

  BrdfPointer readTrees(const Blocks& blocks, ComponentKind kind, bool coloured) {
    std::vector<TensorTree> trees;
    for (std::size_t plane = 0; plane < (coloured ? 3u : 1u); ++plane) {
      const pugi::xml_node basis = blocks[plane].child("AngleBasis");
      if (!sameText(basis.text().get(), "LBNL/Shirley-Chiu"))
        source_.fail(basis ? basis : blocks[plane], "wrong AngleBasis of a tensor tree",
                     "'" + std::string(trimmed(basis.text().get()).substr(0, 40)) + "'", "LBNL/Shirley-Chiu");
      trees.push_back(radiance::readTree(source_, dataOf(blocks[plane]), rank_, counts_));
    }
    TensorTree tree = coloured ? TensorTree::merged(trees) : std::move(trees[0]);
    if (coloured)
      for (std::size_t cell = 0; cell < tree.cells(); ++cell) colourCell(tree.values(cell));
    // Azimuths are negated where the square's second coordinate, or the outgoing one of rank 3, is reversed.
    if (mirrored(kind)) tree = tree.reversed(rank_ == 3 ? 4u : 10u);
    result_.report.samples += tree.cells();
    auto brdf = std::make_shared<const TreeBrdf>(std::move(tree), coloured ? Channels::rgb() : Channels::monochrome(),
                                                 description(kind));
    static constexpr std::array<double, 1> one{1};
    checkEnergy(brdf->largestAlbedo(coloured ? std::span<const double>(kRgbLuminanceWeights) : one), kind);
    return brdf;
  }

  /// Y, u', v' as linear sRGB; a cell without a chromaticity is grey.
  void colourCell(double* values) const {
    const double y = values[0], u = values[1], v = values[2];
    const double x = v > 0 ? y * 9 * u / (4 * v) : y, z = v > 0 ? y * (12 - 3 * u - 20 * v) / (4 * v) : y;
    const auto rgb = rgb_(x, y, z);
    std::copy(rgb.begin(), rgb.end(), values);
  }

  pugi::xml_node dataOf(const pugi::xml_node& block) const {
    const pugi::xml_node data = block.child("ScatteringData");
    if (!data || trimmed(data.text().get()).empty()) source_.fail(data ? data : block, "no ScatteringData");
    return data;
  }

  void checkEnergy(double most, ComponentKind kind) {
    result_.report.metadata["largest albedo, " + std::string(componentName(kind))] = formatNumber(most, 4);
    if (most > 1 + kEnergySlack)
      result_.report.warnings.push_back("energy: the " + std::string(componentName(kind)) + " returns up to " +
                                        formatNumber(most, 4) + " of the light from one direction");
  }

  Source source_;
  const ReadOptions& options_;
  pugi::xml_document document_;
  ReadResult result_;
  std::string structure_;
  int rank_ = 0;  ///< of trees; 0 for matrices
  bool swapped_ = true, colourStated_ = false;
  std::vector<PatchBasis> bases_;
  std::array<Blocks, 4> blocks_;  ///< by ComponentKind
  Counts counts_;
  std::array<double, 3> (*rgb_)(double x, double y, double z) = nullptr;
};

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  return Reader(bytes, path, options).run();
}

Format format(const char* name, const char* title, const RadianceWriteOptions& options) {
  Format result{name, title, ".xml", recognise, read, nullptr, {"sides", "colour"}};
  result.write = [options](const Brdf& brdf, const std::filesystem::path& path) {
    return writeRadiance(&brdf, {}, path, options);
  };
  result.writeMaterial = [options](const Brdf* front, const Components& components, const std::filesystem::path& path) {
    return writeRadiance(front, components, path, options);
  };
  result.coloursOnly = true;
  return result;
}

[[noreturn]] void failSetting(const std::string& key, const std::string& value, std::string allowed) {
  throw Error(Error::Kind::Usage,
              {"wrong setting of the format", "format, " + key, "'" + value + "'", std::move(allowed)});
}

double numberSetting(const std::string& key, const std::string& value, double low, double high) {
  const auto number = parseNumber(value);
  if (!number || !(*number >= low && *number <= high))
    failSetting(key, value, formatNumber(low) + " to " + formatNumber(high));
  return *number;
}

/// The same for writing alone: "radiance" reads them all.
Format writeOnly(Format format) {
  format.recognise = [](std::string_view, std::uint64_t) { return 0; };
  format.read = nullptr;
  format.takes.clear();
  return format;
}

Format klemsWith(const std::map<std::string, std::string>& values) {
  RadianceWriteOptions options{.structure = RadianceWriteOptions::Structure::Matrix};
  for (const auto& [key, value] : values) {
    if (key == "tolerance")
      options.patches.tolerance = numberSetting(key, value, 1e-6, 1);
    else if (value == "half")
      options.basis = PatchBasis::klemsHalf();
    else if (value == "quarter")
      options.basis = PatchBasis::klemsQuarter();
    else if (value != "full")
      failSetting(key, value, "full, half, quarter");
  }
  Format result = writeOnly(
      format("radiance_klems", "Radiance / WINDOW6 XML, written as Klems matrix, full unless told otherwise", options));
  result.settings = {{"basis", "full, half, quarter", "patches of a hemisphere: 145, 77 or 41 [full]"},
                     {"tolerance", "1e-6 to 1", "share of the reflected energy that quadrature may miss [0.001]"}};
  result.configured = klemsWith;
  return result;
}

Format treeWith(const std::map<std::string, std::string>& values) {
  RadianceWriteOptions options{.structure = RadianceWriteOptions::Structure::Tree};
  for (const auto& [key, value] : values) {
    if (key == "tolerance") {
      options.tree.tolerance = numberSetting(key, value, 0, 1);
      continue;
    }
    const double depth = numberSetting(key, value, 1, 8);
    if (depth != std::floor(depth)) failSetting(key, value, "a whole number, 1 to 8");
    options.tree.levels = static_cast<int>(depth);
  }
  Format result = writeOnly(format("radiance_tree", "Radiance / WINDOW6 XML, written as tensor tree", options));
  result.settings = {
      {"depth", "1 to 8", "the finest cell is 2^-depth wide [6 isotropic; 5 else, and at most 6]"},
      {"tolerance", "0 to 1", "share of their mean by which cells that are joined may differ from it [0.01]"}};
  result.configured = treeWith;
  return result;
}

}  // namespace

Format radianceFormat() {
  return format("radiance", "Radiance / WINDOW6 XML; written as Klems full matrix, or as the tree or matrix that it is",
                {});
}
Format radianceKlemsFormat() { return klemsWith({}); }
Format radianceTreeFormat() { return treeWith({}); }

}  // namespace brdf
