#include <brdf/base/Error.h>
#include <brdf/base/FileLock.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace brdf {

std::optional<FileLock> FileLock::tryAcquire(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_CREAT | O_RDWR | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) throw Error(Error::Kind::File, {"cannot be written", path.string(), std::strerror(errno), {}});
  FileLock lock(file);
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return lock;
  if (errno == EWOULDBLOCK) return std::nullopt;
  throw Error(Error::Kind::File, {"cannot be locked", path.string(), std::strerror(errno), {}});
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace brdf
