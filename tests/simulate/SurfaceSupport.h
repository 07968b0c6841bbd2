#pragma once
#include <brdf/simulate/SurfaceKinds.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

inline HeightField heightField(std::string_view expression) {
  return std::get<HeightField>(makeSurface(expression).surface.shape);
}

inline double factOf(const MadeSurface& made, std::string_view name) {
  for (const SurfaceFact& fact : made.facts)
    if (fact.name == name) return fact.value;
  ADD_FAILURE() << "no fact " << name;
  return NAN;
}

/// The surface of two triangles a cell, repeated (HeightField.h).
inline double heightAt(const HeightField& field, double x, double y) {
  const double u = (x / field.periodX() - std::floor(x / field.periodX())) * static_cast<double>(field.columns);
  const double v = (y / field.periodY() - std::floor(y / field.periodY())) * static_cast<double>(field.rows);
  const auto i = static_cast<std::size_t>(u) % field.columns, j = static_cast<std::size_t>(v) % field.rows;
  const double s = u - std::floor(u), t = v - std::floor(v);
  const auto at = [&](std::size_t a, std::size_t b) {
    return static_cast<double>(field.height((i + a) % field.columns, (j + b) % field.rows));
  };
  return s >= t ? at(0, 0) + s * (at(1, 0) - at(0, 0)) + t * (at(1, 1) - at(1, 0))
                : at(0, 0) + t * (at(0, 1) - at(0, 0)) + s * (at(1, 1) - at(0, 1));
}

/// What a surface's error says, or "none".
inline std::string surfaceError(std::string_view expression, const SurfaceReaders& readers = {}) {
  try {
    makeSurface(expression, readers);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

/// Of independent draws: how many standard errors their mean is from `expected`.
inline double deviation(const std::vector<double>& draws, double expected) {
  const auto count = static_cast<double>(draws.size());
  double mean = 0, squares = 0;
  for (const double x : draws) mean += x / count;
  for (const double x : draws) squares += (x - mean) * (x - mean);
  return (mean - expected) / std::sqrt(squares / (count - 1) / count);
}

}  // namespace brdf
