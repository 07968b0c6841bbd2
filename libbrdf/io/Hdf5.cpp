#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/io/Hdf5.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace brdf::h5 {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t), "HDF5 1.10 or later");

constexpr std::uint64_t kMaximumArrayBytes = std::uint64_t{4} << 30;
constexpr std::uint64_t kMaximumAttributeBytes = std::uint64_t{16} << 20;
constexpr std::uint64_t kMaximumChunkBytes = std::uint64_t{64} << 20;
constexpr std::size_t kMaximumRank = 8;
/// Deflate cannot shrink by more than 1032:1 (RFC 1951: 258 bytes from a quarter of a byte).
constexpr std::uint64_t kLargestCompression = 1032;
/// Arrays up to this size are stored inside the object header (HDF5's compact layout, limit 64 KiB).
constexpr std::uint64_t kCompactBytes = 16384;
constexpr std::uint64_t kChunkBytes = std::uint64_t{1} << 20;
constexpr unsigned kDeflateLevel = 1;

/// Silences HDF5's own printing on this thread (and gives it back), and reads the reason of the last failure.
class Quiet {
 public:
  Quiet() {
    // HDF5 keeps pieces of damaged files that it could not close, and would complain of them on standard error when the
    // process ends. Every file here is closed long before: its clean-up at exit is not needed.
    static const herr_t noCleanUpAtExit = H5dont_atexit();
    static_cast<void>(noCleanUpAtExit);
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

  static std::string reason() {
    std::string text;
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned depth, const H5E_error2_t* error, void* out) -> herr_t {
          if (depth == 0 && error->desc) *static_cast<std::string*>(out) = error->desc;
          return 0;
        },
        &text);
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

[[noreturn]] void fail(const std::string& where, std::string what, std::string found = Quiet::reason(),
                       std::string allowed = {}) {
  throw Error(Error::Kind::Format, {std::move(what), where, std::move(found), std::move(allowed)});
}

Handle own(hid_t id, herr_t (*close)(hid_t), const std::string& where, const char* what) {
  if (id < 0) fail(where, what);
  return Handle(new std::int64_t(id), [close](const std::int64_t* p) {
    const Quiet quiet;
    close(*p);
    delete p;
  });
}

void check(herr_t status, const std::string& where, const char* what) {
  if (status < 0) fail(where, what);
}

template <class T>
hid_t nativeType() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}
/// As stored: little-endian on every machine.
template <class T>
hid_t storedType() {
  if constexpr (std::is_same_v<T, double>) return H5T_IEEE_F64LE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_STD_U8LE;
}
template <class T>
constexpr H5T_class_t kTypeClass = std::is_floating_point_v<T> ? H5T_FLOAT : H5T_INTEGER;

Handle textType(std::size_t length, const std::string& where) {
  Handle type = own(H5Tcopy(H5T_C_S1), H5Tclose, where, "cannot be written");
  H5Tset_size(*type, std::max<std::size_t>(length, 1));
  H5Tset_strpad(*type, H5T_STR_NULLPAD);
  return type;
}

void writeAttribute(hid_t object, const std::string& name, hid_t stored, hid_t native, const void* data,
                    std::optional<std::size_t> count, const std::string& where) {
  const hsize_t size = count.value_or(1);
  const Handle space =
      own(count ? H5Screate_simple(1, &size, nullptr) : H5Screate(H5S_SCALAR), H5Sclose, where, "cannot be written");
  const Handle attribute = own(H5Acreate2(object, name.c_str(), stored, *space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                               where, "cannot be written");
  check(H5Awrite(*attribute, native, data), where, "cannot be written");
}

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

/// The shape of chunks of about kChunkBytes: whole slabs along the slowest axes.
std::vector<hsize_t> chunkShape(std::span<const hsize_t> dimensions, std::size_t elementSize) {
  std::vector<hsize_t> chunk(dimensions.begin(), dimensions.end());
  std::uint64_t bytes = elementSize;
  for (const hsize_t d : dimensions) bytes *= d;
  for (std::size_t axis = 0; axis < chunk.size() && bytes > kChunkBytes; ++axis) {
    const std::uint64_t slab = bytes / chunk[axis];
    chunk[axis] = std::max<std::uint64_t>(1, kChunkBytes / slab);
    bytes = slab * chunk[axis];
  }
  return chunk;
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
  if (stored < bytes / kLargestCompression)
    fail(where, "array claims more than the file holds",
         std::to_string(bytes) + " bytes claimed, " + std::to_string(stored) + " stored");
  return open;
}

Group rootOf(hid_t file, const std::string& where) {
  return Group(own(file, H5Fclose, where, "not an intact HDF5 file"), where + ":");
}

/// Access to a file in memory. With `buffer` given, HDF5's closing of the file leaves the bytes there (only then are
/// they complete) for the caller to free.
Handle memoryAccess(void** buffer, const std::string& where) {
  Handle access = own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, where, "cannot be prepared");
  check(H5Pset_fapl_core(*access, std::size_t{8} << 20, false), where, "cannot be prepared");
  check(H5Pset_libver_bounds(*access, H5F_LIBVER_V110, H5F_LIBVER_V110), where, "cannot be prepared");
  if (!buffer) return access;
  H5FD_file_image_callbacks_t callbacks{};
  callbacks.image_malloc = [](size_t size, H5FD_file_image_op_t, void*) { return std::malloc(size); };
  callbacks.image_memcpy = [](void* to, const void* from, size_t size, H5FD_file_image_op_t, void*) {
    return std::memcpy(to, from, size);
  };
  callbacks.image_realloc = [](void* bytes, size_t size, H5FD_file_image_op_t, void*) {
    return std::realloc(bytes, size);
  };
  callbacks.image_free = [](void* bytes, H5FD_file_image_op_t operation, void* data) -> herr_t {
    if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE)
      *static_cast<void**>(data) = bytes;
    else
      std::free(bytes);
    return 0;
  };
  callbacks.udata_copy = [](void* data) { return data; };
  callbacks.udata_free = [](void*) -> herr_t { return 0; };
  callbacks.udata = buffer;
  check(H5Pset_file_image_callbacks(*access, &callbacks), where, "cannot be prepared");
  return access;
}

