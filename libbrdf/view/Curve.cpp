#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/material/CellState.h>
#include <brdf/material/SampleSet.h>
#include <brdf/material/ValueOrigins.h>
#include <brdf/view/Curve.h>
#include <brdf/view/ValueErrors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace brdf {
namespace {

constexpr double kAboveHorizon = 1e-4;  ///< radians; as LobeMesh
constexpr std::size_t kBlock = 65'536;

constexpr std::array<std::pair<std::string_view, CurveAngle>, 5> kAngles{{{"theta_o", CurveAngle::ThetaO},
                                                                          {"phi", CurveAngle::Phi},
                                                                          {"theta_h", CurveAngle::ThetaH},
                                                                          {"theta_d", CurveAngle::ThetaD},
                                                                          {"phi_d", CurveAngle::PhiD}}};

struct Ends {
  double low, high;
};
Ends endsOf(CurveAngle angle) {
  switch (angle) {
    case CurveAngle::ThetaO:
      return {-kPi / 2, kPi / 2};
    case CurveAngle::Phi:
    case CurveAngle::PhiD:
      return {-kPi, kPi};
    default:
      return {0, kPi / 2};
  }
}

void check(const CurveOptions& options) {
  const auto polar = [](double angle, const char* field) {
    if (!(angle >= 0 && angle < kPi / 2))
      throw Error(Error::Kind::Value, {"out of range", field, formatNumber(degrees(angle)), "[0, 90) degrees"});
  };
  const auto azimuth = [](double angle, const char* field) {
    if (!std::isfinite(angle))
      throw Error(Error::Kind::Value, {"out of range", field, formatNumber(angle), "a finite number of degrees"});
  };
  const bool half = options.angle != CurveAngle::ThetaO && options.angle != CurveAngle::Phi;
  if (!half) polar(options.thetaI, "theta_i");
  if (options.angle == CurveAngle::Phi) polar(options.thetaO, "theta_o");
  if (half && options.angle != CurveAngle::ThetaH) polar(options.thetaH, "theta_h");
  if (half && options.angle != CurveAngle::ThetaD) polar(options.thetaD, "theta_d");
  azimuth(options.phiI, "phi_i");
  azimuth(options.phi, "phi");
  azimuth(options.phiH, "phi_h");
  azimuth(options.phiD, "phi_d");
  if (options.intervals < 1 || options.intervals > 100'000)
    throw Error(Error::Kind::Value,
                {"out of range", "intervals", formatNumber(static_cast<double>(options.intervals)), "1 to 100000"});
}

/// The angle of the curve that belongs to a pair; of a pair that lies on it: its own.
double angleOf(const CurveOptions& options, const Direction& wi, const Direction& wo) {
  if (options.angle == CurveAngle::Phi) return std::remainder(toSpherical(wo).phi - toSpherical(wi).phi, 2 * kPi);
  if (options.angle == CurveAngle::ThetaO) {
    const Spherical viewer = toSpherical(wo);
    return std::cos(viewer.phi - options.phiI - options.phi) < 0 ? -viewer.theta : viewer.theta;
  }
  const HalfDifference angles = toHalfDifference(wi, wo);
  return options.angle == CurveAngle::ThetaH   ? angles.thetaH
         : options.angle == CurveAngle::ThetaD ? angles.thetaD
                                               : angles.phiD;
}

/// Where the curve meets the mirror or the retro direction, or comes nearest to them.
std::vector<double> peaksOf(const CurveOptions& options) {
  switch (options.angle) {
    case CurveAngle::ThetaO:
      return {-options.thetaI, options.thetaI};
    case CurveAngle::Phi:
      return {-kPi, 0, kPi};
    case CurveAngle::ThetaH:
    case CurveAngle::ThetaD:
      return {0};
    default:
      return {};
  }
}

std::vector<double> abscissas(const CurveOptions& options) {
  const auto [low, high] = endsOf(options.angle);
  std::vector<double> angles;
  for (std::size_t i = 0; i < options.intervals + (options.middles ? 0 : 1); ++i) {
    const double share =
        (static_cast<double>(i) + (options.middles ? 0.5 : 0)) / static_cast<double>(options.intervals);
    angles.push_back(low + (high - low) * share);
  }
  if (options.middles) return angles;
  const double step = (high - low) / static_cast<double>(options.intervals);
  for (const double peak : peaksOf(options)) {
    angles.push_back(peak);
    for (double offset = radians(1e-3); offset < 2 * step; offset *= std::pow(10, 0.125))
      for (const double angle : {peak - offset, peak + offset})
        if (angle > low && angle < high) angles.push_back(angle);
  }
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end(), [](double a, double b) { return b - a < 1e-9; }),
               angles.end());
  return angles;
}

/// `direction`, raised to the smallest height where it is lower by no more than that.
Direction raised(const Direction& direction) {
  if (std::abs(direction[2]) >= kAboveHorizon) return direction;
  const Spherical angles = toSpherical(direction);
  return fromSpherical(kPi / 2 - kAboveHorizon, angles.phi);
}

