#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Graph.h>

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::formula {

/// A function written in the formula language, expanded where it is called.
struct Function {
  std::string name;
  std::vector<std::string> arguments;
  std::string body;   ///< statements; the last one is the value
  std::string where;  ///< for messages, e.g. "function D_GGX"
};

using FunctionTable = std::map<std::string, Function, std::less<>>;

using TableMap = std::map<std::string, std::shared_ptr<const Table>, std::less<>>;

/// A place in a text, counted from 1.
struct Position {
  int line = 1, column = 1;
};

struct ParseOptions {
  std::span<const std::string> parameters;   ///< Parameter node k is called parameters[k]
  const FunctionTable* functions = nullptr;  ///< functions that the formula may call besides the built-in ones
  const TableMap* tables = nullptr;          ///< precomputed functions that it may call by name, name(x) or name(x, y)
  std::string where;                         ///< for messages, e.g. "equation of GGX"
  Position start{};                          ///< for messages: of the text's first character, in its file, say
  std::map<std::string, NodeId, std::less<>> bindings;  ///< further names, already nodes of the graph
};

struct ParseResult {
  NodeId value = 0;                                      ///< of the last statement
  std::map<std::string, NodeId, std::less<>> variables;  ///< what the formula assigned
  std::vector<std::string> functionsUsed;                ///< names from the table, each once, in order of first use
};

/// Reads a formula into `graph`.
///
///   statements separated by ';' (empty ones allowed), each of them
///     name = expression        assigns; the name hides any variable of that name from there on
///     name(a, b) = expression  defines a function, expanded where it is called
///     expression               the last statement is the formula's value (an assignment's value counts)
///   expression: numbers, names (formula/Variables.h, the parameters), + - * / ^ (right-associative, binds tighter than
///     the minus before it: -x^2 = -(x^2)), < <= > >= == !=, && || !, c ? a : b, calls
///   functions: select(condition, then, else), also spelled if, min and max of one or more, pow, atan2, hypot, sqr,
///     gammap(a, x) and gammaq(a, x) (the regularised incomplete gamma functions), and
///   every function
///     of one number in formula/Graph.h
///   sum(k, first, last, term [, tolerance]): the terms for k = first, first + 1, ... up to last; ends early when two
///     terms running shrink below tolerance times the sum (formula/Graph.h)
///   solve(x, low, high, f): the x between low and high at which f is 0
///   comments: # or // to the end of the line. "U+003C" is read as '<' (files of BRDFLab 0.8.2).
///
/// Throws Error::Kind::Formula with line, column, what was expected and the nearest known name. Nesting, expansion and
/// the size of the graph are bounded, so that no text can exhaust memory.
BRDF_EXPORT ParseResult parse(Graph& graph, std::string_view text, const ParseOptions& options);

/// The names of all functions that parse() knows without a table, for messages and documentation.
BRDF_EXPORT std::vector<std::string> builtinFunctions();

}  // namespace brdf::formula
