#pragma once
#include <brdf/brdf_export.h>

#include <filesystem>
#include <optional>

namespace brdf {

/// A file that this process alone holds, among all that ask through this class. The system takes the lock back when the
/// process ends, however it ends. The file itself stays.
class BRDF_EXPORT FileLock {
 public:
  /// Makes the file where it is missing. Empty when another holder has it. Throws Error::Kind::File when it cannot be
  /// made or opened, or its file system has no locks.
  static std::optional<FileLock> tryAcquire(const std::filesystem::path& path);

  FileLock(FileLock&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  FileLock& operator=(FileLock&&) = delete;
  ~FileLock();

  /// Open for reading and appending.
  int descriptor() const { return descriptor_; }

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace brdf
