#include <brdf/io/Hdf5Handles.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace brdf::h5 {
namespace {

constexpr std::uint64_t kMaximumArrayBytes = std::uint64_t{4} << 30;
constexpr std::uint64_t kMaximumAttributeBytes = std::uint64_t{16} << 20;
constexpr std::uint64_t kMaximumChunkBytes = std::uint64_t{64} << 20;
constexpr std::size_t kMaximumRank = 8;
/// Deflate cannot shrink by more than 1032:1 (RFC 1951: 258 bytes from a quarter of a byte).
constexpr std::uint64_t kLargestCompression = 1032;

/// An attribute opened for reading: its stored type and number of elements, both within bounds.
struct OpenAttribute {
  Handle attribute, type;
  std::size_t count = 0;
};

OpenAttribute openAttribute(hid_t object, const std::string& name, H5T_class_t typeClass, const std::string& where) {
  OpenAttribute open;
  open.attribute = own(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, where, "attribute missing or damaged");
  open.type = own(H5Aget_type(*open.attribute), H5Tclose, where, "attribute damaged");
  if (H5Tget_class(*open.type) != typeClass || H5Tis_variable_str(*open.type) > 0)
    fail(where, "attribute of the wrong type", "");
  const Handle space = own(H5Aget_space(*open.attribute), H5Sclose, where, "attribute damaged");
  const hssize_t count = H5Sget_simple_extent_npoints(*space);
  const std::size_t size = std::max<std::size_t>(H5Tget_size(*open.type), 8);
  if (count < 0 || static_cast<std::uint64_t>(count) > kMaximumAttributeBytes / size)
    fail(where, "attribute too large", std::to_string(count) + " elements of " + std::to_string(size) + " bytes",
         "at most " + std::to_string(kMaximumAttributeBytes) + " bytes");
  open.count = static_cast<std::size_t>(count);
  return open;
}

template <class T>
std::vector<T> readAttribute(hid_t object, const std::string& name, const std::string& where) {
  const OpenAttribute open = openAttribute(object, name, kTypeClass<T>, where);
  std::vector<T> values(open.count);
  if (!values.empty()) check(H5Aread(*open.attribute, nativeType<T>(), values.data()), where, "attribute damaged");
  return values;
}

std::vector<std::string> readTexts(hid_t object, const std::string& name, const std::string& where) {
  const OpenAttribute open = openAttribute(object, name, H5T_STRING, where);
  const std::size_t size = H5Tget_size(*open.type);
  std::string bytes(open.count * size, '\0');
  if (!bytes.empty()) check(H5Aread(*open.attribute, *open.type, bytes.data()), where, "attribute damaged");
  std::vector<std::string> texts(open.count);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    texts[i] = bytes.substr(i * size, size);
    texts[i].resize(std::strlen(texts[i].c_str()));
  }
  return texts;
}

void checkFilters(hid_t properties, const std::string& where) {
  const int count = H5Pget_nfilters(properties);
  for (int i = 0; i < count; ++i) {
    unsigned flags = 0, configuration = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &configuration);
    if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_FLETCHER32)
      fail(where, "unknown compression", "filter " + std::to_string(filter), "deflate, shuffle, fletcher32");
  }
}

std::uint64_t fileSize(hid_t object, const std::string& where) {
  const Handle file = own(H5Iget_file_id(object), H5Fclose, where, "file damaged");
  hsize_t size = 0;
  check(H5Fget_filesize(*file, &size), where, "file damaged");
  return size;
}

/// A dataset opened for reading whose claimed size has been checked against what is stored.
struct OpenArray {
  Handle dataset, type;
  std::vector<std::uint64_t> dimensions;
};

