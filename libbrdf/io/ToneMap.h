#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/Image.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace brdf {

/// How linear colour becomes a picture for a screen.
enum class ToneCurve {
  Clamp,     ///< linear up to 1, then cut: what is below 1 stays true
  Reinhard,  ///< x / (1 + x) a channel (Reinhard et al. 2002, equation 3)
  Aces       ///< rational fit of the ACES film curve by Narkowicz 2015 ("ACES Filmic Tone Mapping Curve")
};

/// The curve called "clamp", "reinhard" or "aces". Throws Error::Kind::Value.
BRDF_EXPORT ToneCurve toneCurve(std::string_view name);

/// sRGB transfer function (IEC 61966-2-1) of a linear value, cut to [0, 1].
BRDF_EXPORT double srgbEncoded(double linear);

/// Pixels for a screen, as many channels as the picture has: values times 2^exposure, through the curve, sRGB-encoded
/// to 8 bits. Alpha (the fourth channel) is only scaled. NaN becomes 0.
BRDF_EXPORT std::vector<std::uint8_t> toneMapped(const Image& image, double exposure, ToneCurve curve);

}  // namespace brdf
