#include <brdf/base/File.h>
#include <brdf/io/Hdf5Handles.h>

#include <atomic>
#include <cstdlib>
#include <cstring>

namespace brdf::h5 {
namespace {

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
  check(H5Pset_fclose_degree(*access, H5F_CLOSE_STRONG), where, "cannot be prepared");
  check(H5Pset_file_image_callbacks(*access, &callbacks), where, "cannot be prepared");
  return access;
}

/// HDF5 takes two files in memory of one name for the same file, and one on disk of that name for an obstacle.
std::string memoryName() {
  static std::atomic<unsigned> counter{0};
  return "/no/such/folder/" + std::to_string(counter++);
}

}  // namespace

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
    const Handle properties = own(H5Pcreate(H5P_FILE_CREATE), H5Pclose, where, "cannot be prepared");
    H5Pset_obj_track_times(*properties, false);
    root_ = rootOf(H5Fcreate(memoryName().c_str(), H5F_ACC_TRUNC, *properties, *access), where);
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

std::uint64_t Group::flushedSize() const {
  check(H5Fflush(*handle_, H5F_SCOPE_GLOBAL), where_, "cannot be completed");
  const ssize_t size = H5Fget_file_image(*handle_, nullptr, 0);
  if (size <= 0) fail(where_, "cannot be completed");
  return static_cast<std::uint64_t>(size);
}

}  // namespace brdf::h5