OpenArray openArray(hid_t group, const std::string& name, const std::string& where) {
  H5L_info_t link;
  if (H5Lexists(group, name.c_str(), H5P_DEFAULT) <= 0) fail(where, "no such array", "");
  check(H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT), where, "array damaged");
  if (link.type != H5L_TYPE_HARD) fail(where, "an array must lie in the file itself", "a link", "an array");
  OpenArray open;
  open.dataset = own(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, where, "array damaged");
  open.type = own(H5Dget_type(*open.dataset), H5Tclose, where, "array damaged");
  const Handle space = own(H5Dget_space(*open.dataset), H5Sclose, where, "array damaged");
  const int rank = H5Sget_simple_extent_ndims(*space);
  if (rank < 1 || rank > static_cast<int>(kMaximumRank))
    fail(where, "array of the wrong shape", std::to_string(rank) + " dimensions", "1 to 8");
  std::array<hsize_t, kMaximumRank> sizes{};
  H5Sget_simple_extent_dims(*space, sizes.data(), nullptr);
  open.dimensions.assign(sizes.begin(), sizes.begin() + rank);

  const std::uint64_t elementSize = H5Tget_size(open.type ? *open.type : 0);
  std::uint64_t bytes = std::max<std::uint64_t>(elementSize, 1);
  for (const std::uint64_t d : open.dimensions) {
    if (d != 0 && bytes > kMaximumArrayBytes / d)
      fail(where, "array too large", "more than 4 GiB", "at most " + std::to_string(kMaximumArrayBytes) + " bytes");
    bytes *= d;
  }
  const Handle properties = own(H5Dget_create_plist(*open.dataset), H5Pclose, where, "array damaged");
  const H5D_layout_t layout = H5Pget_layout(*properties);
  if ((layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED) ||
      H5Pget_external_count(*properties) > 0)
    fail(where, "an array must lie in the file itself", "an external or virtual one");
  checkFilters(*properties, where);
  if (layout == H5D_CHUNKED) {
    std::array<hsize_t, kMaximumRank> chunk{};
    check(H5Pget_chunk(*properties, rank, chunk.data()), where, "array damaged");
    std::uint64_t chunkBytes = elementSize;
    for (int i = 0; i < rank; ++i) {
      if (chunk[i] == 0 || chunkBytes > kMaximumChunkBytes / chunk[i])
        fail(where, "chunks of the wrong size", "", "at most " + std::to_string(kMaximumChunkBytes) + " bytes");
      chunkBytes *= chunk[i];
    }
  }
  const std::uint64_t stored = H5Dget_storage_size(*open.dataset);
  if (stored < bytes / kLargestCompression || stored > fileSize(group, where))
    fail(where, "array claims more than the file holds",
         std::to_string(bytes) + " bytes claimed, " + std::to_string(stored) + " stored");
  return open;
}

/// The same, of elements T and of the shape expected.
template <class T>
OpenArray openArray(hid_t group, const std::string& name, const std::string& where,
                    std::span<const std::uint64_t> dimensions) {
  OpenArray open = openArray(group, name, where);
  if (H5Tget_class(*open.type) != kTypeClass<T>) fail(where, "array of the wrong type", "");
  if (!std::equal(dimensions.begin(), dimensions.end(), open.dimensions.begin(), open.dimensions.end())) {
    const auto shape = [](std::span<const std::uint64_t> sizes) {
      std::string text;
      for (const std::uint64_t size : sizes) text += (text.empty() ? "" : " x ") + std::to_string(size);
      return text;
    };
    fail(where, "array of the wrong shape", shape(open.dimensions), shape(dimensions));
  }
  return open;
}

