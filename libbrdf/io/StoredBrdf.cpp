#include <brdf/io/StoredBrdf.h>
#include <brdf/io/StoredGrid.h>
#include <brdf/io/StoredPatches.h>
#include <brdf/io/StoredValues.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>

#include <algorithm>
#include <array>

namespace brdf {
namespace {

using stored::broken;
using stored::restoreChannels;
using stored::restoreChoice;
using stored::restoreValues;
using stored::Sizes;
using stored::storeChannels;
using stored::storeValues;
using stored::valueName;

// ----- sums of lobes -----------------------------------------------------------------------------------------------

void storeLobes(const h5::Group& group, const LobeSum& material) {
  storeChannels(group, material.channels());
  const h5::Group lobes = group.createGroup("Lobes");
  for (std::size_t i = 0; i < material.lobes().size(); ++i) {
    const Lobe& lobe = material.lobes()[i];
    const h5::Group part = lobes.createGroup(std::to_string(i));
    part.setText("Model", lobe.model->name());
    part.setText("Equation", lobe.model->equation());  // for people; reading goes by the name
    part.setNumbers("Scale", lobe.scale);
    const h5::Group parameters = part.createGroup("Parameters");
    for (std::size_t p = 0; p < lobe.parameters.size(); ++p)
      parameters.setNumbers(lobe.model->parameters()[p].name, lobe.parameters[p]);
  }
}

BrdfPointer restoreLobes(const h5::Group& group) {
  const h5::Group stored = group.group("Lobes");
  std::vector<Lobe> lobes;
  for (std::size_t i = 0; stored.hasObject(std::to_string(i)); ++i) {
    const h5::Group part = stored.group(std::to_string(i));
    const h5::Group parameters = part.group("Parameters");
    Lobe lobe;
    lobe.model = findModel(part.text("Model"));
    lobe.scale = part.numbers("Scale");
    for (const Parameter& parameter : lobe.model->parameters())
      lobe.parameters.push_back(parameters.numbers(parameter.name));
    for (const std::string& name : parameters.attributeNames()) lobe.model->parameterIndex(name);  // throws: unknown
    lobes.push_back(std::move(lobe));
  }
  return std::make_shared<const LobeSum>(std::move(lobes), restoreChannels(group));
}

// ----- tables ------------------------------------------------------------------------------------------------------

const std::array<std::string, 3> kTableAxes = {"phi_d", "theta_d", "sqrt(theta_h / 90 deg)"};
constexpr std::array<std::string_view, 2> kLookups = {"interpolated", "nearest"};
constexpr std::array<std::string_view, 2> kPositions = {"centre", "node"};

/// The table as a VTKHDF image, a point a cell at the place where its value belongs: x = phi_d, y = theta_d (degrees),
/// z = sqrt(theta_h / 90 degrees). Not as cells: VTK 9.1 asks for one more of them along each axis than there are.
void storeTable(const h5::Group& group, const TableBrdf& table) {
  const TableData& data = table.data();
  const TableLayout& layout = data.layout;
  const std::array<std::size_t, 3> sizes = {layout.phiD, layout.thetaD, layout.thetaH};
  const std::array<double, 3> spans = {layout.reciprocal ? 180.0 : 360.0, 90, 1};
  std::array<std::int64_t, 6> extent{};
  std::array<double, 3> origin{}, spacing{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extent[2 * axis + 1] = static_cast<std::int64_t>(sizes[axis]) - 1;
    spacing[axis] = spans[axis] / static_cast<double>(sizes[axis]);
    origin[axis] = table.position() == TableBrdf::Position::Centre ? spacing[axis] / 2 : 0;
  }
  group.setIntegers("Version", std::array<std::int64_t, 2>{1, 0});
  group.setText("Type", "ImageData");
  group.setIntegers("WholeExtent", extent);
  group.setNumbers("Origin", origin);
  group.setNumbers("Spacing", spacing);
  group.setNumbers("Direction", std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  group.setTexts("Axes", kTableAxes);
  group.setTexts("AxisUnits", std::array<std::string, 3>{"deg", "deg", "1"});
  group.setText("Quantity", "BRDF without the cosine, 1/sr");
  group.setInteger("Reciprocal", layout.reciprocal);
  group.setText("Lookup", kLookups[static_cast<std::size_t>(table.lookup())]);
  group.setText("Position", kPositions[static_cast<std::size_t>(table.position())]);
  storeChannels(group, data.channels);
  storeValues(group.createGroup("PointData"), data.values.data(), data.valid.data(), data.channels.count(),
              {layout.thetaH, layout.thetaD, layout.phiD});
}

BrdfPointer restoreTable(const h5::Group& group, const std::string& description) {
  const std::vector<std::string> axes = group.texts("Axes");
  if (!std::equal(axes.begin(), axes.end(), kTableAxes.begin(), kTableAxes.end()))
    broken(group, "unknown axes", joined(axes), joined(kTableAxes));
  const h5::Group cells = group.group("PointData");
  const Sizes shape = cells.dimensions("valid");
  if (shape.size() != 3) broken(cells, "table of the wrong shape", std::to_string(shape.size()) + " axes", "3 axes");
  TableData data;
  data.layout = {shape[2], shape[1], shape[0], group.integer("Reciprocal") != 0};
  data.channels = restoreChannels(group);
  restoreValues(cells, data.channels.count(), shape, data.values, data.valid);
  return std::make_shared<const TableBrdf>(std::move(data), description,
                                           restoreChoice<TableBrdf::Lookup>(group, "Lookup", kLookups),
                                           restoreChoice<TableBrdf::Position>(group, "Position", kPositions));
}

// ----- scattered samples -------------------------------------------------------------------------------------------

void storeSamples(const h5::Group& group, const Brdf& brdf) {
  const SampleSet& samples = *brdf.samples();
  const std::size_t count = samples.count(), channels = samples.channels().count();
  storeChannels(group, samples.channels());
  group.setInteger("Isotropic", brdf.symmetry() == Symmetry::Isotropic);
  DirectionPairBuffer<double> pairs;
  std::vector<double> values(count * channels);
  std::vector<std::uint8_t> valid(count);
  samples.read(0, count, &pairs, values.data(), valid.data());
  const auto storeDirections = [&](const char* name, const std::array<std::vector<double>, 3>& directions) {
    std::vector<double> interleaved(count * 3);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) interleaved[3 * i + axis] = directions[axis][i];
    group.writeArray(name, interleaved.data(), Sizes{count, 3});
  };
  storeDirections("wi", pairs.wi);
  storeDirections("wo", pairs.wo);
  for (std::size_t c = 0; c < channels; ++c) group.writeArray(valueName(c), values.data() + c * count, Sizes{count});
  group.writeArray("valid", valid.data(), Sizes{count});
  const auto* scattered = dynamic_cast<const ScatteredBrdf*>(&brdf);
  if (!scattered || scattered->data().uncertainty.empty()) return;
  for (std::size_t c = 0; c < channels; ++c)
    group.writeArray(stored::errorName(c), scattered->data().uncertainty.data() + c * count, Sizes{count});
}

BrdfPointer restoreSamples(const h5::Group& group, const std::string& description) {
  ScatteredSamples samples;
  samples.channels = restoreChannels(group);
  samples.isotropic = group.integer("Isotropic") != 0;
  const std::uint64_t count = group.dimensions("wi")[0];
  const auto restoreDirections = [&](const char* name, std::array<std::vector<double>, 3>& directions) {
    std::vector<double> interleaved(count * 3);
    group.readArray(name, interleaved.data(), Sizes{count, 3});
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) directions[axis][i] = interleaved[3 * i + axis];
  };
  if (group.dimensions("wi") != Sizes{count, 3}) broken(group, "wi is not a list of directions", {}, "count x 3");
  samples.pairs.resize(count);
  restoreDirections("wi", samples.pairs.wi);
  restoreDirections("wo", samples.pairs.wo);
  restoreValues(group, samples.channels.count(), {count}, samples.values, samples.valid);
  if (group.hasObject(stored::errorName(0)))
    samples.uncertainty = stored::restoreChannelArrays(group, stored::errorName, samples.channels.count(), {count});
  return std::make_shared<const ScatteredBrdf>(std::move(samples), description);
}

}  // namespace

