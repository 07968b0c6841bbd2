// Grids, their errors and cell states, and components in containers; reading in parts; damage.
#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/Container.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/StoredGrid.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <sstream>

#include "Samples.h"

namespace fs = std::filesystem;
using brdf::AxisQuantity;
using brdf::ComponentKind;
using brdf::Container;
using brdf::GridAxis;
using brdf::GridBrdf;
using brdf::GridLayout;
using brdf::Parametrisation;
using brdf::radians;
using samples::errorOf;
using samples::freshFolder;

namespace {

/// Outgoing directions first: a slice is one incident direction.
GridLayout anisotropic() {
  return {Parametrisation::Spherical,
          {GridAxis::uniformNodes(AxisQuantity::ThetaO, 0, radians(75), 6),
           GridAxis::uniformNodes(AxisQuantity::PhiO, 0, radians(315), 8).periodic(),
           GridAxis::listedDegrees(AxisQuantity::ThetaI, {0, 10, 40, 70, 80}),
           GridAxis::uniformNodes(AxisQuantity::PhiI, 0, radians(270), 4).periodic()}};
}

std::vector<GridLayout> layouts() {
  GridLayout transmission{Parametrisation::Specular,
                          {GridAxis::listedDegrees(AxisQuantity::SpecularTheta, {0, 1, 2, 5, 90}),
                           GridAxis::uniformNodes(AxisQuantity::SpecularPhi, 0, brdf::kPi, 7),
                           GridAxis::listedDegrees(AxisQuantity::ThetaI, {0, 30, 60})},
                          {.mirror = true}};
  transmission.specularOffsets = {0, radians(-10) / 3, radians(-20) / 7};
  GridLayout clipped{Parametrisation::Spherical,
                     {GridAxis::cellsDegrees(AxisQuantity::ThetaO, {0, 30, 70}, brdf::AxisScale::Cosine)}};
  clipped.axes[0].outside = brdf::Outside::Invalid;
  return {anisotropic(), GridLayout::fromTable({9, 8, 7, true}), GridLayout::fromTable({9, 8, 7, false}), transmission,
          clipped};
}

/// A grid whose values no decimal writer and no float would bring back, with cells of every state.
std::shared_ptr<const GridBrdf> someGrid(const GridLayout& layout, brdf::Channels channels, bool errors = true,
                                         GridBrdf::Lookup lookup = GridBrdf::Lookup::Interpolated) {
  brdf::GridData data{layout, std::move(channels), {}, {}};
  const std::size_t cells = layout.cells(), count = cells * data.channels.count();
  for (std::size_t i = 0; i < cells; ++i) data.states.push_back(static_cast<std::uint8_t>(i % 7 == 3 ? 0 : 1 + i % 2));
  for (std::size_t i = 0; i < count; ++i) data.values.push_back(static_cast<double>(i + 1) / 7);
  if (errors)
    for (std::size_t i = 0; i < count; ++i) data.standardError.push_back(static_cast<double>(i + 1) / 700);
  data.original = brdf::Quantity::ReflectanceFactor;
  return std::make_shared<const GridBrdf>(std::move(data), "grid of sevenths", lookup);
}

bool sameGrid(const brdf::Brdf& a, const brdf::Brdf& b) {
  const auto& x = dynamic_cast<const GridBrdf&>(a);
  const auto& y = dynamic_cast<const GridBrdf&>(b);
  return x.layout() == y.layout() && x.channels() == y.channels() && x.data().values == y.data().values &&
         x.data().states == y.data().states && x.data().standardError == y.data().standardError &&
         x.data().original == y.data().original && x.lookup() == y.lookup() && x.description() == y.description();
}

brdf::Components someComponents() {
  brdf::Components components;
  components.scatter.push_back(
      {ComponentKind::FrontTransmission, someGrid(layouts()[3], brdf::Channels::rgb(), false)});
  components.scatter.push_back({ComponentKind::BackReflection, brdf::parseMaterialExpression("0.2*Lambertian")});
  components.specular.push_back({ComponentKind::FrontTransmission,
                                 brdf::Channels::spectral({400, 700}),
                                 {0, radians(30), radians(85)},
                                 {0.1, 0.2, 1.0 / 3, 0.4, 0.5, 0.6}});
  components.totals.push_back({ComponentKind::FrontReflection, {0, 1}, {0.3, 0.4}});
  return components;
}

}  // namespace

