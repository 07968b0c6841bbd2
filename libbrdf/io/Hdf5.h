#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A small, checked layer over HDF5's C API, for this library's own use: handles that close themselves, failures as
/// brdf::Error with file and object, and reading that trusts nothing in a file: every size is checked against what the
/// file really stores before memory is taken, links that leave the file and filters beyond the standard ones are
/// refused. Files are written in memory and handed out as bytes, so that all writing to disk goes through AtomicFile.
///
/// Everything is written in HDF5 1.10's format, whose metadata carry checksums, and bulk data get one as well
/// (Fletcher-32): a damaged file is an Error, not a wrong number.
namespace brdf::h5 {

/// An open HDF5 object (hid_t); closes with the last copy.
using Handle = std::shared_ptr<const std::int64_t>;

/// A group. Attributes hold numbers and texts, datasets hold bulk arrays.
class Group {
 public:
  Group(Handle handle, std::string where) : handle_(std::move(handle)), where_(std::move(where)) {}

  /// File and path, for messages: "fit.vtkhdf:/BRDFLab/0".
  const std::string& where() const { return where_; }

  // ----- writing ---------------------------------------------------------------------------------------------------
  Group createGroup(const std::string& name) const;
  void remove(const std::string& name) const;
  /// A soft link; replaces a link of that name.
  void linkTo(const std::string& name, const std::string& target) const;
  void setText(const std::string& name, std::string_view text) const;
  /// Leaves out an empty list.
  void setTexts(const std::string& name, std::span<const std::string> texts) const;
  void setInteger(const std::string& name, std::int64_t value) const;
  /// Leaves out an empty list.
  void setIntegers(const std::string& name, std::span<const std::int64_t> values) const;
  void setNumber(const std::string& name, double value) const;
  /// Leaves out an empty list.
  void setNumbers(const std::string& name, std::span<const double> values) const;
  /// A dataset of shape `dimensions` (slowest first), chunked and compressed where it is large. T: double or
  /// std::uint8_t.
  template <class T>
  void writeArray(const std::string& name, const T* values, std::span<const std::uint64_t> dimensions) const;

  // ----- reading: Error::Kind::Format where something is missing or of another type --------------------------------
  bool has(const std::string& name) const;          ///< an attribute
  bool hasObject(const std::string& name) const;    ///< a group or dataset inside the file
  std::vector<std::string> objectNames() const;     ///< groups and datasets, in alphabetical order
  std::vector<std::string> attributeNames() const;  ///< in alphabetical order
  Group group(const std::string& name) const;
  std::string text(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;  ///< empty where there is none
  std::int64_t integer(const std::string& name) const;
  std::vector<std::int64_t> integers(const std::string& name, std::size_t count) const;
  double number(const std::string& name) const;
  std::vector<double> numbers(const std::string& name) const;  ///< empty where there is none
  std::vector<std::uint64_t> dimensions(const std::string& name) const;
  /// The dataset's numbers as T into `values`, which holds as many as `dimensions`, its shape, says.
  template <class T>
  void readArray(const std::string& name, T* values, std::span<const std::uint64_t> dimensions) const;
  /// Of a dataset of that shape, `count` slices from `first` on along its slowest axis; no other part is read.
  template <class T>
  void readSlices(const std::string& name, T* values, std::span<const std::uint64_t> dimensions, std::uint64_t first,
                  std::uint64_t count) const;
  /// Where the soft link `name` leads; empty when there is none.
  std::string linkTarget(const std::string& name) const;

 private:
  friend class Builder;
  /// Bytes of the file that this root group belongs to, everything flushed.
  std::uint64_t flushedSize() const;
  std::string at(const std::string& name) const { return where_ + (where_.ends_with('/') ? "" : "/") + name; }
  Handle handle_;
  std::string where_;
};

/// The root group of a file on disk, opened for reading. Throws Error::Kind::File when it cannot be opened and
/// Error::Kind::Format when it is not an intact HDF5 file.
Group openFile(const std::filesystem::path& path);
/// The same of a file in memory; `bytes` are copied, `where` is for messages.
Group openBytes(std::string_view bytes, const std::string& where);

/// An HDF5 file under construction in memory.
class Builder {
 public:
  /// Starts from the content of `before` (empty: a new file); `where` is for messages.
  Builder(std::string_view before, const std::string& where);
  ~Builder();
  Builder(const Builder&) = delete;
  Builder& operator=(const Builder&) = delete;

  const Group& root() const { return *root_; }
  /// Closes the file, and what is open in it, and hands out its bytes; once.
  std::string finish();

 private:
  struct Image;
  std::unique_ptr<Image> image_;
  std::optional<Group> root_;
};

}  // namespace brdf::h5
