#pragma once
#include <brdf/brdf_export.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace brdf {

/// The one exception that libbrdf throws. Its text is one line: `where: what; found FOUND; allowed ALLOWED`, with the
/// parts that are empty left out. The core never prints and never exits: only `main` turns an Error into an exit code,
/// and only the VTK layer turns it into vtkErrorMacro.
class BRDF_EXPORT Error : public std::runtime_error {
 public:
  enum class Kind {
    Usage,    ///< the request itself is malformed (exit code 2)
    File,     ///< a file cannot be opened, read or written
    Format,   ///< a file's content breaks its format
    Value,    ///< a value is out of its bounds, or unknown
    Formula,  ///< a formula or material expression does not parse
    Device    ///< a device (OpenGL, ...) is missing or failed
  };

  /// What went wrong, where (path, option, field, offset or line), the value found, the values allowed.
  struct Details {
    std::string what{};
    std::string where{};
    std::string found{};
    std::string allowed{};
  };

  Error(Kind kind, Details details);

  Kind kind() const noexcept { return kind_; }
  const Details& details() const noexcept { return details_; }

 private:
  Kind kind_;
  Details details_;
};

/// Edit (Levenshtein) distance between two names, ignoring case.
BRDF_EXPORT std::size_t editDistance(std::string_view a, std::string_view b);

/// The candidate closest to `name` by edit distance, or empty when none is near (about a third of its length).
template <class Range>
std::string closestName(std::string_view name, const Range& candidates) {
  std::string best;
  std::size_t bestDistance = name.size() / 3 + 2;
  for (const auto& candidate : candidates) {
    const std::size_t distance = editDistance(name, candidate);
    if (distance < bestDistance) {
      bestDistance = distance;
      best = std::string(candidate);
    }
  }
  return best;
}

}  // namespace brdf