TEST(GridContainer, GridsComeBackBitForBit) {
  const fs::path path = freshFolder("grids") / "a.vtkhdf";
  for (const GridLayout& layout : layouts())
    for (const bool errors : {false, true})
      for (const brdf::Channels& channels : {brdf::Channels::rgb(), brdf::Channels::spectral({400, 500.5})}) {
        const auto lookup = errors ? GridBrdf::Lookup::Nearest : GridBrdf::Lookup::Interpolated;
        const auto written = someGrid(layout, channels, errors, lookup);
        brdf::writeContainer(path, "a", *written, {});
        const Container container(path);
        EXPECT_EQ(container.entries()[0].kind, "grid");
        EXPECT_TRUE(sameGrid(*container.load(0), *written)) << layout.text();
      }
}

TEST(GridContainer, TheStatesOfATablesCellsComeBack) {
  const fs::path path = freshFolder("states") / "a.vtkhdf";
  brdf::TableData data{{4, 3, 2, true}, brdf::Channels::monochrome(), std::vector<double>(24, 0.5), {}};
  for (std::size_t i = 0; i < 24; ++i) data.valid.push_back(static_cast<std::uint8_t>(i % 3));
  const auto states = data.valid;
  brdf::writeContainer(path, "a", brdf::TableBrdf(std::move(data), "states"), {});
  EXPECT_EQ(dynamic_cast<const brdf::TableBrdf&>(*Container(path).load(0)).data().valid, states);
}

TEST(GridContainer, OneChannelOfOneIncidentDirectionIsReadAlone) {
  const fs::path path = freshFolder("parts") / "a.vtkhdf";
  const auto grid = someGrid(anisotropic(), brdf::Channels::rgb());
  brdf::ContainerWriter writer(path);
  writer.add("material", *brdf::parseMaterialExpression("0.1*Lambertian"), {});
  writer.add("grid", *grid, {});
  writer.commit();
  const Container container(path);
  const brdf::StoredTable table(container, 1);
  ASSERT_EQ(table.slices(), 20u);  // 5 theta_i, 4 phi_i
  ASSERT_EQ(table.cellsPerSlice(), 48u);
  EXPECT_EQ(table.layout(), grid->layout());
  const std::size_t slice = 2 + 5 * 3, cells = 960;  // theta_i 40 degrees, phi_i 270
  const std::vector<double> values = table.values(1, slice, 1);
  const std::vector<std::uint8_t> states = table.states(slice, 1);
  ASSERT_EQ(values.size(), 48u);
  for (std::size_t i = 0; i < 48; ++i) {
    EXPECT_EQ(values[i], grid->data().values[cells + slice * 48 + i]);
    EXPECT_EQ(states[i], grid->data().states[slice * 48 + i]);
  }
  EXPECT_EQ(table.values(2, 0, 20).size(), cells);
  EXPECT_NE(errorOf([&] { table.values(0, 19, 2); }).find("no such slices"), std::string::npos);
  EXPECT_NE(errorOf([&] { table.values(0, 21, 1); }).find("no such slices"), std::string::npos);
  EXPECT_NE(errorOf([&] { table.values(3, 0, 1); }).find("no such array"), std::string::npos);
  EXPECT_NE(errorOf([&] { brdf::StoredTable(container, 0); }).find("analytic"), std::string::npos);
}

TEST(GridContainer, ABigTableIsReadInPartsWithoutReadingAllOfIt) {
  // The chunks of other slices are overwritten: whoever touched them would find wrong checksums.
  const fs::path path = freshFolder("untouched") / "a.vtkhdf";
  const auto grid = someGrid(GridLayout::fromTable({180, 90, 40, true}), brdf::Channels::monochrome(), false);
  brdf::writeContainer(path, "a", *grid, {});
  std::string bytes = brdf::readFile(path);
  const std::size_t from = bytes.size() / 2, length = bytes.size() / 8;
  std::memset(bytes.data() + from, 0x55, length);
  const Container container = Container::fromBytes(bytes, "damaged.vtkhdf");
  EXPECT_THROW(container.load(0), brdf::Error);
  const brdf::StoredTable table(container, 0);
  const std::vector<double> values = table.values(0, 0, 1);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], grid->data().values[i]);
}

