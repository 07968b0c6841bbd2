#include "vtkBRDFParametricShapes.h"

#include "vtkParametricBohemianDome.h"
#include "vtkParametricBoy.h"
#include "vtkParametricCrossCap.h"
#include "vtkParametricEllipsoid.h"
#include "vtkParametricEnneper.h"
#include "vtkParametricFigure8Klein.h"
#include "vtkParametricKlein.h"
#include "vtkParametricMobius.h"
#include "vtkParametricRandomHills.h"
#include "vtkParametricRoman.h"
#include "vtkParametricSuperEllipsoid.h"
#include "vtkParametricSuperToroid.h"
#include "vtkParametricTorus.h"
#include "vtkSmartPointer.h"

#include <brdf/render/MeshFrames.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
template<class Function>
vtkSmartPointer<vtkParametricFunction> Plain()
{
  return vtkSmartPointer<Function>::New();
}

vtkSmartPointer<vtkParametricFunction> Torus()
{
  auto torus = vtkSmartPointer<vtkParametricTorus>::New();
  torus->SetRingRadius(1);
  torus->SetCrossSectionRadius(0.45);
  return torus;
}

vtkSmartPointer<vtkParametricFunction> Ellipsoid()
{
  auto ellipsoid = vtkSmartPointer<vtkParametricEllipsoid>::New();
  ellipsoid->SetXRadius(1);
  ellipsoid->SetYRadius(0.7);
  ellipsoid->SetZRadius(0.5);
  return ellipsoid;
}

// A cube with round edges.
vtkSmartPointer<vtkParametricFunction> SuperEllipsoid()
{
  auto ellipsoid = vtkSmartPointer<vtkParametricSuperEllipsoid>::New();
  ellipsoid->SetN1(0.3);
  ellipsoid->SetN2(0.3);
  return ellipsoid;
}

vtkSmartPointer<vtkParametricFunction> SuperToroid()
{
  auto toroid = vtkSmartPointer<vtkParametricSuperToroid>::New();
  toroid->SetN1(0.4);
  toroid->SetN2(0.4);
  return toroid;
}

struct Shape
{
  const char* Name;
  vtkSmartPointer<vtkParametricFunction> (*Make)();
};

constexpr std::array<Shape, 13> Shapes{ { { "bohemian-dome", Plain<vtkParametricBohemianDome> },
                                          { "boy", Plain<vtkParametricBoy> },
                                          { "cross-cap", Plain<vtkParametricCrossCap> },
                                          { "ellipsoid", Ellipsoid },
                                          { "enneper", Plain<vtkParametricEnneper> },
                                          { "figure-8-klein", Plain<vtkParametricFigure8Klein> },
                                          { "klein", Plain<vtkParametricKlein> },
                                          { "mobius", Plain<vtkParametricMobius> },
                                          { "random-hills", Plain<vtkParametricRandomHills> },
                                          { "roman", Plain<vtkParametricRoman> },
                                          { "superellipsoid", SuperEllipsoid },
                                          { "supertoroid", SuperToroid },
                                          { "torus", Torus } } };

using brdf::Direction;

// From VTK's z up to our y up.
Direction At(vtkParametricFunction* function, double u, double v)
{
  double uvw[3] = { u, v, 0 }, point[3], derivatives[9];
  function->Evaluate(uvw, point, derivatives);
  return { point[0], point[2], -point[1] };
}

// Derivative by the first (axis 0) or second parameter: central differences of fourth order.
Direction Derivative(vtkParametricFunction* function, double u, double v, int axis)
{
  constexpr double h = 2e-3; // balances h^4 against rounding / h: errors below 1e-10 of the shape's size
  const auto at = [&](double step) { return axis == 0 ? At(function, u + step, v) : At(function, u, v + step); };
  const Direction a = at(-2 * h), b = at(-h), c = at(h), d = at(2 * h);
  Direction result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    result[k] = (a[k] - 8 * b[k] + 8 * c[k] - d[k]) / (12 * h);
  }
  return result;
}

