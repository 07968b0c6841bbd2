#pragma once
#include <brdf/brdf_export.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::formula {

/// How mathematics is written: for a typesetter, or on one line of plain text.
enum class MathStyle {
  Latex,   ///< for LaTeX and the Markdown renderers that know it
  Unicode  ///< for a terminal
};

/// `name` as mathematics: Greek words as letters, what follows the first '_' as an index, digits at the end as one. A
/// name of several letters stands upright in roman type.
BRDF_EXPORT std::string mathSymbol(std::string_view name, MathStyle style);

/// One statement of a formula.
struct MathStatement {
  std::string target;      ///< what is defined, "x" or "f(a, b)", or empty for the formula's value
  std::string expression;  ///< what it is
};

/// The statements of a formula (formula/Parser.h) as mathematics, operations with the fewest parentheses that keep
/// their meaning. `symbols` says how names (parameters, say) are spelled, e.g. {"ior", "n"}, before mathSymbol; the
/// directions' variables have symbols of their own. Throws Error::Kind::Formula with `where`.
BRDF_EXPORT std::vector<MathStatement> printMath(std::string_view formula, MathStyle style,
                                                 const std::map<std::string, std::string>& symbols,
                                                 const std::string& where);

}  // namespace brdf::formula
