#pragma once
#include <brdf/brdf_export.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace brdf {

/// The whole file as bytes. Throws Error::Kind::File when it is missing, a folder, unreadable, or larger than
/// `maximumBytes` (default 4 GiB).
BRDF_EXPORT std::string readFile(const std::filesystem::path& path,
                                 std::uint64_t maximumBytes = std::uint64_t{4} << 30);

/// At most the first `count` bytes of the file, for recognising its format. Throws as readFile does.
BRDF_EXPORT std::string readFileHead(const std::filesystem::path& path, std::size_t count);

/// An output file that replaces its target only when it is complete: write to `temporaryPath()`, then `commit()`.
/// Without commit the destructor removes the temporary file and the target is as it was. Throws Error::Kind::File when
/// the target's folder is missing or not writable, or the target is a folder.
class BRDF_EXPORT AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Beside the target (the same file system), same extension, unique to this process.
  const std::filesystem::path& temporaryPath() const { return temporary_; }

  /// Flushes the temporary file to disk and renames it over the target.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

/// Removes the temporary files of all AtomicFiles that are open: for a process that is about to end without unwinding
/// (Ctrl-C). Not for signal handlers; callable from any thread.
BRDF_EXPORT void removeTemporaryFiles();

/// Writes `bytes` to `path` through an AtomicFile.
BRDF_EXPORT void writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace brdf
