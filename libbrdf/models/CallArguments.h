#pragma once
#include <brdf/base/Call.h>
#include <brdf/brdf_export.h>
#include <brdf/models/Parameter.h>

#include <optional>
#include <string>
#include <vector>

namespace brdf {

/// Takes the arguments of a call by their records: names, bounds and defaults are checked in one place, for every kind
/// of things that is written as a call (surfaces, facets, wave models). Each getter declares a name; `finish` refuses
/// what nobody asked for. All throw Error::Kind::Formula or Error::Kind::Value with the column.
class BRDF_EXPORT CallArguments {
 public:
  explicit CallArguments(const Call& call) : call_(call), taken_(call.arguments.size(), false) {}

  const Call& call() const { return call_; }
  /// Whether `key` is given; does not declare it.
  bool given(const std::string& key) const;

  /// One number within the bounds of the record; its default where it is not given.
  double number(const Parameter& parameter);
  /// One number or several, each within the bounds.
  std::vector<double> numbers(const Parameter& parameter);
  /// The text of an argument, or nothing.
  std::optional<std::string> text(const std::string& key);
  /// One of `allowed`; the first where it is not given.
  std::string choice(const std::string& key, const std::vector<std::string>& allowed);
  /// An argument that is a call itself, or nothing.
  std::optional<Call> nested(const std::string& key);
  /// The arguments without a key, in their order.
  std::vector<Call::Argument> unnamed();

  /// Throws for arguments that no getter has declared, naming those that are allowed.
  void finish() const;

  /// Throws Error::Kind::Value at the place of `key` (of the call where it is not given).
  [[noreturn]] void fail(const std::string& key, std::string what, std::string found = {},
                         std::string allowed = {}) const;

 private:
  const Call::Argument* take(const std::string& key);
  double checked(const Parameter& parameter, double value) const;

  Call call_;
  std::vector<bool> taken_;
  std::vector<std::string> declared_;
};

}  // namespace brdf
