#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace brdf::formula {

/// A precomputed function of one or two variables on a uniform grid, interpolated linearly, constant beyond its ends.
/// ny = 1 makes it a function of x alone.
struct Table {
  std::string name;  ///< an identifier: what formulas call it, and its name in GLSL
  std::size_t nx = 2, ny = 1;
  double x0 = 0, x1 = 1;       ///< x of the first and the last column
  double y0 = 0, y1 = 1;       ///< y of the first and the last row
  std::vector<double> values;  ///< nx * ny numbers, x fastest

  enum class Part { Value, Dx, Dy };

  /// The interpolant or its slope (0 beyond the ends), in the arithmetic of T.
  template <class T>
  T at(Part part, const T& x, const T& y) const {
    const Place<T> px = place(x, T(x0), T(x1), nx), py = place(y, T(y0), T(y1), ny);
    const auto row = [&](std::size_t j) {
      const T a = T(values[j * nx + px.cell]), b = T(values[j * nx + px.cell + 1]);
      return part == Part::Dx ? T((b - a) * px.slope) : T(a + (b - a) * px.weight);
    };
    if (ny == 1) return part == Part::Dy ? T(0) : row(0);
    const T low = row(py.cell), high = row(py.cell + 1);
    return part == Part::Dy ? T((high - low) * py.slope) : T(low + (high - low) * py.weight);
  }

 private:
  template <class T>
  struct Place {
    std::size_t cell = 0;
    T weight = 0, slope = 0;
  };
  template <class T>
  static Place<T> place(const T& x, const T& first, const T& last, std::size_t count) {
    if (count < 2) return {};
    Place<T> result;
    const T scale = T(static_cast<double>(count - 1)) / (last - first);
    const T at = (x - first) * scale;
    if (!(at > 0)) return result;
    if (at >= T(static_cast<double>(count - 1))) return {count - 2, T(1), T(0)};
    result.cell = static_cast<std::size_t>(at);
    result.weight = at - T(static_cast<double>(result.cell));
    result.slope = scale;
    return result;
  }
};

}  // namespace brdf::formula
