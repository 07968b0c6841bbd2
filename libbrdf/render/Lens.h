#pragma once
#include <brdf/brdf_export.h>
#include <brdf/render/Ray.h>
#include <brdf/render/Scene.h>

namespace brdf {

/// Camera rays through places of the film.
class BRDF_EXPORT Lens {
 public:
  explicit Lens(const Scene& scene);

  /// Through a place in pixels from the film's upper left corner, x to the right, y down.
  Ray through(double x, double y) const;

 private:
  Position position_;
  Direction across_, down_, corner_;
};

}  // namespace brdf