double Length(const Direction& d)
{
  return std::sqrt(brdf::dot(d, d));
}
}

std::vector<std::string> vtkBRDFParametricShapes::Names()
{
  std::vector<std::string> names;
  for (const Shape& shape : Shapes)
  {
    names.emplace_back(shape.Name);
  }
  return names;
}

std::optional<brdf::TriangleMesh> vtkBRDFParametricShapes::Make(const std::string& name)
{
  const auto* shape =
    std::find_if(Shapes.begin(), Shapes.end(), [&](const Shape& candidate) { return name == candidate.Name; });
  if (shape == Shapes.end())
  {
    return {};
  }
  const vtkSmartPointer<vtkParametricFunction> function = shape->Make();
  constexpr std::uint32_t columns = 257, rows = 257;
  const double u0 = function->GetMinimumU(), du = (function->GetMaximumU() - u0) / (columns - 1);
  const double v0 = function->GetMinimumV(), dv = (function->GetMaximumV() - v0) / (rows - 1);
  brdf::TriangleMesh mesh;
  for (std::uint32_t row = 0; row < rows; ++row)
  {
    for (std::uint32_t column = 0; column < columns; ++column)
    {
      double u = u0 + column * du, v = v0 + row * dv;
      mesh.points.push_back(At(function, u, v));
      Direction along = Derivative(function, u, v, 0), up = Derivative(function, u, v, 1);
      Direction normal = brdf::cross(along, up);
      // Where the parameters run together (a pole) the surface is looked at a little further in.
      for (int attempt = 0;
           attempt < 4 && !(Length(normal) > 1e-6 * Length(along) * Length(up) && Length(along) > 1e-6);
           ++attempt)
      {
        const double part = 0.02 * std::pow(2.0, attempt);
        u += part * du * (2 * column < columns ? 1 : -1);
        v += part * dv * (2 * row < rows ? 1 : -1);
        along = Derivative(function, u, v, 0);
        up = Derivative(function, u, v, 1);
        normal = brdf::cross(along, up);
      }
      normal = Length(normal) > 0 ? brdf::normalized(normal) : Direction{ 0, 1, 0 };
      mesh.normals.push_back(normal);
      const double part = brdf::dot(along, normal);
      for (std::size_t k = 0; k < 3; ++k)
      {
        along[k] -= part * normal[k];
      }
      mesh.tangents.push_back(Length(along) > 0 ? brdf::normalized(along) : Direction{});
    }
  }
  for (std::uint32_t row = 0; row + 1 < rows; ++row)
  {
    for (std::uint32_t column = 0; column + 1 < columns; ++column)
    {
      const std::uint32_t a = row * columns + column, b = a + 1, c = a + columns + 1, d = a + columns;
      mesh.triangles.push_back({ a, b, c });
      mesh.triangles.push_back({ a, c, d });
    }
  }
  brdf::removeDegenerateTriangles(mesh);

  // Normals point outwards where there is an outside: away from the middle, on the whole.
  brdf::Position low, high;
  low.fill(INFINITY);
  high.fill(-INFINITY);
  for (const brdf::Position& p : mesh.points)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  double radius = 0, outwards = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      mesh.points[i][k] -= (low[k] + high[k]) / 2;
    }
    radius = std::max(radius, Length(mesh.points[i]));
    outwards += brdf::dot(mesh.points[i], mesh.normals[i]);
  }
  for (brdf::Position& p : mesh.points)
  {
    for (double& x : p)
    {
      x /= radius;
    }
  }
  if (outwards < 0)
  {
    for (Direction& n : mesh.normals)
    {
      n = { -n[0], -n[1], -n[2] };
    }
  }
  brdf::settleNormals(mesh);
  brdf::addTangents(mesh);
  return mesh;
}
