#pragma once
// Internal to libbrdf/formula.
#include <brdf/formula/MathPrinter.h>

namespace brdf::formula {

/// The symbol of a variable of the directions (formula/Variables.h), or empty.
std::string variableSymbol(std::string_view name, MathStyle style);

}  // namespace brdf::formula