TEST(GridContainer, ComponentsComeBack) {
  const fs::path path = freshFolder("components") / "a.vtkhdf";
  brdf::Components written = someComponents();
  written.front = false;
  brdf::ContainerWriter writer(path);
  writer.add("plain", *samples::scattered(), {});
  writer.add("sheet", *samples::scattered(), {}, written);
  writer.commit();
  EXPECT_TRUE(Container(path).components(0).empty());
  const brdf::Components read = brdf::loadMaterial(path.string() + "#sheet").components;
  EXPECT_FALSE(read.front);
  ASSERT_EQ(read.scatter.size(), 2u);
  EXPECT_EQ(read.scatter[0].kind, ComponentKind::FrontTransmission);
  EXPECT_TRUE(sameGrid(*read.scatter[0].brdf, *written.scatter[0].brdf));
  EXPECT_EQ(read.scatter[1].kind, ComponentKind::BackReflection);
  EXPECT_EQ(read.scatter[1].brdf->description(), "0.2*Lambertian");
  ASSERT_EQ(read.specular.size(), 1u);
  EXPECT_EQ(read.specular[0].kind, ComponentKind::FrontTransmission);
  EXPECT_EQ(read.specular[0].channels, written.specular[0].channels);
  EXPECT_EQ(read.specular[0].thetaI, written.specular[0].thetaI);
  EXPECT_EQ(read.specular[0].values, written.specular[0].values);
  ASSERT_EQ(read.totals.size(), 1u);
  EXPECT_EQ(read.totals[0].values, written.totals[0].values);
}

TEST(GridContainer, FlippedBitsAreErrorsOrHarmless) {
  const fs::path path = freshFolder("gridbits") / "a.vtkhdf";
  const auto written = someGrid(anisotropic(), brdf::Channels::rgb());
  const brdf::Components components = someComponents();
  brdf::writeContainer(path, "a", *written, {}, components);
  const std::string bytes = brdf::readFile(path);
  std::size_t errors = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 37) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 8)));
    try {
      const Container container = Container::fromBytes(damaged, "damaged.vtkhdf");
      EXPECT_TRUE(container.entries().size() == 1 && sameGrid(*container.load(0), *written)) << "byte " << i;
      const brdf::Components read = container.components(0);
      EXPECT_TRUE(read.specular.size() == 1 && read.specular[0].values == components.specular[0].values)
          << "byte " << i;
    } catch (const brdf::Error& error) {
      ++errors;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(errors, 0u);
}

TEST(GridContainer, Vtk91ReadsItsImage) {
  const fs::path folder = freshFolder("gridvtk");
  if (std::system(BRDF_PYTHON " -c 'from vtkmodules.vtkIOHDF import vtkHDFReader' > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "no Python with VTK's vtkIOHDF at " BRDF_PYTHON;
  const auto grid = someGrid(anisotropic(), brdf::Channels::monochrome());
  brdf::ContainerWriter writer(folder / "a.vtkhdf");
  writer.add("flat", *someGrid(layouts()[4], brdf::Channels::rgb()), {});  // one axis: never shown
  writer.add("grid", *grid, {});
  writer.commit();
  brdf::writeFile(folder / "read.py", R"(
import sys
from vtkmodules.vtkIOHDF import vtkHDFReader
reader = vtkHDFReader()
reader.SetFileName(sys.argv[1])
reader.Update()
image = reader.GetOutputDataObject(0)
print(*image.GetExtent(), *image.GetOrigin(), *(round(x, 9) for x in image.GetSpacing()))
data = image.GetPointData()
for name in ("valid", "value_0", "error_0"):
    array = data.GetArray(name)
    print(*(repr(float(array.GetTuple1(j))) for j in range(array.GetNumberOfTuples())))
)");
  const std::string command = BRDF_PYTHON " " + (folder / "read.py").string() + " " + (folder / "a.vtkhdf").string() +
                              " > " + (folder / "out.txt").string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::istringstream out(brdf::readFile(folder / "out.txt"));
  std::string line;
  std::getline(out, line);
  EXPECT_EQ(line, "0 5 0 7 0 19 0.0 0.0 0.0 15.0 45.0 1.0");
  double number = 0;
  for (const std::uint8_t state : grid->data().states) EXPECT_TRUE(out >> number && number == state);
  for (const double value : grid->data().values) EXPECT_TRUE(out >> number && number == value);
  for (const double error : grid->data().standardError) EXPECT_TRUE(out >> number && number == error);
}
