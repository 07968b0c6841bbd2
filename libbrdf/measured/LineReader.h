#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The lines of a text: LF or CRLF at their ends, a last line without one accepted, a leading byte order mark skipped.
class LineReader {
 public:
  LineReader(std::string_view text, std::filesystem::path path);

  /// The next line that is not blank, trimmed; false at the end.
  bool next(std::string_view& line);
  /// What follows the line read last, untouched.
  std::string_view rest() const { return text_; }
  /// Takes the next `count` bytes, whatever they are; fails where fewer follow. `what` names them.
  std::string_view bytes(std::size_t count, const char* what);

  /// The text as a number of the line read last; throws Error::Kind::Format when it is none. `what` names it.
  double number(std::string_view text, const char* what) const;
  /// The same for a whole number from `low` to `high`.
  std::size_t count(std::string_view text, const char* what, std::size_t low, std::size_t high) const;
  /// Throws Error::Kind::Format with the path and the number of the line read last.
  [[noreturn]] void fail(std::string what, std::string found, std::string allowed) const;

 private:
  std::string_view text_;
  std::filesystem::path path_;
  std::size_t line_ = 0;
};

/// The words of a line: the pieces between blanks and tabs.
std::vector<std::string_view> words(std::string_view line);

}  // namespace brdf
