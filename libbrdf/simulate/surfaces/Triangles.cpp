#include <brdf/simulate/SurfaceRandom.h>
#include <brdf/simulate/surfaces/BuiltInSurfaces.h>

namespace brdf {
namespace {

/// The digits of `index` in base 2, mirrored at the point (van der Corput).
double radicalInverse(std::size_t index) {
  double value = 0, digit = 0.5;
  for (; index > 0; index >>= 1, digit /= 2)
    if (index & 1) value += digit;
  return value;
}

MadeSurface make(const SurfaceArguments& arguments, const SurfaceReaders&) {
  const std::size_t grid = arguments.whole("grid");
  const double scale = arguments.number("scale"), spacing = arguments.number("spacing");
  const std::string& distribution = arguments.text("distribution");
  SurfaceRandom random(arguments.whole("seed"));
  HeightField field{grid, grid, spacing, spacing, {}};
  for (std::size_t k = 0; k < grid * grid; ++k) {
    double height = 0;
    if (distribution == "gaussian") height = random.normal();
    if (distribution == "random") height = random.uniform();
    if (distribution == "radical_inverse") height = radicalInverse(k);
    field.heights.push_back(static_cast<float>(scale * height));
  }
  MadeSurface made;
  made.surface.shape = std::move(field);
  return made;
}

}  // namespace

SurfaceKind triangleSurface() {
  return {"triangles",
          "grid of triangles",
          "A square grid whose nodes have independent heights, two triangles a cell.",
          {numberParameter("grid", "grid", 21, 2, 2000, "nodes along each axis"),
           lengthParameter("scale", "scale", 0.1, "what the heights are multiplied by", 0),
           lengthParameter("spacing", "spacing", 1, "between nodes"), seedParameter()},
          {{"distribution",
            "distribution",
            "heights before scaling: standard normal, uniform in [0, 1), the radical inverse in base 2 of the node's "
            "number (van der Corput), or 0",
            {"gaussian", "random", "radical_inverse", "flat"}}},
          {},
          make};
}

}  // namespace brdf
