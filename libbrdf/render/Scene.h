#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/EnvironmentMap.h>
#include <brdf/material/Brdf.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace brdf {

using Position = std::array<double, 3>;  ///< x, y, z in the units of the scene
using Rgb = std::array<double, 3>;       ///< linear sRGB

/// Triangles with a frame at every corner. The world is right-handed with +y up (as in EnvironmentMap).
struct TriangleMesh {
  std::vector<Position> points;
  std::vector<Direction> normals;   ///< one a point, or none: then each triangle is flat
  std::vector<Direction> tangents;  ///< one a point, or none: then any direction across the normal
  std::vector<std::array<double, 2>> textureCoordinates;  ///< u, v: one a point, or none; for tangents (addTangents)
  std::vector<std::array<std::uint32_t, 3>> triangles;    ///< indices of points, counter-clockwise seen from outside
};

/// A square of the given side about the origin, facing +y, tangents along +x.
BRDF_EXPORT TriangleMesh makeSquare(double side);

/// Rotation about the origin after a uniform scale, then a shift: angles and shapes are kept.
struct BRDF_EXPORT Placement {
  double scale = 1;  ///< > 0
  std::array<Direction, 3> axes{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< where the object's x, y, z axes point: orthonormal
  Position shift{0, 0, 0};

  Direction turned(const Direction& d) const;  ///< a direction of the object in the world
  Position placed(const Position& p) const;    ///< a point of the object in the world
};
/// A turn by `degrees` about `axis` (any length but 0), counter-clockwise seen from its tip.
BRDF_EXPORT std::array<Direction, 3> rotation(const Direction& axis, double degrees);

/// A thing of one material. Without a mesh it is the sphere of radius 1 about the object's origin, exactly round, its
/// tangents around the object's y axis (towards +x where the normal is +z).
struct SceneObject {
  std::string name;
  std::shared_ptr<const TriangleMesh> mesh;
  Placement placement;
  std::size_t material = 0;  ///< index in Scene::materials
};

/// Light that comes from one place or one direction: no surface of its own, so no ray meets it.
struct SceneLight {
  enum class Kind {
    Directional,  ///< `position` is the direction towards the light; `rgb` its irradiance across the beam, W/m^2
    Point         ///< `position` is a place; `rgb` the radiant intensity, W/sr
  };
  Kind kind = Kind::Directional;
  Position position{0, 1, 0};
  Rgb rgb{1, 1, 1};
};

/// Light from far away.
struct SceneEnvironment {
  std::shared_ptr<const EnvironmentMap> map;
  double rotation = 0;  ///< degrees about +y, counter-clockwise seen from above
  double scale = 1;     ///< factor on the radiance, >= 0
};

/// What is seen where there is no object. It gives no light, the environment aside.
struct SceneBackground {
  enum class Kind {
    Environment,  ///< black where there is none
    Colour,       ///< `rgb`
    Picture,      ///< `picture`, scaled to cover the film about its middle
    Transparent   ///< nothing: the picture gets an alpha channel, by which its colours are multiplied
  };
  Kind kind = Kind::Environment;
  Rgb rgb{0, 0, 0};                      ///< radiance, W/(m^2 sr)
  std::shared_ptr<const Image> picture;  ///< radiance: 1, 3 or 4 channels (the fourth is not used)
};
/// Radiance of a colour or picture at a place on the film: x from the left, y from the top, both 0 to 1; black of the
/// other kinds. Pictures are read bilinearly between the centres of their pixels.
BRDF_EXPORT Rgb backgroundRadiance(const SceneBackground& background, double x, double y, double widthOverHeight);

struct SceneCamera {
  Position position{0, 0, 4.2};
  Position target{0, 0, 0};
  Direction up{0, 1, 0};
  double viewAngle = 30;  ///< vertical, degrees, between 0 and 180
};

/// What both renderers draw.
struct Scene {
  std::vector<BrdfPointer> materials;
  std::vector<SceneObject> objects;
  std::optional<std::size_t> ground;  ///< index of the object that the others stand on, if any: see addGround
  std::vector<SceneLight> lights;
  std::optional<SceneEnvironment> environment;
  SceneBackground background;
  SceneCamera camera;
  std::size_t width = 512, height = 512;  ///< of the film, pixels
};

/// A camera that sees a sphere about `target` of the given radius up to a margin of 8 %, standing towards +z turned by
/// `azimuth` about +y (counter-clockwise seen from above) and raised by `elevation`; degrees.
BRDF_EXPORT SceneCamera cameraAround(const Position& target, double radius, double azimuth, double elevation,
                                     double viewAngle, double widthOverHeight);

/// Throws Error::Kind::Value naming the first thing in the scene that cannot be: an index out of range, a number that
/// is not finite, a camera that looks nowhere, a film of more than 2^26 pixels.
BRDF_EXPORT void checkScene(const Scene& scene);

}  // namespace brdf
