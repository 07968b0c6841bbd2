#include <brdf/base/Error.h>
#include <brdf/base/File.h>

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <mutex>
#include <set>

namespace brdf {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string what, std::string found = {},
                       std::string allowed = {}) {
  throw Error(Error::Kind::File, {std::move(what), path.string(), std::move(found), std::move(allowed)});
}

std::string readAtMost(const std::filesystem::path& path, std::uint64_t limit, bool whole) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) fail(path, "no such file");
  if (std::filesystem::is_directory(status)) fail(path, "cannot be read", "a folder", "a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, "cannot be opened", std::strerror(errno));
  std::string bytes;
  if (std::filesystem::is_regular_file(status)) {
    const std::uint64_t size = std::filesystem::file_size(path, code);
    if (code) fail(path, "cannot be read", code.message());
    if (whole && size > limit)
      fail(path, "file too large", std::to_string(size) + " bytes", "at most " + std::to_string(limit) + " bytes");
    bytes.resize(std::min(size, limit));
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
  } else {  // a pipe: no size to trust
    char buffer[65536];
    while (bytes.size() < limit && (in.read(buffer, sizeof buffer), in.gcount() > 0))
      bytes.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > limit) {
      if (whole) fail(path, "file too large", "more than " + std::to_string(limit) + " bytes");
      bytes.resize(limit);
    }
  }
  if (in.bad()) fail(path, "cannot be read", std::strerror(errno));
  return bytes;
}

}  // namespace

std::string readFile(const std::filesystem::path& path, std::uint64_t maximumBytes) {
  return readAtMost(path, maximumBytes, true);
}

std::string readFileHead(const std::filesystem::path& path, std::size_t count) {
  return readAtMost(path, count, false);
}

namespace {

std::mutex openMutex;
std::set<std::filesystem::path> openTemporaries;  // guarded by openMutex

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target)) {
  if (target_.empty()) fail("output", "no file name given");
  if (std::filesystem::is_directory(target_)) fail(target_, "cannot be written", "a folder", "a file name");
  if (std::filesystem::exists(target_) && !std::filesystem::is_regular_file(target_))
    fail(target_, "cannot be replaced", "a device or pipe", "a file name");  // a rename would destroy it
  const auto folder = target_.has_parent_path() ? target_.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder)) fail(target_, "cannot be written", "no folder " + folder.string());
  static std::atomic<unsigned> counter{0};
  temporary_ = folder / ("." + target_.stem().string() + ".part" + std::to_string(::getpid()) + "-" +
                         std::to_string(counter++) + target_.extension().string());
  const int file = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0) fail(target_, "cannot be written", std::strerror(errno));
  ::close(file);
  const std::lock_guard lock(openMutex);
  openTemporaries.insert(temporary_);
}

AtomicFile::~AtomicFile() {
  const std::lock_guard lock(openMutex);
  openTemporaries.erase(temporary_);
  std::error_code ignored;
  if (!committed_) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  const int file = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail(target_, "cannot be written", std::strerror(errno));
  const bool flushed = ::fsync(file) == 0;
  const int reason = errno;
  ::close(file);
  if (!flushed) fail(target_, "cannot be written", std::strerror(reason));
  std::error_code code;
  std::filesystem::rename(temporary_, target_, code);
  if (code) fail(target_, "cannot be written", code.message());
  committed_ = true;
}

void removeTemporaryFiles() {
  const std::lock_guard lock(openMutex);
  std::error_code ignored;
  for (const auto& path : openTemporaries) std::filesystem::remove(path, ignored);
  openTemporaries.clear();
}

void writeFile(const std::filesystem::path& path, std::string_view bytes) {
  if (path == "/dev/null" || path == "/dev/stdout") {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return;
  }
  AtomicFile file(path);
  std::ofstream out(file.temporaryPath(), std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) fail(path, "cannot be written", std::strerror(errno));
  file.commit();
}

}  // namespace brdf