std::string storeBrdf(const h5::Group& group, const Brdf& brdf) {
  if (const auto* material = dynamic_cast<const LobeSum*>(&brdf)) {
    storeLobes(group, *material);
    return "analytic";
  }
  if (const auto* table = dynamic_cast<const TableBrdf*>(&brdf)) {
    storeTable(group, *table);
    return "table";
  }
  if (const auto* grid = dynamic_cast<const GridBrdf*>(&brdf)) {
    storeGrid(group, *grid);
    return "grid";
  }
  if (const auto* patches = dynamic_cast<const PatchBrdf*>(&brdf)) {
    storePatches(group, *patches);
    return "patches";
  }
  if (const auto* tree = dynamic_cast<const TreeBrdf*>(&brdf)) {
    storeTree(group, *tree);
    return "tree";
  }
  if (brdf.samples()) {
    storeSamples(group, brdf);
    return "scattered";
  }
  throw Error(Error::Kind::Value,
              {"a container cannot keep this kind of BRDF", group.where(), brdf.description(),
               "sums of lobes, tables, grids, patches, trees, and data with samples: tabulate it first"});
}

BrdfPointer restoreBrdf(const h5::Group& group, const std::string& kind, const std::string& description) {
  if (kind == "analytic") return restoreLobes(group);
  if (kind == "table") return restoreTable(group, description);
  if (kind == "grid") return restoreGrid(group, description);
  if (kind == "patches") return restorePatches(group, description);
  if (kind == "tree") return restoreTree(group, description);
  if (kind == "scattered") return restoreSamples(group, description);
  broken(group, "unknown kind of entry", kind, "analytic, table, grid, patches, tree, scattered");
}

}  // namespace brdf
