#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Journal.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>

namespace brdf {
namespace {

constexpr std::size_t kPrefix = 9;  // eight digits and a blank

constexpr std::array<std::uint32_t, 256> kCrcTable = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) value = (value & 1) != 0 ? value >> 1 ^ 0xEDB88320u : value >> 1;
    table[byte] = value;
  }
  return table;
}();

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw Error(Error::Kind::File, {"cannot be written", path.string(), std::strerror(errno), {}});
}

std::string lineOf(std::string_view record) {
  char digits[kPrefix + 1];
  std::snprintf(digits, sizeof digits, "%08x ", crc32(record));
  return digits + std::string(record) + "\n";
}

/// The record of a line without its end; empty when the line is not whole.
std::optional<std::string_view> recordOf(std::string_view line) {
  std::uint32_t expected = 0;
  if (line.size() < kPrefix || line[kPrefix - 1] != ' ') return std::nullopt;
  const char* digitsEnd = line.data() + kPrefix - 1;
  if (std::from_chars(line.data(), digitsEnd, expected, 16).ptr != digitsEnd) return std::nullopt;
  line.remove_prefix(kPrefix);
  if (crc32(line) != expected) return std::nullopt;
  return line;
}

/// Calls `take(record or nothing, end of the line)` for every line; the last may lack its end.
template <class Take>
void eachLine(std::string_view bytes, Take take) {
  for (std::size_t start = 0; start < bytes.size();) {
    const std::size_t end = bytes.find('\n', start);
    const bool ended = end != std::string_view::npos;
    take(ended ? recordOf(bytes.substr(start, end - start)) : std::nullopt, start);
    start = ended ? end + 1 : bytes.size();
  }
}

/// The folder's list of files goes to the disk too: a new file is found after a crash.
void syncFolder(const std::filesystem::path& path) {
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) fail(path);
  const bool synced = ::fsync(file) == 0 || errno == EINVAL;  // some file systems keep no such promise
  ::close(file);
  if (!synced) fail(path);
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t value = 0xFFFFFFFFu;
  for (const char byte : bytes) value = value >> 8 ^ kCrcTable[(value ^ static_cast<unsigned char>(byte)) & 0xFF];
  return ~value;
}

std::optional<Journal> Journal::tryOpen(const std::filesystem::path& path) {
  std::optional<FileLock> lock = FileLock::tryAcquire(path);
  if (!lock) return std::nullopt;
  const std::string bytes = readFile(path);
  std::size_t whole = bytes.size();
  eachLine(bytes, [&](const std::optional<std::string_view>& record, std::size_t start) {
    whole = record ? bytes.size() : std::min(whole, start);
  });
  if (whole < bytes.size() && ::ftruncate(lock->descriptor(), static_cast<off_t>(whole)) != 0) fail(path);
  syncFolder(path);
  return Journal(path, std::move(*lock));
}

void Journal::append(std::string_view record) {
  const int file = lock_.descriptor();
  const off_t before = ::lseek(file, 0, SEEK_END);
  if (before < 0) fail(path_);
  const auto abandon = [&] {
    const int reason = errno;
    [[maybe_unused]] const int ignored = ::ftruncate(file, before);
    errno = reason;
    fail(path_);
  };
  const std::string line = lineOf(record);
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = ::write(file, line.data() + done, line.size() - done);
    if (written > 0)
      done += static_cast<std::size_t>(written);
    else if (errno != EINTR)
      abandon();
  }
  if (::fdatasync(file) != 0) abandon();
}

std::size_t Journal::read(const std::filesystem::path& path, const std::function<void(std::string_view)>& take) {
  const std::string bytes = readFile(path);
  std::size_t damaged = 0;
  eachLine(bytes, [&](const std::optional<std::string_view>& record, std::size_t) {
    record ? take(*record) : static_cast<void>(++damaged);
  });
  return damaged;
}

}  // namespace brdf
