#pragma once
#include <brdf/base/FileLock.h>
#include <brdf/brdf_export.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

namespace brdf {

/// A file that only grows, one record a line, whose records outlive the process that wrote them: `append` returns when
/// the record is on the disk. A line is the CRC-32 (IEEE 802.3) of the record as eight hexadecimal digits, a blank, the
/// record and a line end, so that a line cut short by a crash is told from a whole one.
class BRDF_EXPORT Journal {
 public:
  /// Opens a journal to append to, for this process alone; makes the file where it is missing, and takes away a last
  /// line that is not whole. Empty when another process writes it. Throws Error::Kind::File.
  static std::optional<Journal> tryOpen(const std::filesystem::path& path);

  /// `record` has no line end. Returns when it is on the disk. Throws Error::Kind::File when it cannot be kept; the
  /// journal is then as before.
  void append(std::string_view record);

  /// Calls `take` with every whole record of the file, in order; returns how many lines were not whole. A journal may
  /// be read while it is written. Throws Error::Kind::File.
  static std::size_t read(const std::filesystem::path& path, const std::function<void(std::string_view)>& take);

 private:
  Journal(std::filesystem::path path, FileLock lock) : path_(std::move(path)), lock_(std::move(lock)) {}
  std::filesystem::path path_;
  FileLock lock_;
};

/// CRC-32 of IEEE 802.3 (as in zip and PNG): reflected polynomial 0xEDB88320, start and end inverted.
BRDF_EXPORT std::uint32_t crc32(std::string_view bytes);

}  // namespace brdf
