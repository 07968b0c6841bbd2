#include "ContainerEdits.h"

#include <brdf/base/File.h>
#include <brdf/fit/StoredFit.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/Container.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/material/TreeBrdf.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

namespace {

using namespace brdf;

/// Numbers that readers stumble over.
constexpr std::array<double, 16> kNumbers = {
    0,     1,   2,   3,   -1,   0.5,  1e-300, std::numeric_limits<double>::denorm_min(),
    1e300, 180, 360, 400, 6.28, 1e15, -1e300, std::numeric_limits<double>::infinity()};

template <class Data>
Data sevenths(Data data, std::size_t cells) {
  for (std::size_t i = 0; i < cells * data.channels.count(); ++i) data.values.push_back(static_cast<double>(i + 1) / 7);
  return data;
}

BrdfPointer table() {
  TableData data = sevenths(TableData{{.phiD = 3, .thetaD = 2, .thetaH = 2}, Channels::rgb(), {}, {}}, 12);
  data.valid = {0, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 0};
  return std::make_shared<TableBrdf>(std::move(data), "table");
}

BrdfPointer grid() {
  GridLayout layout{Parametrisation::Specular,
                    {GridAxis::listedDegrees(AxisQuantity::SpecularTheta, {0, 1, 5}),
                     GridAxis::uniformNodes(AxisQuantity::SpecularPhi, 0, kPi, 2),
                     GridAxis::cellsDegrees(AxisQuantity::ThetaI, {0, 30, 60})},
                    {.mirror = true}};
  layout.specularOffsets = {0, -0.1};
  GridData data = sevenths(GridData{layout, Channels::spectral({500, 600}), {}, {}}, 12);
  data.standardError = data.values;
  return std::make_shared<GridBrdf>(std::move(data), "grid");
}

BrdfPointer patches() {
  const PatchBasis basis("mine", {{radians(12), 1}, {radians(80), 3}});
  return std::make_shared<PatchBrdf>(sevenths(PatchData{basis, basis, Channels::monochrome(), {}}, 16), "patches");
}

BrdfPointer tree(int rank) {
  TensorTree cells(rank, 1);
  cells.divide(cells.divide(0) + 1);
  return std::make_shared<TreeBrdf>(std::move(cells), Channels::monochrome(), "tree");
}

BrdfPointer scattered() {
  ScatteredSamples samples;
  samples.channels = Channels::rgb();
  for (const double theta : {0.1, 0.4, 0.9, 1.3}) {
    samples.pairs.push(fromSpherical(theta, 0), fromSpherical(1.4 - theta, 3));
    samples.valid.push_back(theta < 1);
  }
  return std::make_shared<ScatteredBrdf>(sevenths(std::move(samples), 4), "scattered");
}

Components allComponents() {
  Components components;
  components.scatter.push_back({ComponentKind::FrontTransmission, grid()});
  components.specular.push_back({ComponentKind::FrontReflection, Channels::monochrome(), {0, 1}, {0.1, 0.2}});
  components.totals.push_back({ComponentKind::BackReflection, {0, 1}, {0.1, 0.2}});
  return components;
}

std::vector<std::string> makeContainers() {
  const auto path = std::filesystem::temp_directory_path() / ("brdf-fuzz-" + std::to_string(::getpid()) + ".vtkhdf");
  const auto lobes = parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2)");
  std::vector<std::string> containers;
  for (const BrdfPointer& material : {table(), grid(), patches(), tree(3), tree(4), scattered(), BrdfPointer(lobes)}) {
    ReadReport report;
    report.metadata = {{"device", "none"}};
    report.warnings = {"made up"};
    ContainerWriter writer(path);
    const h5::Group entry = writer.add("a", *material, makeProvenance(report), allComponents());
    if (material == lobes) {
      FitReport fit;
      fit.material = lobes;
      fit.metrics = fit.zeroModel = {{"rms", 0.5}};
      fit.parameters.resize(2);
      storeFit(entry, fit);
    }
    writer.commit();
    containers.push_back(readFile(path));
  }
  std::filesystem::remove(path);
  return containers;
}

