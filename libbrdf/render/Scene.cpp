#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/render/Scene.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

bool finite(const std::array<double, 3>& v) {
  return std::ranges::all_of(v, [](double x) { return std::isfinite(x); });
}

void require(bool holds, const char* what, std::string where, std::string found, const char* allowed) {
  if (!holds) throw Error(Error::Kind::Value, {what, std::move(where), std::move(found), allowed});
}

void checkMesh(const TriangleMesh& mesh, const std::string& where) {
  require(!mesh.triangles.empty(), "a mesh without triangles", where, "", "");
  for (const auto* corners : {&mesh.normals, &mesh.tangents})
    require(corners->empty() || corners->size() == mesh.points.size(), "normals or tangents do not fit the points",
            where, std::to_string(corners->size()), "one for each point, or none");
  require(mesh.textureCoordinates.empty() || mesh.textureCoordinates.size() == mesh.points.size(),
          "texture coordinates do not fit the points", where, std::to_string(mesh.textureCoordinates.size()),
          "one for each point, or none");
  for (const Position& p : mesh.points) require(finite(p), "a point is not finite", where, "", "");
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      require(corner < mesh.points.size(), "a triangle's corner is no point", where, std::to_string(corner), "");
}

}  // namespace

TriangleMesh makeSquare(double side) {
  const double h = side / 2;
  TriangleMesh mesh;
  mesh.points = {{-h, 0, h}, {h, 0, h}, {h, 0, -h}, {-h, 0, -h}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.tangents.assign(4, {1, 0, 0});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Direction Placement::turned(const Direction& d) const {
  Direction world{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) world[axis] += d[k] * axes[k][axis];
  return world;
}

Position Placement::placed(const Position& p) const {
  const Direction t = turned(p);
  return {scale * t[0] + shift[0], scale * t[1] + shift[1], scale * t[2] + shift[2]};
}

std::array<Direction, 3> rotation(const Direction& axis, double degrees) {
  const Direction n = normalized(axis);
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  std::array<Direction, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (Direction& a : axes) {  // Rodrigues' formula
    const Direction across = cross(n, a);
    const double along = dot(n, a) * (1 - c);
    for (std::size_t k = 0; k < 3; ++k) a[k] = a[k] * c + across[k] * s + n[k] * along;
  }
  return axes;
}

Rgb backgroundRadiance(const SceneBackground& background, double x, double y, double widthOverHeight) {
  if (background.kind == SceneBackground::Kind::Colour) return background.rgb;
  if (background.kind != SceneBackground::Kind::Picture) return {};
  const Image& picture = *background.picture;
  const double w = double(picture.width), h = double(picture.height), film = widthOverHeight * h / w;
  // The part of the picture that the film shows: all of its width, or all of its height.
  const double u = w * (0.5 + (x - 0.5) * std::min(1.0, film)), v = h * (0.5 + (y - 0.5) / std::max(1.0, film));
  const double left = std::clamp(u - 0.5, 0.0, w - 1), top = std::clamp(v - 0.5, 0.0, h - 1);
  const auto x0 = static_cast<std::size_t>(left), y0 = static_cast<std::size_t>(top);
  const std::size_t x1 = std::min(x0 + 1, picture.width - 1), y1 = std::min(y0 + 1, picture.height - 1);
  const double s = left - double(x0), t = top - double(y0);
  Rgb rgb;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto at = [&](std::size_t column, std::size_t row) {
      return double(picture.pixel(column, row)[picture.channels == 1 ? 0 : c]);
    };
    rgb[c] = (1 - t) * ((1 - s) * at(x0, y0) + s * at(x1, y0)) + t * ((1 - s) * at(x0, y1) + s * at(x1, y1));
  }
  return rgb;
}

SceneCamera cameraAround(const Position& target, double radius, double azimuth, double elevation, double viewAngle,
                         double widthOverHeight) {
  const double vertical = radians(viewAngle) / 2;
  const double narrow = std::min(vertical, std::atan(std::tan(vertical) * widthOverHeight));
  const double distance = 1.08 * radius / std::sin(narrow);
  const double a = radians(azimuth), e = radians(elevation);
  SceneCamera camera;
  camera.position = {target[0] + distance * std::cos(e) * std::sin(a), target[1] + distance * std::sin(e),
                     target[2] + distance * std::cos(e) * std::cos(a)};
  camera.target = target;
  camera.viewAngle = viewAngle;
  return camera;
}

void checkScene(const Scene& scene) {
  constexpr std::size_t kMaximumPixels = std::size_t{1} << 26;
  require(scene.width > 0 && scene.height > 0 && scene.width <= kMaximumPixels / scene.height,
          "the film's size is not usable", "film", std::to_string(scene.width) + " x " + std::to_string(scene.height),
          "1 to 2^26 pixels in all");
  const SceneCamera& camera = scene.camera;
  require(finite(camera.position) && finite(camera.target) && finite(camera.up), "not finite", "camera", "", "");
  Direction forward;
  for (std::size_t k = 0; k < 3; ++k) forward[k] = camera.target[k] - camera.position[k];
  require(dot(forward, forward) > 0, "the camera stands at its target", "camera", "", "");
  const Direction side = cross(normalized(forward), normalized(camera.up));
  require(dot(side, side) > 1e-12, "the camera's up lies along its view", "camera", "", "");
  require(camera.viewAngle > 0 && camera.viewAngle < 180, "angle of view out of range", "camera",
          formatNumber(camera.viewAngle), "above 0 and below 180 degrees");
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const SceneObject& object = scene.objects[k];
    const std::string where = object.name.empty() ? "object " + std::to_string(k) : "object '" + object.name + "'";
    require(object.material < scene.materials.size() && scene.materials[object.material], "no such material", where,
            std::to_string(object.material), "");
    const Placement& at = object.placement;
    require(std::isfinite(at.scale) && at.scale > 0, "scale out of range", where, formatNumber(at.scale), "above 0");
    require(finite(at.shift) && finite(at.axes[0]) && finite(at.axes[1]) && finite(at.axes[2]), "not finite", where, "",
            "");
    if (object.mesh) checkMesh(*object.mesh, where);
  }
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const SceneLight& light = scene.lights[k];
    const std::string where = "light " + std::to_string(k);
    require(finite(light.position) && finite(light.rgb), "not finite", where, "", "");
    require(std::ranges::all_of(light.rgb, [](double v) { return v >= 0; }), "negative light", where, "", "0 or more");
    require(light.kind == SceneLight::Kind::Point || dot(light.position, light.position) > 0, "no direction", where,
            "0, 0, 0", "");
  }
  if (scene.environment) {
    require(scene.environment->map != nullptr, "no map", "environment", "", "");
    require(std::isfinite(scene.environment->rotation), "rotation is not finite", "environment", "", "");
    require(std::isfinite(scene.environment->scale) && scene.environment->scale >= 0, "scale out of range",
            "environment", formatNumber(scene.environment->scale), "0 or more");
  }
  const SceneBackground& background = scene.background;
  require(finite(background.rgb), "not finite", "background", "", "");
  require(background.kind != SceneBackground::Kind::Picture ||
              (background.picture && background.picture->width > 0 && background.picture->height > 0 &&
               background.picture->channels > 0),
          "no picture", "background", "", "");
}

}  // namespace brdf
