#include <brdf/render/Shapes.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

using Place = std::array<double, 2>;

constexpr std::array<ShapeName, 6> kShapes{{
    {"cone", "of height 2 and radius 1, with its base"},
    {"cube", "of side 2"},
    {"cylinder", "of height 2 and radius 1, with its ends"},
    {"plane", "a square of side 2 facing +z, tangents along +x"},
    {"preview", "a ball with a groove on a round foot: flat, convex and concave parts"},
    {"square", "of side 1, facing +y, tangents along +x"},
}};

/// Of a piece at t from 0 to 1: where it is, and the unit normal, to the right of the way.
void along(const ProfilePiece& piece, double t, Place& place, Place& normal) {
  if (!piece.centre) {
    const double dr = piece.to[0] - piece.from[0], dy = piece.to[1] - piece.from[1], length = std::hypot(dr, dy);
    place = {piece.from[0] + t * dr, piece.from[1] + t * dy};
    normal = {dy / length, -dr / length};
    return;
  }
  const auto angle = [&](const Place& p) { return std::atan2(p[1] - (*piece.centre)[1], p[0] - (*piece.centre)[0]); };
  const double start = angle(piece.from), sign = piece.counterClockwise ? 1 : -1;
  double turn = sign * (angle(piece.to) - start);
  if (turn < 0) turn += 2 * kPi;
  const double a = start + sign * t * turn;
  const double radius = std::hypot(piece.from[0] - (*piece.centre)[0], piece.from[1] - (*piece.centre)[1]);
  place = {std::max(0.0, (*piece.centre)[0] + radius * std::cos(a)), (*piece.centre)[1] + radius * std::sin(a)};
  normal = {sign * std::cos(a), sign * std::sin(a)};
}

TriangleMesh makeCube() {
  TriangleMesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Direction n{}, t{}, b{};
      n[axis] = side;
      t[axis == 0 ? 2 : 0] = axis == 0 ? -side : axis == 2 ? side : 1;  // around the vertical; +x on top and bottom
      b = cross(n, t);
      const auto first = static_cast<std::uint32_t>(mesh.points.size());
      for (const auto& [u, v] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        Position p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = n[k] + u * t[k] + v * b[k];
        mesh.points.push_back(p);
        mesh.normals.push_back(n);
        mesh.tangents.push_back(t);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
  return mesh;
}

TriangleMesh makePlane() {
  TriangleMesh mesh;
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.tangents.assign(4, {1, 0, 0});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A ball of radius 0.7 with a groove of radius 0.12 around it at 35 degrees above its middle, on a foot.
std::vector<ProfilePiece> previewProfile() {
  constexpr double ball = 0.7, middle = 0.3, groove = 0.12;
  const double latitude = radians(35), half = 2 * std::asin(groove / (2 * ball));
  const auto onBall = [&](double a) { return Place{ball * std::cos(a), middle + ball * std::sin(a)}; };
  const double neck = -std::acos(0.3 / ball);  // the latitude at which the stem of radius 0.3 meets the ball
  const Place low = onBall(latitude - half), high = onBall(latitude + half), stem = onBall(neck);
  return {
      {{0, -1}, {0.76, -1}},
      {{0.76, -1}, {0.76, -0.88}, Place{0.76, -0.94}},
      {{0.76, -0.88}, {0.6, -0.88}},
      {{0.6, -0.88}, {0.3, -0.58}, Place{0.6, -0.58}, false},  // the foot runs into the stem
      {{0.3, -0.58}, stem},
      {stem, low, Place{0, middle}},
      {low, high, onBall(latitude), false},
      {high, {0, middle + ball}, Place{0, middle}},
  };
}

}  // namespace

TriangleMesh makeLathed(std::span<const ProfilePiece> profile, std::size_t around) {
  constexpr double step = 2 * kPi / 256;  // of the normal along an arc
  TriangleMesh mesh;
  for (const ProfilePiece& piece : profile) {
    Place place, normal, end;
    along(piece, 0, place, normal);
    std::size_t steps = 1;
    if (piece.centre) {
      const double radius = std::hypot(piece.from[0] - (*piece.centre)[0], piece.from[1] - (*piece.centre)[1]);
      double length = 0;
      for (int k = 0; k <= 64; ++k) {
        along(piece, k / 64.0, end, normal);
        length += std::hypot(end[0] - place[0], end[1] - place[1]);
        place = end;
      }
      steps = static_cast<std::size_t>(std::ceil(length / radius / step));
    }
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (std::size_t i = 0; i <= steps; ++i) {
      along(piece, double(i) / double(steps), place, normal);
      for (std::size_t j = 0; j <= around; ++j) {  // the seam has its points twice
        const double phi = 2 * kPi * double(j % around) / double(around), s = std::sin(phi), c = std::cos(phi);
        mesh.points.push_back({place[0] * s, place[1], place[0] * c});
        mesh.normals.push_back({normal[0] * s, normal[1], normal[0] * c});
        mesh.tangents.push_back({c, 0, -s});
      }
    }
    const auto row = static_cast<std::uint32_t>(around + 1);
    for (std::uint32_t i = 0; i < steps; ++i)
      for (std::uint32_t j = 0; j < around; ++j) {
        const std::uint32_t a = first + i * row + j;
        const auto onAxis = [&](std::uint32_t k) { return std::hypot(mesh.points[k][0], mesh.points[k][2]) < 1e-12; };
        if (!onAxis(a)) mesh.triangles.push_back({a, a + 1, a + row + 1});
        if (!onAxis(a + row)) mesh.triangles.push_back({a, a + row + 1, a + row});
      }
  }
  return mesh;
}

std::optional<TriangleMesh> makeShape(std::string_view name) {
  constexpr std::size_t around = 256;
  if (name == "square") return makeSquare(1);
  if (name == "plane") return makePlane();
  if (name == "cube") return makeCube();
  if (name == "cylinder")
    return makeLathed(std::vector<ProfilePiece>{{{0, -1}, {1, -1}}, {{1, -1}, {1, 1}}, {{1, 1}, {0, 1}}}, around);
  if (name == "cone") return makeLathed(std::vector<ProfilePiece>{{{0, -1}, {1, -1}}, {{1, -1}, {0, 1}}}, around);
  if (name == "preview") return makeLathed(previewProfile(), around);
  return {};
}

std::span<const ShapeName> shapeNames() { return kShapes; }

}  // namespace brdf
