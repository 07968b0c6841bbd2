#pragma once
#include <brdf/render/Scene.h>

namespace brdf {

struct Ray {
  Position origin;
  Direction direction;  ///< unit length
};

}  // namespace brdf
