#include <brdf/simulate/surfaces/BuiltInSurfaces.h>

namespace brdf {

SurfaceKind flatSurface() {
  return {"flat",
          "flat plane",
          "The plane z = 0: of mirror facets its reflection is a specular component, of Lambertian ones a constant.",
          {lengthParameter("period", "period", 1, "side of the square tile")},
          {},
          {},
          [](const SurfaceArguments& arguments, const SurfaceReaders&) {
            MadeSurface made;
            const double spacing = arguments.number("period") / 2;
            made.surface.shape = HeightField{2, 2, spacing, spacing, std::vector<float>(4, 0.0F)};
            return made;
          }};
}

}  // namespace brdf
