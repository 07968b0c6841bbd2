#pragma once
#include <brdf/base/Call.h>
#include <brdf/brdf_export.h>
#include <brdf/models/Parameter.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A parameter that is no number: a file, a choice.
struct TextParameter {
  std::string name;                    ///< identifier in expressions, e.g. "file"
  std::string label;                   ///< a few words for user interfaces
  std::string description;             ///< one sentence
  std::vector<std::string> choices{};  ///< what is allowed, the first by default; empty: any text
  bool required = false;               ///< must be given
};

/// The parameters of one surface: what its expression gives, checked against their records, and the defaults of the
/// rest.
class BRDF_EXPORT SurfaceArguments {
 public:
  /// Throws Error::Kind::Value for an argument that is no parameter (naming the nearest), a number out of bounds, a
  /// text that is none of the choices, and one that must be given and is not; Error::Kind::Formula for what is no
  /// number.
  SurfaceArguments(const Call& call, const std::vector<Parameter>& parameters, const std::vector<TextParameter>& texts);

  /// Each throws std::out_of_range for a name that is no parameter: a mistake of the program, not of its user.
  double number(std::string_view name) const;
  /// A number that has to be whole. Throws Error::Kind::Value where it is not.
  std::size_t whole(std::string_view name) const;
  const std::string& text(std::string_view name) const;  ///< empty where it is not given and has no choices
  bool given(std::string_view name) const;

  /// Throws Error::Kind::Value about one parameter.
  [[noreturn]] void refuse(std::string_view name, std::string what, std::string allowed) const;

  const std::string& where() const { return where_; }  ///< for errors: "surface grooves"
  /// The surface with all its parameters, as it would be typed.
  std::string expression() const;

 private:
  struct Value {
    std::string name;
    double number = 0;
    std::string text{};
    bool isText = false, given = false;
  };
  const Value& value(std::string_view name, bool isText) const;

  std::string name_, where_;
  std::vector<Value> values_;
};

}  // namespace brdf
