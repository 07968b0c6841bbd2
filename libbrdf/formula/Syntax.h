#pragma once
// Text of the formula language to syntax trees. Internal to libbrdf/formula.
#include <brdf/formula/Parser.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::formula {

struct Expression {
  enum class Kind { Number, Name, Call };
  Kind kind = Kind::Number;
  double number = 0;
  std::string name;  ///< of a Name or Call; operators are calls of "+", "neg", "?:", ...
  std::vector<std::unique_ptr<Expression>> arguments;
  Position position;
};

struct Statement {
  std::string target;                  ///< assigned name, or empty
  std::vector<std::string> arguments;  ///< of a function definition
  bool isFunction = false;
  std::unique_ptr<Expression> value;
  Position position;
};

/// Throws Error::Kind::Formula; `where` begins its place, and `start` is that of the text's first character.
std::vector<Statement> parseStatements(std::string_view text, const std::string& where, Position start = {});

[[noreturn]] void formulaError(const std::string& where, Position position, std::string what, std::string found = {},
                               std::string allowed = {});

}  // namespace brdf::formula
