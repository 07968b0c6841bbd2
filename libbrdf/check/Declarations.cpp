#include <brdf/check/Declarations.h>

#include <algorithm>
#include <iterator>

namespace brdf {
namespace {

constexpr char kCosines[] = "not bounded toward grazing, by its authors' choice of the power of the cosines";
constexpr char kCoefficients[] = "its free coefficients scale it";
constexpr char kCompensation[] =
    "MaterialX's shadowing is isotropic whatever the distribution: up to 8 at 89 degrees was measured; its "
    "compensation "
    "is the viewer's, so that light at 89 degrees gives up to 1.8 times itself";
constexpr char kLegacy[] = "as shipped in BRDFLab 0.8.2";

constexpr double kRelative = Declaration{}.relative, kRelativeNarrow = Declaration{}.relativeNarrow;

constexpr Declaration kDeclarations[] = {
    {"BlinnPhong", "the common normalisation (n + 8)/(8 pi) is an approximation"},
    {"Ward", kCosines},
    {"WardDuer", kCosines},
    {"Kurt", kCosines},
    {"Minnaert", kCosines},
    {"Schlick", kCosines},
    {"Disney", kCosines},
    {"OrenNayar", "a thousandth above 1 at grazing, at middling roughness: interreflection was left out"},
    {"Lafortune", kCoefficients},
    {"LafortuneNgan", kCoefficients},
    {"LowMicrofacet", kCoefficients, kRelative, kRelativeNarrow, false, 50},
    {"LowSmooth", kCoefficients},
    {"Rational", kCoefficients, kRelative, kRelativeNarrow, false, 50},
    {"MaterialXConductor", kCompensation},
    {"MaterialXDielectric", kCompensation},
    {"MaterialXSchlick", kCompensation},
    {"OpenPBR", kCompensation},
    {"Strauss", "an empirical model without a normalisation: up to 1.2 at 89 degrees was measured"},
    // Samplers of another shape than the lobe; the bounds are one and a half times the worst that was measured (12.3,
    // 96; 36 and 33 above, 42 below).
    {"SheenCharlie", nullptr, kRelative, kRelativeNarrow, false, 18},
    {"HeTorrance", nullptr, kRelative, kRelativeNarrow, false, 150},
    // The shadowing term is 1 less a power of the angle of exponent 24 and more, clamped where it passes through zero.
    {"SGD", kCoefficients, kRelative, 3e-3, true, 63},
    // 1 less a tabulated albedo, which toward the horizon tends to 1: the difference loses its digits.
    {"GGXMultiscatter", nullptr, 1e-8, 1e-3},
};
constexpr Declaration kStrict{};
// Their lobes are wider than what they are drawn from: up to 20 was measured.
constexpr Declaration kOldFiles{"BRDFLab082", kLegacy, kRelative, kRelativeNarrow, false, 30};

}  // namespace

const Declaration& declarationOf(std::string_view model) {
  const auto* const found = std::find_if(std::begin(kDeclarations), std::end(kDeclarations),
                                         [&](const Declaration& entry) { return entry.model == model; });
  if (found != std::end(kDeclarations)) return *found;
  return model.starts_with(kOldFiles.model) ? kOldFiles : kStrict;
}

}  // namespace brdf