/// HDF5 takes two files in memory of one name for the same file, and one on disk of that name for an obstacle.
std::string memoryName() {
  static std::atomic<unsigned> counter{0};
  return "/no/such/folder/" + std::to_string(counter++);
}

std::vector<std::string> sorted(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

// ----- files
// -----------------------------------------------------------------------------------------------------------

Group openFile(const std::filesystem::path& path) {
  readFileHead(path, 1);  // "no such file", "a folder": said once, in base/File
  const Quiet quiet;
  return rootOf(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), path.string());
}

Group openBytes(std::string_view bytes, const std::string& where) {
  const Quiet quiet;
  const Handle access = memoryAccess(nullptr, where);
  check(H5Pset_file_image(*access, const_cast<char*>(bytes.data()), bytes.size()), where, "cannot be opened");
  return rootOf(H5Fopen(memoryName().c_str(), H5F_ACC_RDONLY, *access), where);
}

struct Builder::Image {
  void* buffer = nullptr;
  std::string where;
  ~Image() { std::free(buffer); }
};

Builder::Builder(std::string_view before, const std::string& where) : image_(std::make_unique<Image>()) {
  const Quiet quiet;
  image_->where = where;
  const Handle access = memoryAccess(&image_->buffer, where);
  if (before.empty()) {
    root_ = rootOf(H5Fcreate(memoryName().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, *access), where);
  } else {
    check(H5Pset_file_image(*access, const_cast<char*>(before.data()), before.size()), where, "cannot be opened");
    root_ = rootOf(H5Fopen(memoryName().c_str(), H5F_ACC_RDWR, *access), where);
  }
}

Builder::~Builder() { root_.reset(); }  // before image_, which the closing file writes to

std::string Builder::finish() {
  const Quiet quiet;
  const std::uint64_t atMost = root_->flushedSize();
  root_.reset();
  // Closing gives space back. The end of the file is in the superblock: HDF5 File Format Specification 3.0, II.A,
  // version 2 and 3: 8 bytes from 28 on where addresses have 8 bytes (byte 9).
  const auto* bytes = static_cast<const unsigned char*>(image_->buffer);
  std::uint64_t size = 0;
  if (bytes && atMost >= 48 && bytes[8] == 3 && bytes[9] == 8)
    for (int i = 7; i >= 0; --i) size = size << 8 | bytes[28 + i];
  if (size == 0 || size > atMost) fail(image_->where, "cannot be completed", "");
  return std::string(static_cast<const char*>(image_->buffer), size);
}

// ----- writing
// -----------------------------------------------------------------------------------------------------------