const std::vector<std::string>& containers() {
  static const std::vector<std::string> made = makeContainers();
  return made;
}

/// Bytes as orders; zeros when they are used up.
class Orders {
 public:
  explicit Orders(std::string_view bytes) : bytes_(bytes) {}
  bool more() const { return !bytes_.empty(); }
  std::size_t byte() {
    if (bytes_.empty()) return 0;
    const auto value = static_cast<unsigned char>(bytes_.front());
    bytes_.remove_prefix(1);
    return value;
  }
  std::size_t below(std::size_t count) { return byte() % count; }
  std::string text(std::size_t length) {
    std::string result(bytes_.substr(0, length));
    bytes_.remove_prefix(result.size());
    result.resize(std::max<std::size_t>(length, 1));
    return result;
  }
  double number() {
    const std::size_t which = byte();
    if (which < kNumbers.size()) return kNumbers[which];
    if (which == 16) return std::nan("");
    if (which < 200) return static_cast<double>(which - 100);
    double value;
    std::memcpy(&value, text(sizeof value).data(), sizeof value);
    return value;
  }

 private:
  std::string_view bytes_;
};

/// Everything in a file that has a name.
struct Names {
  std::vector<std::string> links;                               ///< of groups and arrays: paths
  std::vector<std::pair<std::string, std::string>> attributes;  ///< path of the group, name
};

Names namesIn(hid_t file) {
  Names names;
  H5Lvisit(
      file, H5_INDEX_NAME, H5_ITER_INC,
      [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
        static_cast<Names*>(out)->links.emplace_back(name);
        return 0;
      },
      &names);
  for (const std::string& link : names.links) {
    const auto list = [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
      static_cast<std::vector<std::string>*>(out)->emplace_back(name);
      return 0;
    };
    std::vector<std::string> found;
    const hid_t object = H5Oopen(file, link.c_str(), H5P_DEFAULT);
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, list, &found);
    H5Oclose(object);
    for (std::string& name : found) names.attributes.emplace_back(link, std::move(name));
  }
  return names;
}

void editAttribute(hid_t file, const std::string& path, const std::string& name, Orders& orders) {
  const hid_t object = H5Oopen(file, path.c_str(), H5P_DEFAULT);
  if (object < 0) return;  // deleted before
  H5Adelete(object, name.c_str());
  const std::size_t kind = orders.below(4);
  const hsize_t count = kind == 0 ? 0 : 1 + orders.below(18);
  const hid_t space = count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr);
  const auto write = [&](hid_t type, const void* values) {
    const hid_t attribute = H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, values);
    H5Aclose(attribute);
  };
  if (kind == 1) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    const std::size_t length = 1 + orders.below(32);
    H5Tset_size(type, length);
    write(type, orders.text(length * count).data());
    H5Tclose(type);
  } else if (kind > 1) {
    std::vector<double> numbers(count);
    for (double& value : numbers) value = orders.number();
    std::vector<std::int64_t> integers;
    for (const double value : numbers)
      integers.push_back(std::abs(value) < 9e18 ? static_cast<std::int64_t>(value)
                                                : std::numeric_limits<std::int64_t>::min());
    if (kind == 2)
      write(H5T_NATIVE_DOUBLE, numbers.data());
    else
      write(H5T_NATIVE_INT64, integers.data());
  }
  H5Sclose(space);
  H5Oclose(object);
}

