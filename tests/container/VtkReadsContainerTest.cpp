#include <brdf/base/File.h>
#include <brdf/io/Container.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "Samples.h"

namespace fs = std::filesystem;
using samples::freshFolder;

namespace {

/// A table whose values no decimal writer and no float would bring back, with invalid cells.
std::shared_ptr<const brdf::TableBrdf> someTable(const brdf::TableLayout& layout, brdf::Channels channels,
                                                 brdf::TableBrdf::Position position = brdf::TableBrdf::Position::Node) {
  brdf::TableData data;
  data.layout = layout;
  data.channels = std::move(channels);
  const std::size_t cells = layout.cells();
  for (std::size_t i = 0; i < cells * data.channels.count(); ++i) data.values.push_back(static_cast<double>(i + 1) / 7);
  for (std::size_t i = 0; i < cells; ++i) data.valid.push_back(i % 11 != 5);
  return std::make_shared<const brdf::TableBrdf>(std::move(data), "table of sevenths", brdf::TableBrdf::Lookup::Nearest,
                                                 position);
}

bool sameTable(const brdf::Brdf& a, const brdf::Brdf& b) {
  const auto& x = dynamic_cast<const brdf::TableBrdf&>(a);
  const auto& y = dynamic_cast<const brdf::TableBrdf&>(b);
  return x.data().layout == y.data().layout && x.data().channels == y.data().channels &&
         x.data().values == y.data().values && x.data().valid == y.data().valid && x.lookup() == y.lookup() &&
         x.position() == y.position() && x.description() == y.description();
}

/// What the command prints; empty when it fails.
std::string outputOf(const std::string& command, const fs::path& folder) {
  const fs::path out = folder / "output.txt";
  if (std::system((command + " > " + out.string() + " 2>&1").c_str()) != 0) {
    ADD_FAILURE() << command << "\n" << brdf::readFile(out);
    return {};
  }
  return brdf::readFile(out);
}

}  // namespace

TEST(Container, TablesComeBackBitForBit) {
  const fs::path folder = freshFolder("tables");
  const std::vector<brdf::TableLayout> layouts = {
      {180, 90, 90, true}, {12, 5, 4, false}, {1, 1, 1, true}, {6, 1, 3, true}};
  for (const brdf::TableLayout& layout : layouts) {
    for (const brdf::Channels& channels :
         {brdf::Channels::rgb(), brdf::Channels::monochrome(), brdf::Channels::spectral({400, 500})}) {
      const auto written = someTable(layout, channels);
      brdf::writeContainer(folder / "a.vtkhdf", "a", *written, {});
      const brdf::Container container(folder / "a.vtkhdf");
      EXPECT_EQ(container.entries()[0].kind, "table");
      EXPECT_TRUE(sameTable(*container.load(0), *written)) << layout.phiD << " x " << layout.thetaD;
    }
  }
}

TEST(Container, Vtk91ReadsEveryValueOfATable) {
  const fs::path folder = freshFolder("vtk");
  if (std::system(BRDF_PYTHON " -c 'from vtkmodules.vtkIOHDF import vtkHDFReader' > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "no Python with VTK's vtkIOHDF at " BRDF_PYTHON;
  brdf::ContainerWriter writer(folder / "a.vtkhdf");
  writer.add("material", *brdf::parseMaterialExpression("0.1*Lambertian"), {});
  writer.add("thin", *someTable({4, 1, 1, false}, brdf::Channels::rgb()), {});  // VTK 9.1 would write past its heap
  writer.add("first", *someTable({7, 5, 3, true}, brdf::Channels::rgb()), {});
  writer.add("second", *someTable({4, 3, 2, false}, brdf::Channels::monochrome(), brdf::TableBrdf::Position::Centre),
             {});
  writer.commit();

  brdf::writeFile(folder / "read.py", R"(
import sys
from vtkmodules.vtkIOHDF import vtkHDFReader
reader = vtkHDFReader()
print(reader.CanReadFile(sys.argv[1]))
reader.SetFileName(sys.argv[1])
reader.Update()
image = reader.GetOutputDataObject(0)
print(*image.GetExtent())
print(*(x.hex() for x in image.GetOrigin()))
print(*(x.hex() for x in image.GetSpacing()))
data = image.GetPointData()
for name in sorted(data.GetArrayName(i) for i in range(data.GetNumberOfArrays())):
    array = data.GetArray(name)
    print(array.GetName(), *(float(array.GetTuple1(j)).hex() for j in range(array.GetNumberOfTuples())))
)");
  const auto hex = [](double value) {  // Python's float.hex()
    char text[64];
    std::snprintf(text, sizeof text, value == 0 ? "0x0.0p+0" : "%.13a", value);
    return std::string(text);
  };
  const auto expected = [&](const brdf::TableBrdf& table) {
    const auto& data = table.data();
    std::string text = "1\n0 " + std::to_string(data.layout.phiD - 1) + " 0 " + std::to_string(data.layout.thetaD - 1) +
                       " 0 " + std::to_string(data.layout.thetaH - 1) + "\n";
    const double x = (data.layout.reciprocal ? 180 : 360) / static_cast<double>(data.layout.phiD);
    const double y = 90 / static_cast<double>(data.layout.thetaD);
    const double z = 1 / static_cast<double>(data.layout.thetaH);
    const double shift = table.position() == brdf::TableBrdf::Position::Node ? 0 : 0.5;
    text += hex(shift * x) + " " + hex(shift * y) + " " + hex(shift * z) + "\n";
    text += hex(x) + " " + hex(y) + " " + hex(z) + "\nvalid";
    for (const std::uint8_t valid : data.valid) text += " " + hex(valid);
    for (std::size_t c = 0; c < data.channels.count(); ++c) {
      text += "\nvalue_" + std::to_string(c);
      for (std::size_t i = 0; i < data.layout.cells(); ++i) text += " " + hex(data.values[c * data.layout.cells() + i]);
    }
    return text + "\n";
  };
  const std::string python = BRDF_PYTHON " " + (folder / "read.py").string() + " ";
  EXPECT_EQ(outputOf(python + (folder / "a.vtkhdf").string(), folder),
            expected(*someTable({7, 5, 3, true}, brdf::Channels::rgb())));

  brdf::ContainerWriter again(folder / "a.vtkhdf", brdf::ContainerWriter::Mode::Append);
  EXPECT_THROW(again.show("thin"), brdf::Error);
  again.show("second");
  again.commit();
  EXPECT_EQ(outputOf(python + (folder / "a.vtkhdf").string(), folder),
            expected(*someTable({4, 3, 2, false}, brdf::Channels::monochrome(), brdf::TableBrdf::Position::Centre)));
}

TEST(Container, H5dumpOpensIt) {
  const fs::path folder = freshFolder("h5dump");
  if (std::system("command -v h5dump > /dev/null 2>&1") != 0) GTEST_SKIP() << "no h5dump here (package hdf5-tools)";
  brdf::writeContainer(folder / "a.vtkhdf", "a", *samples::scattered(1000), {});
  EXPECT_NE(outputOf("h5dump " + (folder / "a.vtkhdf").string(), folder).find("value_2"), std::string::npos);
  brdf::ContainerWriter(folder / "empty.vtkhdf").commit();
  EXPECT_NE(outputOf("h5dump " + (folder / "empty.vtkhdf").string(), folder).find("BRDFLab"), std::string::npos);
}
