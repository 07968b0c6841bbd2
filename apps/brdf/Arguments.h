#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace brdf::app {

/// Bounds of a numeric option, inclusive.
struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
};

/// The arguments that one command takes: declared by the command, then filled from the command line. A thin face over
/// CLI11, so that numbers are read without regard to the locale, every error has our form (what, where, found,
/// allowed), and one file alone pays for compiling CLI11. Option names are written with their dashes ("--out"); the
/// targets must outlive the parsing, and hold the defaults before it.
class Arguments {
 public:
  Arguments(const std::string& command, const std::string& summary, const std::string& examples);
  ~Arguments();

  /// A required argument without dashes.
  void positional(const std::string& name, std::string& target, const std::string& help);
  /// One or more of them, as the last ones.
  void positionals(const std::string& name, std::vector<std::string>& target, const std::string& help);

  void option(const std::string& name, std::string& target, const std::string& value, const std::string& help);
  /// May be given several times.
  void option(const std::string& name, std::vector<std::string>& target, const std::string& value,
              const std::string& help);
  void option(const std::string& name, double& target, const Range& range, const std::string& value,
              const std::string& help);
  /// Without a default: empty when not given.
  void option(const std::string& name, std::optional<double>& target, const Range& range, const std::string& value,
              const std::string& help);
  void option(const std::string& name, std::size_t& target, const Range& range, const std::string& help);
  /// An option that may stand alone: `given` says that it was there, `target` is empty without a value.
  void optionWithOptionalValue(const std::string& name, bool& given, std::string& target, const std::string& value,
                               const std::string& help);
  /// One word of a list.
  void choice(const std::string& name, std::string& target, const std::vector<std::string>& allowed,
              const std::string& help);
  void flag(const std::string& name, bool& target, const std::string& help);

  /// Marks the option declared last as required, or the positional as one that may be left out.
  void required();
  void optional();

  /// Reads the words after the command's name. Returns false when they ask for help. Throws Error::Kind::Usage.
  bool parse(const std::vector<std::string>& words);
  std::string help() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// `text` as a number within `range`, or throws Error::Kind::Usage naming `option`.
double numberOption(const std::string& option, const std::string& text, const Range& range = {});

/// `text` as `count` numbers separated by commas (`form` shows how, for the error), or throws Error::Kind::Usage.
std::vector<double> numberListOption(const std::string& option, std::string_view text, std::size_t count,
                                     const std::string& form);

}  // namespace brdf::app
