#pragma once
// What the formula tests share: parse and evaluate in one call, and the error of a result in units of its last place.
#include <brdf/base/Error.h>
#include <brdf/formula/Extended.h>
#include <brdf/formula/Parser.h>
#include <brdf/formula/Program.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brdf::formula {

/// Inputs of every test that does not care: two unit directions and two random numbers.
inline InputLane someLane() { return {0.48, -0.36, 0.8, -0.2, 0.4, std::sqrt(0.8), 0.25, 0.75}; }

/// The value of a formula without parameters at someLane(), in 50-digit arithmetic.
inline double valueOf(const std::string& text, const FunctionTable* functions = nullptr) {
  Graph graph;
  ParseOptions options;
  options.where = "test";
  options.functions = functions;
  const NodeId node = parse(graph, text, options).value;
  return evaluateExtended(graph, {node}, someLane(), {})[0];
}

/// The details of the error that parsing `text` throws; fails the test when it parses.
inline Error::Details errorOf(const std::string& text, const std::vector<std::string>& parameters = {},
                              const FunctionTable* functions = nullptr) {
  Graph graph;
  ParseOptions options;
  options.where = "test";
  options.parameters = parameters;
  options.functions = functions;
  try {
    parse(graph, text, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Formula) << text;
    return error.details();
  }
  ADD_FAILURE() << "parsed: " << text;
  return {};
}

/// |got - exact| in units of the last place of T at `exact` (that of the smallest normal number below it; float
/// programs flush what is smaller to 0, so there any two such numbers agree). 0 when both are the same infinity or both
/// NaN, infinite when only one of them is.
template <class T>
double ulpError(T got, double exact) {
  if (std::isnan(got) || std::isnan(exact)) return std::isnan(got) && std::isnan(exact) ? 0 : INFINITY;
  const T rounded = static_cast<T>(exact);
  if (got == rounded) return 0;
  if (std::isinf(got) || std::isinf(rounded)) return INFINITY;
  constexpr T tiny = std::numeric_limits<T>::min();
  if (sizeof(T) == sizeof(float) && std::fabs(got) <= tiny && std::fabs(rounded) <= tiny) return 0;
  const T size = std::max(std::fabs(rounded), std::numeric_limits<T>::min());
  const double ulp = static_cast<double>(std::nextafter(size, std::numeric_limits<T>::infinity()) - size);
  return std::fabs(static_cast<double>(got) - exact) / ulp;
}

}  // namespace brdf::formula
