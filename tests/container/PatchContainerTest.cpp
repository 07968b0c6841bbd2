// Matrices of patches and tensor trees in containers.
#include <brdf/geometry/Directions.h>
#include <brdf/io/Container.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/TreeBrdf.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <functional>

#include "Samples.h"

namespace {

using brdf::Channels;
using brdf::radians;
using samples::freshFolder;

std::shared_ptr<const brdf::PatchBrdf> somePatches() {
  brdf::PatchData data{brdf::PatchBasis::klemsQuarter(),
                       brdf::PatchBasis("mine", {{radians(12.3), 1}, {radians(80), 7}}),
                       Channels::rgb(),
                       {}};
  for (std::size_t k = 0; k < 41 * 8 * 3; ++k) data.values.push_back(static_cast<double>(k + 1) / 7);
  return std::make_shared<const brdf::PatchBrdf>(std::move(data), "sevenths");
}

std::shared_ptr<const brdf::TreeBrdf> someTree(int rank) {
  brdf::TensorTree tree(rank, 2);
  tree.divide(tree.divide(tree.divide(0) + 3) + 1);
  for (std::size_t cell = 0; cell < tree.cells(); ++cell)
    for (std::size_t c = 0; c < 2; ++c) tree.values(cell)[c] = static_cast<double>(cell * 2 + c + 1) / 7;
  return std::make_shared<const brdf::TreeBrdf>(std::move(tree), Channels::spectral({500, 600}), "tree of sevenths");
}

bool sameNodes(const brdf::TensorTree& a, brdf::TensorTree::Node x, const brdf::TensorTree& b,
               brdf::TensorTree::Node y) {
  if (a.isCell(x) != b.isCell(y)) return false;
  if (a.isCell(x)) return std::equal(a.values(a.cell(x)), a.values(a.cell(x)) + a.channels(), b.values(b.cell(y)));
  for (std::size_t c = 0; c < a.children(); ++c)
    if (!sameNodes(a, a.child(x, c), b, b.child(y, c))) return false;
  return true;
}

}  // namespace

TEST(PatchContainer, KeepsMatricesAndTreesAsTheyAre) {
  const auto path = freshFolder("patch_container") / "a.vtkhdf";
  const auto patches = somePatches();
  brdf::Components components;
  components.scatter.push_back({brdf::ComponentKind::BackTransmission, someTree(3)});
  {
    brdf::ContainerWriter writer(path);
    writer.add("patches", *patches, {}, components);
    for (const int rank : {3, 4}) writer.add("tree" + std::to_string(rank), *someTree(rank), {});
    writer.commit();
  }
  const brdf::Container container(path);
  EXPECT_EQ(container.entries()[0].kind, "patches");
  const auto back = container.load(0);
  const auto& data = dynamic_cast<const brdf::PatchBrdf&>(*back).data();
  EXPECT_EQ(data.values, patches->data().values);
  EXPECT_EQ(data.incident, patches->data().incident);
  EXPECT_EQ(data.outgoing, patches->data().outgoing);
  EXPECT_EQ(data.outgoing.name(), "mine");
  EXPECT_EQ(data.channels, Channels::rgb());
  EXPECT_EQ(back->description(), "sevenths");
  const auto component = container.components(0).find(brdf::ComponentKind::BackTransmission);
  const auto expectTree = [](const brdf::Brdf& found, int rank) {
    const auto& tree = dynamic_cast<const brdf::TreeBrdf&>(found).tree();
    EXPECT_EQ(tree.rank(), rank);
    EXPECT_TRUE(sameNodes(tree, 0, someTree(rank)->tree(), 0));
    EXPECT_EQ(found.channels(), Channels::spectral({500, 600}));
  };
  expectTree(*component, 3);
  expectTree(*container.load(1), 3);
  expectTree(*container.load(2), 4);
  EXPECT_EQ(container.entries()[2].kind, "tree");
}

TEST(PatchContainer, DamagedTreesAndMatricesAreErrors) {
  const auto path = freshFolder("patch_damaged") / "a.vtkhdf";
  // The error of loading `brdf` after `damage` to its group, through HDF5's own interface.
  const auto errorAfter = [&](const brdf::Brdf& brdf, const std::function<void(hid_t entry)>& damage) {
    brdf::writeContainer(path, "a", brdf, {});
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t entry = H5Gopen2(file, "/BRDFLab/0", H5P_DEFAULT);
    damage(entry);
    H5Gclose(entry);
    H5Fclose(file);
    return samples::errorOf([&] { brdf::Container(path).load(0); });
  };
  const auto replace = [](hid_t entry, const char* name, hid_t type, std::vector<hsize_t> shape, const void* content) {
    H5Ldelete(entry, name, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t array = H5Dcreate2(entry, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, content);
    H5Dclose(array);
    H5Sclose(space);
  };
  const std::vector<std::uint8_t> incomplete{1, 0, 0}, endless(30, 1);
  for (const auto& branches : {incomplete, endless})
    EXPECT_NE(errorAfter(*someTree(3),
                         [&](hid_t entry) {
                           replace(entry, "branches", H5T_NATIVE_UINT8, {branches.size()}, branches.data());
                         })
                  .find("tensor tree disagree"),
              std::string::npos);
  const std::vector<double> zeros(22, 0.0);
  EXPECT_NE(errorAfter(*someTree(3),
                       [&](hid_t entry) {
                         replace(entry, "value_1", H5T_NATIVE_DOUBLE, {2, 11}, zeros.data());
                       })
                .find("wrong shape"),
            std::string::npos);
  EXPECT_NE(
      errorAfter(*somePatches(), [&](hid_t entry) { replace(entry, "value_2", H5T_NATIVE_DOUBLE, {22}, zeros.data()); })
          .find("wrong shape"),
      std::string::npos);
  EXPECT_FALSE(errorAfter(*somePatches(), [](hid_t entry) {
                 H5Adelete_by_name(entry, "Incident", "Counts", H5P_DEFAULT);
               }).empty());
  EXPECT_FALSE(errorAfter(*someTree(4), [](hid_t entry) { H5Adelete(entry, "Rank"); }).empty());
}
