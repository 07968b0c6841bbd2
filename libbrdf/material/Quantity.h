#pragma once
#include <string_view>

namespace brdf {

/// What a measured number means before it is made f_r in 1/sr.
enum class Quantity {
  Brdf,              ///< f_r, 1/sr
  BrdfCosine,        ///< f_r cos(theta_o), 1/sr: also called DSF, or cosine-corrected BSDF
  ReflectanceFactor  ///< pi f_r, 1: a white Lambertian is 1 (E. Nicodemus et al. 1977, NBS Monograph 160, section III)
};

/// What a number of this quantity is multiplied by to become f_r; cosThetaO is the viewer's, positive.
constexpr double toBrdfFactor(Quantity quantity, double cosThetaO) {
  switch (quantity) {
    case Quantity::BrdfCosine:
      return 1 / cosThetaO;
    case Quantity::ReflectanceFactor:
      return 0.31830988618379067154;  // 1/pi
    default:
      return 1;
  }
}

}  // namespace brdf