Group Group::createGroup(const std::string& name) const {
  const Quiet quiet;
  return Group(own(H5Gcreate2(*handle_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, at(name),
                   "cannot be written"),
               at(name));
}

void Group::remove(const std::string& name) const {
  const Quiet quiet;
  check(H5Ldelete(*handle_, name.c_str(), H5P_DEFAULT), at(name), "cannot be removed");
}

void Group::linkTo(const std::string& name, const std::string& target) const {
  const Quiet quiet;
  if (H5Lexists(*handle_, name.c_str(), H5P_DEFAULT) > 0) remove(name);
  check(H5Lcreate_soft(target.c_str(), *handle_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT), at(name),
        "cannot be written");
}

void Group::setText(const std::string& name, std::string_view text) const {
  const Quiet quiet;
  const Handle type = textType(text.size(), at(name));
  const std::string bytes(text.empty() ? std::string(1, '\0') : std::string(text));
  writeAttribute(*handle_, name, *type, *type, bytes.data(), std::nullopt, at(name));
}

void Group::setTexts(const std::string& name, std::span<const std::string> texts) const {
  if (texts.empty()) return;
  const Quiet quiet;
  std::size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, text.size());
  std::string bytes;
  for (const std::string& text : texts) bytes += text + std::string(length - text.size(), '\0');
  const Handle type = textType(length, at(name));
  writeAttribute(*handle_, name, *type, *type, bytes.data(), texts.size(), at(name));
}

void Group::setInteger(const std::string& name, std::int64_t value) const {
  const Quiet quiet;
  writeAttribute(*handle_, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value, std::nullopt, at(name));
}

void Group::setIntegers(const std::string& name, std::span<const std::int64_t> values) const {
  const Quiet quiet;
  writeAttribute(*handle_, name, H5T_STD_I64LE, H5T_NATIVE_INT64, values.data(), values.size(), at(name));
}

void Group::setNumber(const std::string& name, double value) const {
  const Quiet quiet;
  writeAttribute(*handle_, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value, std::nullopt, at(name));
}

void Group::setNumbers(const std::string& name, std::span<const double> values) const {
  if (values.empty()) return;
  const Quiet quiet;
  writeAttribute(*handle_, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data(), values.size(), at(name));
}

template <class T>
void Group::writeArray(const std::string& name, const T* values, std::span<const std::uint64_t> dimensions) const {
  const Quiet quiet;
  const std::vector<hsize_t> sizes(dimensions.begin(), dimensions.end());
  std::uint64_t bytes = sizeof(T);
  for (const hsize_t d : sizes) bytes *= d;
  const Handle properties = own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, at(name), "cannot be written");
  if (bytes <= kCompactBytes) {
    check(H5Pset_layout(*properties, H5D_COMPACT), at(name), "cannot be written");
  } else {
    const std::vector<hsize_t> chunk = chunkShape(sizes, sizeof(T));
    check(H5Pset_chunk(*properties, static_cast<int>(chunk.size()), chunk.data()), at(name), "cannot be written");
    if (sizeof(T) > 1) check(H5Pset_shuffle(*properties), at(name), "cannot be written");
    check(H5Pset_deflate(*properties, kDeflateLevel), at(name), "cannot be written");
    check(H5Pset_fletcher32(*properties), at(name), "cannot be written");
  }
  const Handle space = own(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose, at(name),
                           "cannot be written");
  const Handle dataset =
      own(H5Dcreate2(*handle_, name.c_str(), storedType<T>(), *space, H5P_DEFAULT, *properties, H5P_DEFAULT), H5Dclose,
          at(name), "cannot be written");
  check(H5Dwrite(*dataset, nativeType<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values), at(name), "cannot be written");
}

template void Group::writeArray(const std::string&, const double*, std::span<const std::uint64_t>) const;
template void Group::writeArray(const std::string&, const std::uint8_t*, std::span<const std::uint64_t>) const;

std::uint64_t Group::flushedSize() const {
  check(H5Fflush(*handle_, H5F_SCOPE_GLOBAL), where_, "cannot be completed");
  const ssize_t size = H5Fget_file_image(*handle_, nullptr, 0);
  if (size <= 0) fail(where_, "cannot be completed");
  return static_cast<std::uint64_t>(size);
}

// ----- reading
// -----------------------------------------------------------------------------------------------------------

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
  const OpenArray open = openArray(*handle_, name, at(name));
  if (H5Tget_class(*open.type) != kTypeClass<T>) fail(at(name), "array of the wrong type", "");
  if (!std::equal(dimensions.begin(), dimensions.end(), open.dimensions.begin(), open.dimensions.end())) {
    const auto shape = [](std::span<const std::uint64_t> sizes) {
      std::string text;
      for (const std::uint64_t size : sizes) text += (text.empty() ? "" : " x ") + std::to_string(size);
      return text;
    };
    fail(at(name), "array of the wrong shape", shape(open.dimensions), shape(dimensions));
  }
  check(H5Dread(*open.dataset, nativeType<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values), at(name), "array damaged");
}

template void Group::readArray(const std::string&, double*, std::span<const std::uint64_t>) const;
template void Group::readArray(const std::string&, std::uint8_t*, std::span<const std::uint64_t>) const;

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