std::vector<std::string> sorted(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

bool Group::has(const std::string& name) const {
  const Quiet quiet;
  return H5Aexists(*handle_, name.c_str()) > 0;
}

bool Group::hasObject(const std::string& name) const {
  const Quiet quiet;
  H5L_info_t link;
  const htri_t exists = H5Lexists(*handle_, name.c_str(), H5P_DEFAULT);
  check(exists, where_, "group damaged");
  if (exists == 0) return false;
  check(H5Lget_info(*handle_, name.c_str(), &link, H5P_DEFAULT), where_, "group damaged");
  return link.type == H5L_TYPE_HARD;
}

std::vector<std::string> Group::objectNames() const {
  const Quiet quiet;
  std::vector<std::string> names;
  hsize_t position = 0;
  check(H5Literate(
            *handle_, H5_INDEX_NAME, H5_ITER_NATIVE, &position,
            [](hid_t, const char* name, const H5L_info_t* link, void* out) -> herr_t {
              if (link->type == H5L_TYPE_HARD) static_cast<std::vector<std::string>*>(out)->push_back(name);
              return 0;
            },
            &names),
        where_, "group damaged");
  return sorted(std::move(names));
}

std::vector<std::string> Group::attributeNames() const {
  const Quiet quiet;
  std::vector<std::string> names;
  hsize_t position = 0;
  check(H5Aiterate2(
            *handle_, H5_INDEX_NAME, H5_ITER_NATIVE, &position,
            [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
              static_cast<std::vector<std::string>*>(out)->push_back(name);
              return 0;
            },
            &names),
        where_, "attributes damaged");
  return sorted(std::move(names));
}

Group Group::group(const std::string& name) const {
  const Quiet quiet;
  if (!hasObject(name)) fail(at(name), "no such group", "");
  return Group(own(H5Gopen2(*handle_, name.c_str(), H5P_DEFAULT), H5Gclose, at(name), "group damaged"), at(name));
}

std::string Group::text(const std::string& name) const {
  const Quiet quiet;
  const std::vector<std::string> texts = readTexts(*handle_, name, at(name));
  if (texts.size() != 1) fail(at(name), "one text expected", std::to_string(texts.size()) + " texts");
  return texts[0];
}

std::vector<std::string> Group::texts(const std::string& name) const {
  if (!has(name)) return {};
  const Quiet quiet;
  return readTexts(*handle_, name, at(name));
}

std::int64_t Group::integer(const std::string& name) const { return integers(name, 1)[0]; }

std::vector<std::int64_t> Group::integers(const std::string& name, std::size_t count) const {
  const Quiet quiet;
  std::vector<std::int64_t> values = readAttribute<std::int64_t>(*handle_, name, at(name));
  if (values.size() != count)
    fail(at(name), "attribute of the wrong length", std::to_string(values.size()), std::to_string(count));
  return values;
}

double Group::number(const std::string& name) const {
  const Quiet quiet;
  const std::vector<double> values = readAttribute<double>(*handle_, name, at(name));
  if (values.size() != 1) fail(at(name), "one number expected", std::to_string(values.size()) + " numbers");
  return values[0];
}

std::vector<double> Group::numbers(const std::string& name) const {
  if (!has(name)) return {};
  const Quiet quiet;
  return readAttribute<double>(*handle_, name, at(name));
}

std::vector<std::uint64_t> Group::dimensions(const std::string& name) const {
  const Quiet quiet;
  return openArray(*handle_, name, at(name)).dimensions;
}

template <class T>
void Group::readArray(const std::string& name, T* values, std::span<const std::uint64_t> dimensions) const {
  const Quiet quiet;
  const OpenArray open = openArray<T>(*handle_, name, at(name), dimensions);
  check(H5Dread(*open.dataset, nativeType<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values), at(name), "array damaged");
}

template <class T>
void Group::readSlices(const std::string& name, T* values, std::span<const std::uint64_t> dimensions,
                       std::uint64_t first, std::uint64_t count) const {
  const Quiet quiet;
  const OpenArray open = openArray<T>(*handle_, name, at(name), dimensions);
  if (count == 0 || first > dimensions[0] || count > dimensions[0] - first)
    throw Error(Error::Kind::Value, {"no such slices", at(name), std::to_string(first) + " + " + std::to_string(count),
                                     "within " + std::to_string(dimensions[0])});
  std::vector<hsize_t> start(dimensions.size(), 0), size(dimensions.begin(), dimensions.end());
  start[0] = first;
  size[0] = count;
  const Handle file = own(H5Dget_space(*open.dataset), H5Sclose, at(name), "array damaged");
  check(H5Sselect_hyperslab(*file, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr), at(name),
        "array damaged");
  const Handle memory =
      own(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose, at(name), "array damaged");
  check(H5Dread(*open.dataset, nativeType<T>(), *memory, *file, H5P_DEFAULT, values), at(name), "array damaged");
}

template void Group::readArray(const std::string&, double*, std::span<const std::uint64_t>) const;
template void Group::readArray(const std::string&, std::uint8_t*, std::span<const std::uint64_t>) const;
template void Group::readSlices(const std::string&, double*, std::span<const std::uint64_t>, std::uint64_t,
                                std::uint64_t) const;
template void Group::readSlices(const std::string&, std::uint8_t*, std::span<const std::uint64_t>, std::uint64_t,
                                std::uint64_t) const;

std::string Group::linkTarget(const std::string& name) const {
  const Quiet quiet;
  H5L_info_t link;
  if (H5Lexists(*handle_, name.c_str(), H5P_DEFAULT) <= 0 ||
      H5Lget_info(*handle_, name.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_SOFT ||
      link.u.val_size > 4096)
    return {};
  std::string target(link.u.val_size, '\0');
  if (H5Lget_val(*handle_, name.c_str(), target.data(), target.size(), H5P_DEFAULT) < 0) return {};
  target.resize(std::strlen(target.c_str()));
  return target;
}

}  // namespace brdf::h5
