#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>
#include <brdf/simulate/surfaces/BuiltInSurfaces.h>

#include <algorithm>

namespace brdf {
namespace {

double valueOf(const float* pixel, std::size_t channels, const std::string& choice) {
  if (choice == "red" || channels == 1) return pixel[0];
  if (choice == "green") return pixel[1];
  if (choice == "blue") return pixel[2];
  if (choice == "alpha") return pixel[3];
  return 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
}

MadeSurface makeHeightField(const SurfaceArguments& arguments, const SurfaceReaders& readers) {
  const std::filesystem::path path = arguments.text("file");
  const Image image = readers.picture ? readers.picture(path) : readImage(path);
  const std::string& channel = arguments.text("channel");
  if (channel == "alpha" && image.channels < 4)
    throw Error(Error::Kind::Value, {"the picture has no alpha", arguments.where() + ", channel", path.string(),
                                     "luminance, red, green, blue"});
  const bool mirrored = arguments.text("edges") == "mirrored";
  const double depth = arguments.number("depth"), spacing = arguments.number("spacing");
  const std::size_t width = image.width, height = image.height;
  HeightField field{mirrored ? 2 * width : width, mirrored ? 2 * height : height, spacing, spacing, {}};
  if (field.columns > (std::size_t{1} << 28) / std::max<std::size_t>(field.rows, 1))
    throw Error(Error::Kind::Value,
                {"too many nodes", arguments.where(),
                 std::to_string(field.columns) + " x " + std::to_string(field.rows), "2^28 in all"});
  field.heights.reserve(field.columns * field.rows);
  for (std::size_t j = 0; j < field.rows; ++j) {
    // Pictures begin at the top, +y is up.
    const std::size_t row = j < height ? height - 1 - j : j - height;
    for (std::size_t i = 0; i < field.columns; ++i) {
      const std::size_t column = i < width ? i : 2 * width - 1 - i;
      field.heights.push_back(static_cast<float>(depth * valueOf(image.pixel(column, row), image.channels, channel)));
    }
  }
  MadeSurface made;
  made.surface.shape = std::move(field);
  return made;
}

MadeSurface makeMesh(const SurfaceArguments& arguments, const SurfaceReaders& readers) {
  if (!readers.mesh)
    throw Error(Error::Kind::Value, {"no reader of meshes here", arguments.where() + ", file", arguments.text("file"),
                                     "a program built with VTK"});
  TiledMesh mesh = readers.mesh(arguments.text("file"));
  const double scale = arguments.number("scale");
  const bool yUp = arguments.text("up") == "y";
  for (auto& point : mesh.points) {
    if (yUp) point = {point[0], -point[2], point[1]};
    for (float& x : point) x = static_cast<float>(x * scale);
  }
  mesh.periodX = arguments.number("period_x");
  mesh.periodY = arguments.number("period_y");
  setMissingPeriods(mesh, arguments.where());
  MadeSurface made;
  made.surface.shape = std::move(mesh);
  return made;
}

}  // namespace

SurfaceKind heightFieldSurface() {
  return {
      "heightfield",
      "height field of a picture",
      "Every pixel is a node: its value times the depth is the height. The picture's top is at the highest y. The "
      "tile repeats: a picture that does not fit its own edges gets steps there, unless it is mirrored.",
      {lengthParameter("depth", "depth", 1, "height of the value 1 over the value 0; negative turns hills to pits",
                       -1e6),
       lengthParameter("spacing", "spacing", 1, "from pixel to pixel")},
      {{"file", "file", "picture of heights: OpenEXR, Radiance .hdr, and with VTK PNG, JPEG, TIFF and BMP", {}, true},
       {"channel", "channel", "what of a coloured pixel is the height", {"luminance", "red", "green", "blue", "alpha"}},
       {"edges",
        "edges",
        "repeat the picture as it is, or mirrored at its edges along both axes",
        {"repeated", "mirrored"}}},
      {},
      makeHeightField};
}

SurfaceKind meshSurface() {
  return {"mesh",
          "mesh of triangles",
          "Triangles from a file, repeated with the periods; their outer sides are counter-clockwise.",
          {numberParameter("scale", "scale", 1, 1e-9, 1e9, "micrometres a unit of the file"),
           lengthParameter("period_x", "period along x", 0, "0: the extent of the mesh", 0),
           lengthParameter("period_y", "period along y", 0, "0: the extent of the mesh", 0)},
          {{"file", "file", "mesh: .ply, .obj, .stl, .vtp, .gltf, .glb", {}, true},
           {"up", "up", "which axis of the file is outwards; y becomes z, and z becomes -y", {"z", "y"}}},
          {},
          makeMesh};
}

}  // namespace brdf