/// A new array in place of what is called so: its values, or only a claim of them.
void replaceArray(hid_t file, const std::string& path, Orders& orders) {
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  std::array<hsize_t, 4> sizes{}, chunk{};
  const int rank = 1 + static_cast<int>(orders.below(4));
  const bool claim = orders.below(4) == 0;
  std::size_t count = 1;
  for (int i = 0; i < rank; ++i) {
    sizes[i] = claim ? hsize_t{1} << orders.below(40) : orders.below(9);
    chunk[i] = std::max<hsize_t>(std::min<hsize_t>(sizes[i], 16), 1);
    count *= claim ? 1 : sizes[i];
  }
  const std::array<hid_t, 4> types = {H5T_IEEE_F64LE, H5T_STD_U8LE, H5T_STD_I32BE, H5T_IEEE_F32BE};
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  if (claim || orders.below(2) == 0) H5Pset_chunk(properties, rank, chunk.data());
  const hid_t space = H5Screate_simple(rank, sizes.data(), nullptr);
  const hid_t array =
      H5Dcreate2(file, path.c_str(), types[orders.below(types.size())], space, H5P_DEFAULT, properties, H5P_DEFAULT);
  if (!claim && count > 0) {
    std::vector<double> values(count);
    for (double& value : values) value = orders.number();
    H5Dwrite(array, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  H5Dclose(array);
  H5Sclose(space);
  H5Pclose(properties);
}

/// New values in the array, which keeps its shape.
void overwriteArray(hid_t file, const std::string& path, Orders& orders) {
  const hid_t array = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
  if (array < 0) return;  // a group, or gone
  const hid_t space = H5Dget_space(array);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  if (count > 0 && count < 4096) {
    std::vector<double> values(static_cast<std::size_t>(count));
    H5Dread(array, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    for (std::size_t n = 1 + orders.below(8); n > 0; --n) values[orders.byte() % values.size()] = orders.number();
    H5Dwrite(array, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  H5Sclose(space);
  H5Dclose(array);
}

void edit(hid_t file, const Names& names, Orders& orders) {
  const std::string& path = names.links[orders.below(names.links.size())];
  switch (orders.below(8)) {
    case 0:
      H5Ldelete(file, path.c_str(), H5P_DEFAULT);
      return;
    case 1:
      return replaceArray(file, path, orders);
    case 2:
      return overwriteArray(file, path, orders);
    case 3: {  // another object in its place, or one that holds it: cycles
      const std::string& other = names.links[orders.below(names.links.size())];
      H5Ldelete(file, path.c_str(), H5P_DEFAULT);
      if (orders.below(2) == 0)
        H5Lcreate_hard(file, other.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      else
        H5Lcreate_soft(other.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    }
    default: {
      const auto& [group, name] = names.attributes[(orders.byte() * 256 + orders.byte()) % names.attributes.size()];
      return editAttribute(file, group, name, orders);
    }
  }
}

hid_t openInMemory(const std::string& bytes) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(access, 4096, false);
  H5Pset_file_image(access, const_cast<char*>(bytes.data()), bytes.size());
  const hid_t file = H5Fopen("/no/such/folder/fuzz", H5F_ACC_RDWR, access);
  H5Pclose(access);
  return file;
}

std::string closedBytes(hid_t file) {
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  std::string bytes(static_cast<std::size_t>(std::max<ssize_t>(H5Fget_file_image(file, nullptr, 0), 0)), '\0');
  H5Fget_file_image(file, bytes.data(), bytes.size());
  H5Fclose(file);
  return bytes;
}

}  // namespace

std::size_t containerCount() { return containers().size(); }
const std::string& containerBytes(std::size_t index) { return containers().at(index); }

std::string withoutChecksums(const std::string& container) {
  const hid_t from = openInMemory(container);
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(access, 4096, false);
  const hid_t file = H5Fcreate("/no/such/folder/old", H5F_ACC_TRUNC, H5P_DEFAULT, access);
  H5Pclose(access);
  H5Ocopy(from, "BRDFLab", file, "BRDFLab", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(from);
  return closedBytes(file);
}

std::string editedContainer(std::string_view recipe) {
  constexpr int mostEdits = 12;
  Orders orders(recipe);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const hid_t file = openInMemory(containerBytes(orders.below(containerCount())));
  const Names names = namesIn(file);
  for (int i = 0; i < mostEdits && orders.more(); ++i) edit(file, names, orders);
  return closedBytes(file);
}