double angleBetween(const Direction& a, const Direction& b) {
  const Direction c = cross(a, b);
  return std::atan2(std::sqrt(dot(c, c)), dot(a, b));
}

Direction turned(const Direction& w, double phi, bool mirrored) {
  const double c = std::cos(phi), s = std::sin(phi), y = mirrored ? -w[1] : w[1];
  return {c * w[0] - s * y, s * w[0] + c * y, w[2]};
}

/// The nearest position of a sample to the curve: its angle there and its distance, over the turns and mirrorings that
/// leave an isotropic BRDF as it is.
struct Place {
  double angle = 0, distance = std::numeric_limits<double>::infinity();
};

class Locator {
 public:
  Locator(const CurveOptions& options, Symmetry symmetry) : options_(options), symmetry_(symmetry) {}

  /// Whether a pair cannot lie within `tolerance`: no direction moves farther than its own distance, so polar angles
  /// change by no more, and the angle between light and viewer, 2 theta_d, by no more than both.
  bool tooFar(const Direction& wi, const Direction& wo, double tolerance) const {
    const auto outside = [&tolerance](double cosine, double angle) {
      return cosine > std::cos(std::max(angle - tolerance, 0.0)) + 1e-12 ||
             cosine < std::cos(std::min(angle + tolerance, kPi)) - 1e-12;
    };
    if (options_.angle == CurveAngle::ThetaO) return outside(wi[2], options_.thetaI);
    if (options_.angle == CurveAngle::Phi) return outside(wi[2], options_.thetaI) || outside(wo[2], options_.thetaO);
    if (options_.angle == CurveAngle::ThetaD) return false;
    tolerance *= 2;
    return outside(dot(wi, wo), 2 * options_.thetaD);
  }

  Place locate(const Direction& wi, const Direction& wo) const {
    Place best;
    if (symmetry_ == Symmetry::Anisotropic) {
      consider(wi, wo, best);
      return best;
    }
    for (const bool mirrored : {false, true}) {
      if (mirrored && symmetry_ != Symmetry::Isotropic) break;
      const bool half = options_.angle != CurveAngle::ThetaO && options_.angle != CurveAngle::Phi;
      if (half) {
        const Direction a = turned(wi, 0, mirrored), b = turned(wo, 0, mirrored);
        const HalfDifference angles = toHalfDifference(a, b);
        turnAndConsider(a, b, options_.phiH - angles.phiH, best);
      } else {
        const Direction a = turned(wi, 0, mirrored), b = turned(wo, 0, mirrored);
        turnAndConsider(a, b, options_.phiI - toSpherical(a).phi, best);
        // At normal incidence the viewer says how the surface is turned.
        if (options_.angle == CurveAngle::ThetaO)
          for (const double side : {0.0, kPi})
            turnAndConsider(a, b, options_.phiI + options_.phi + side - toSpherical(b).phi, best);
      }
    }
    return best;
  }

 private:
  void turnAndConsider(const Direction& wi, const Direction& wo, double phi, Place& best) const {
    consider(turned(wi, phi, false), turned(wo, phi, false), best);
  }
  void consider(const Direction& wi, const Direction& wo, Place& best) const {
    const double angle = angleOf(options_, wi, wo);
    const DirectionPair pair = curveDirections(options_, angle);
    const double distance = std::max(angleBetween(pair.wi, wi), angleBetween(pair.wo, wo));
    if (distance < best.distance - 1e-9) best = {angle, distance};  // as it stands, where turning gains nothing
  }

  const CurveOptions& options_;
  Symmetry symmetry_;
};

}  // namespace

std::string_view curveAngleName(CurveAngle angle) {
  return std::find_if(kAngles.begin(), kAngles.end(), [angle](const auto& entry) { return entry.second == angle; })
      ->first;
}

CurveAngle parseCurveAngle(std::string_view name) {
  for (const auto& [known, angle] : kAngles)
    if (known == name) return angle;
  throw Error(Error::Kind::Value,
              {"unknown angle", "curve", std::string(name), "theta_o, phi, theta_h, theta_d, phi_d"});
}

std::string fixedAngles(const CurveOptions& options) {
  const bool half = options.angle != CurveAngle::ThetaO && options.angle != CurveAngle::Phi;
  std::string text;
  const auto add = [&](const char* name, double angle, bool wanted) {
    if (!wanted) return;
    text += (text.empty() ? "" : ", ") + std::string(name) + " = " + formatNumber(degrees(angle), 6) + " deg";
  };
  add("theta_i", options.thetaI, !half);
  add("phi_i", options.phiI, !half);
  add("theta_o", options.thetaO, options.angle == CurveAngle::Phi);
  add("phi", options.phi, options.angle == CurveAngle::ThetaO);
  add("theta_h", options.thetaH, half && options.angle != CurveAngle::ThetaH);
  add("theta_d", options.thetaD, half && options.angle != CurveAngle::ThetaD);
  add("phi_d", options.phiD, half && options.angle != CurveAngle::PhiD);
  add("phi_h", options.phiH, half);
  return text;
}

