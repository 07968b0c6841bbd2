#pragma once
#include <brdf/brdf_export.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// One call of an expression of nested kinds, "name(key=argument, argument, ...)", split but not interpreted: what an
/// argument is (a number, a list, a file, another call, a material) its reader knows. Commas and parentheses within
/// parentheses or double quotes do not split. A name alone is a call without arguments.
struct Call {
  struct Argument {
    std::string key;            ///< before '=', empty where there is none
    std::string text;           ///< as written, without the blanks about it and without enclosing double quotes
    std::size_t column = 1;     ///< of the text, counted from 1 in the whole expression
    std::size_t keyColumn = 1;  ///< of the key; of the text where there is none
  };
  std::string name;
  std::size_t column = 1;  ///< of the name
  std::string what;        ///< what the expression is, for errors: "surface", "wave model", ...
  std::vector<Argument> arguments;

  /// "surface, column 12", for errors.
  std::string where(std::size_t atColumn) const { return what + ", column " + std::to_string(atColumn); }
};

/// Splits `text`, which starts at `column` of the whole expression. Throws Error::Kind::Formula with the column for a
/// missing name, a parenthesis or quote that is not closed, an empty argument, a key given twice, or text behind the
/// call.
BRDF_EXPORT Call parseCall(std::string_view text, const std::string& what, std::size_t column = 1);

/// The numbers of an argument: "0.1", "(0.1, 0.2, 0.3)", "0.1 0.2 0.3". Throws Error::Kind::Formula when there is none,
/// or something else.
BRDF_EXPORT std::vector<double> numbersOf(const Call& call, const Call::Argument& argument);

}  // namespace brdf
