#include <brdf/base/Text.h>
#include <brdf/check/Cases.h>
#include <brdf/sampling/Sequence.h>

#include <cmath>
#include <random>

namespace brdf {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return uniform_(engine_); }
  Direction direction() {
    const double u = (*this)(), v = (*this)();
    return cosineDirection(u, v);
  }
  /// From 5 degrees above the horizon down to 1e-4, evenly in the logarithm.
  double grazingAngle() { return kPi / 2 - radians(std::pow(10.0, 0.7 - 4.7 * (*this)())); }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> uniform_;
};

/// `w` tilted by `angle` toward a random side; reflected up where that is below the horizon.
Direction tilted(const Direction& w, double angle, Random& random) {
  Direction t, b;
  orthonormalBasis(w, t, b);
  const double phi = 2 * kPi * random(), x = std::cos(phi) * std::tan(angle), y = std::sin(phi) * std::tan(angle);
  Direction result = normalized({w[0] + x * t[0] + y * b[0], w[1] + x * t[1] + y * b[1], w[2] + x * t[2] + y * b[2]});
  result[2] = std::fabs(result[2]);
  return result;
}

double between(const Parameter& p, double low, double high, double share) {
  if (share == 0) return low;
  if (share == 1) return high;
  const bool logarithmic = p.scale == Parameter::Scale::Logarithmic && low > 0;
  return logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
}

template <class Choose>
ParameterCase parameterCase(const Model& model, const std::string& name, Choose&& choose) {
  ParameterCase result{{}, name, true};
  for (const Parameter& parameter : model.parameters()) result.values.push_back(choose(parameter));
  return result;
}

}  // namespace

DirectionPairBuffer<float> CheckPairs::narrow() const {
  DirectionPairBuffer<float> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double x : pairs.wi[axis]) result.wi[axis].push_back(static_cast<float>(x));
    for (const double x : pairs.wo[axis]) result.wo[axis].push_back(static_cast<float>(x));
  }
  return result;
}

CheckPairs CheckPairs::rounded() const {
  const DirectionPairBuffer<float> floats = narrow();
  CheckPairs result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.pairs.wi[axis].assign(floats.wi[axis].begin(), floats.wi[axis].end());
    result.pairs.wo[axis].assign(floats.wo[axis].begin(), floats.wo[axis].end());
  }
  return result;
}

CheckPairs adversarialPairs(std::size_t perKind, unsigned seed, bool horizon) {
  Random random(seed);
  CheckPairs set;
  DirectionPairBuffer<double>& pairs = set.pairs;
  for (std::size_t k = 0; k < perKind; ++k) {
    const Direction wo = random.direction(), mirror{-wo[0], -wo[1], wo[2]};
    pairs.push(random.direction(), wo);
    pairs.push(mirror, wo);
    pairs.push(tilted(mirror, 0.1 * std::pow(10.0, -4 * random()), random), wo);
    pairs.push(wo, wo);
    pairs.push(tilted(wo, 1e-3 * random(), random), wo);
    const double slope = std::pow(10.0, -3 + 3 * random()), phi = 2 * kPi * random();
    const Direction h = normalized({slope * std::cos(phi), slope * std::sin(phi), 1});
    const double c = 2 * dot(wo, h);
    if (const Direction wi{c * h[0] - wo[0], c * h[1] - wo[1], c * h[2] - wo[2]}; wi[2] > 0)
      pairs.push(normalized(wi), wo);
    pairs.push(random.direction(), {0, 0, 1});
    const double azimuth = 2 * kPi * random();
    const Direction low = fromSpherical(random.grazingAngle(), azimuth);
    pairs.push(random.direction(), low);
    pairs.push(low, random.direction());
    pairs.push(fromSpherical(random.grazingAngle(), 2 * kPi * random()), low);
    pairs.push(fromSpherical(random.grazingAngle(), azimuth + kPi + 0.01 * (random() - 0.5)), low);
    pairs.push(fromSpherical(random.grazingAngle(), azimuth + 0.01 * random()), low);
  }
  pairs.push({0, 0, 1}, {0, 0, 1});
  if (!horizon) return set;
  for (const double cosine : {6.123233995736766e-17, 1e-20, 1e-30})
    for (const double phi : {0.0, 0.3, kPi}) {
      const Direction low{std::cos(phi), std::sin(phi), cosine};
      for (const Direction& other :
           {Direction{0, 0, 1}, Direction{0.6, 0, 0.8}, Direction{-low[0], -low[1], cosine}, low}) {
        pairs.push(low, other);
        pairs.push(other, low);
      }
    }
  return set;
}

std::vector<ParameterCase> softCases(const Model& model, std::size_t count, unsigned seed) {
  std::vector<ParameterCase> cases{{model.defaults(), "defaults", true}};
  if (model.parameters().empty()) return cases;
  Random random(seed);
  cases.push_back(parameterCase(model, "soft minima", [](const Parameter& p) { return p.softMinimum; }));
  cases.push_back(parameterCase(model, "soft maxima", [](const Parameter& p) { return p.softMaximum; }));
  for (std::size_t k = 0; k < count; ++k)
    cases.push_back(parameterCase(model, "inside the soft bounds", [&](const Parameter& p) {
      return between(p, p.softMinimum, p.softMaximum, random());
    }));
  return cases;
}

std::vector<ParameterCase> hardCases(const Model& model, std::size_t count, unsigned seed) {
  std::vector<ParameterCase> cases;
  if (model.parameters().empty()) return cases;
  Random random(seed);
  cases.push_back(parameterCase(model, "hard minima", [](const Parameter& p) { return p.minimum; }));
  cases.push_back(parameterCase(model, "hard maxima", [](const Parameter& p) { return p.maximum; }));
  for (std::size_t k = 0; k < count; ++k)
    cases.push_back(parameterCase(model, "hard corner",
                                  [&](const Parameter& p) { return random() < 0.5 ? p.minimum : p.maximum; }));
  for (std::size_t which = 0; which < model.parameters().size(); ++which)
    for (const bool upper : {false, true}) {
      const Parameter& p = model.parameters()[which];
      cases.push_back({model.defaults(), p.name + (upper ? " at its maximum" : " at its minimum"), false});
      cases.back().values[which] = upper ? p.maximum : p.minimum;
    }
  for (ParameterCase& one : cases) one.soft = false;
  return cases;
}

std::string parameterText(const Model& model, const std::vector<double>& values) {
  std::string text = model.name();
  for (std::size_t k = 0; k < values.size(); ++k)
    text += (k == 0 ? "(" : ", ") + model.parameters()[k].name + "=" + formatNumber(values[k], 6);
  return values.empty() ? text : text + ")";
}

std::string directionText(const Direction& wi, const Direction& wo) {
  const Spherical i = toSpherical(wi), o = toSpherical(wo);
  const auto angle = [](double value) { return formatNumber(degrees(value), 9); };
  return "theta_i " + angle(i.theta) + " phi_i " + angle(i.phi) + " theta_o " + angle(o.theta) + " phi_o " +
         angle(o.phi) + " deg";
}

}  // namespace brdf