DirectionPair curveDirections(const CurveOptions& options, double angle) {
  switch (options.angle) {
    case CurveAngle::ThetaO:
      return {fromSpherical(options.thetaI, options.phiI), fromSpherical(angle, options.phiI + options.phi)};
    case CurveAngle::Phi:
      return {fromSpherical(options.thetaI, options.phiI), fromSpherical(options.thetaO, options.phiI + angle)};
    case CurveAngle::ThetaH:
      return fromHalfDifference({angle, options.phiH, options.thetaD, options.phiD});
    case CurveAngle::ThetaD:
      return fromHalfDifference({options.thetaH, options.phiH, angle, options.phiD});
    default:
      return fromHalfDifference({options.thetaH, options.phiH, options.thetaD, angle});
  }
}

Curve makeCurve(const Brdf& brdf, const CurveOptions& options) {
  check(options);
  Curve curve;
  curve.angle = abscissas(options);
  const std::size_t count = curve.count();
  DirectionPairBuffer<double> pairs(count);
  std::vector<std::uint8_t> below(count);
  for (std::size_t i = 0; i < count; ++i) {
    const DirectionPair pair = curveDirections(options, curve.angle[i]);
    const DirectionPair used{raised(pair.wi), raised(pair.wo)};
    below[i] = !(used.wi[2] > 0 && used.wo[2] > 0);
    pairs.set(i, used.wi, used.wo);
    curve.cosThetaO.push_back(used.wo[2]);
  }
  curve.values.resize(brdf.channels().count() * count);
  curve.states.resize(count);
  brdf.evaluateParallel(pairs.view(), curve.values.data(), curve.states.data());
  for (std::uint8_t& state : curve.states) state = stateByte(state ? CellState::Measured : CellState::Invalid);
  ValueOrigins(brdf).classify(pairs.view(), curve.states.data());
  if (const ValueErrors errors(brdf); errors.knownOfValues()) {
    curve.standardErrors.resize(curve.values.size());
    errors.ofValues(pairs.view(), curve.standardErrors.data());
  }
  for (std::size_t i = 0; i < count; ++i)
    if (below[i]) curve.states[i] = kBelowHorizon;
  return curve;
}

CurveSamples samplesByCurve(const Brdf& brdf, const CurveOptions& options, double tolerance, std::size_t maximum) {
  check(options);
  if (!(tolerance > 0))
    throw Error(Error::Kind::Value,
                {"out of range", "tolerance", formatNumber(degrees(tolerance)), "more than 0 degrees"});
  CurveSamples found;
  const SampleSet* samples = brdf.samples();
  if (!samples) return found;
  const std::size_t channels = brdf.channels().count();
  const Locator locator(options, brdf.symmetry());
  const ValueErrors errors(brdf);
  DirectionPairBuffer<double> pairs;
  std::vector<double> values(channels * kBlock);
  std::vector<std::uint8_t> valid(kBlock);
  struct Sample {
    Place place;
    std::size_t index;
    double cosThetaO;
    std::vector<double> values;
  };
  std::vector<Sample> near;
  const auto nearer = [](const Sample& a, const Sample& b) {
    return a.place.distance < b.place.distance || (a.place.distance == b.place.distance && a.index < b.index);
  };
  for (std::size_t first = 0; first < samples->count(); first += kBlock) {
    const std::size_t length = std::min(kBlock, samples->count() - first);
    samples->read(first, length, &pairs, values.data(), valid.data());
    for (std::size_t i = 0; i < length; ++i) {
      if (!valid[i]) continue;
      const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      const Direction wo{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      if (locator.tooFar(wi, wo, tolerance)) continue;
      const Place place = locator.locate(wi, wo);
      if (!(place.distance <= tolerance)) continue;
      Sample& sample = near.emplace_back(Sample{place, first + i, wo[2], std::vector<double>(channels)});
      for (std::size_t c = 0; c < channels; ++c) sample.values[c] = values[c * length + i];
    }
    if (near.size() > 2 * maximum + kBlock) {
      std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(maximum), near.end(), nearer);
      found.leftOut += near.size() - maximum;
      near.resize(maximum);
    }
  }
  std::sort(near.begin(), near.end(), nearer);
  if (near.size() > maximum) {
    found.leftOut += near.size() - maximum;
    near.resize(maximum);
  }
  const std::size_t count = near.size();
  found.values.resize(channels * count);
  if (errors.knownOfSamples()) found.standardErrors.resize(channels * count);
  for (std::size_t i = 0; i < count; ++i) {
    found.angle.push_back(near[i].place.angle);
    found.cosThetaO.push_back(near[i].cosThetaO);
    found.distance.push_back(near[i].place.distance);
    for (std::size_t c = 0; c < channels; ++c) {
      found.values[c * count + i] = near[i].values[c];
      if (errors.knownOfSamples()) found.standardErrors[c * count + i] = errors.ofSample(near[i].index, c);
    }
  }
  return found;
}

}  // namespace brdf
