#include "ModelKit.h"

#include <brdf/base/Text.h>
#include <brdf/models/FormulaModel.h>

#include <cmath>
#include <map>

namespace brdf::test {
namespace {

double uniform(std::mt19937_64& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

/// Tilts `w` by about `angle` in a random direction; mirrored up when it falls below the horizon.
Direction tilted(const Direction& w, double angle, std::mt19937_64& random) {
  Direction t, b;
  orthonormalBasis(w, t, b);
  const double phi = 2 * kPi * uniform(random), c = std::cos(phi) * std::tan(angle),
               s = std::sin(phi) * std::tan(angle);
  Direction result = normalized({w[0] + c * t[0] + s * b[0], w[1] + c * t[1] + s * b[1], w[2] + c * t[2] + s * b[2]});
  result[2] = std::fabs(result[2]);
  return result;
}

double between(const Parameter& p, double low, double high, double share) {
  const bool logarithmic = p.scale == Parameter::Scale::Logarithmic && low > 0;
  return logarithmic ? std::exp(std::log(low) + share * (std::log(high) - std::log(low))) : low + share * (high - low);
}

}  // namespace

void PairSet::add(const Direction& wi, const Direction& wo, const char* kind) {
  pairs.push(wi, wo);
  kinds.push_back(kind);
}

DirectionPairBuffer<float> PairSet::narrow() const {
  DirectionPairBuffer<float> result(size());
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < size(); ++k) {
      result.wi[axis][k] = static_cast<float>(pairs.wi[axis][k]);
      result.wo[axis][k] = static_cast<float>(pairs.wo[axis][k]);
    }
  return result;
}

PairSet PairSet::rounded() const {
  PairSet result = *this;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < size(); ++k) {
      result.pairs.wi[axis][k] = static_cast<float>(pairs.wi[axis][k]);
      result.pairs.wo[axis][k] = static_cast<float>(pairs.wo[axis][k]);
    }
  return result;
}

Direction cosineDistributed(std::mt19937_64& random) {
  const double u = uniform(random), phi = 2 * kPi * uniform(random);
  return {std::sqrt(u) * std::cos(phi), std::sqrt(u) * std::sin(phi), std::sqrt(1 - u)};
}

Direction mirrored(const Direction& wo, const Direction& h) {
  const double c = 2 * dot(wo, h) / dot(h, h);
  return {c * h[0] - wo[0], c * h[1] - wo[1], c * h[2] - wo[2]};
}

PairSet makePairs(std::size_t perKind, unsigned seed, bool belowDouble) {
  std::mt19937_64 random(seed);
  PairSet set;
  for (std::size_t k = 0; k < perKind; ++k) {
    const Direction wo = cosineDistributed(random), mirror{-wo[0], -wo[1], wo[2]};
    set.add(cosineDistributed(random), wo, "random");
    set.add(tilted(mirror, 0.1 * std::pow(10.0, -4 * uniform(random)), random), wo, "near mirror");
    set.add(mirror, wo, "mirror");
    set.add(wo, wo, "retro");
    set.add(tilted(wo, 1e-3 * uniform(random), random), wo, "near retro");
    const double slope = std::pow(10.0, -3 + 3 * uniform(random)), phi = 2 * kPi * uniform(random);
    const Direction wi = mirrored(wo, {slope * std::cos(phi), slope * std::sin(phi), 1});
    if (wi[2] > 0) set.add(normalized(wi), wo, "half vector");
    set.add(cosineDistributed(random), {0, 0, 1}, "normal");
    // 90 degrees less 5 to 1e-4 degrees, on one side or both, at any azimuth or nearly opposite.
    const auto grazing = [&] { return kPi / 2 - radians(std::pow(10.0, 0.7 - 4.7 * uniform(random))); };
    const double azimuth = 2 * kPi * uniform(random);
    const Direction low = fromSpherical(grazing(), azimuth);
    set.add(cosineDistributed(random), low, "grazing view");
    set.add(low, cosineDistributed(random), "grazing light");
    set.add(fromSpherical(grazing(), 2 * kPi * uniform(random)), low, "both grazing");
    set.add(fromSpherical(grazing(), azimuth + kPi + 0.01 * (uniform(random) - 0.5)), low, "both grazing, near mirror");
    set.add(fromSpherical(grazing(), azimuth + 0.01 * uniform(random)), low, "both grazing, near retro");
  }
  set.add({0, 0, 1}, {0, 0, 1}, "both normal");
  if (!belowDouble) return set;
  for (const double cosine : {6.123233995736766e-17, 1e-20, 1e-30})
    for (const double phi : {0.0, 0.3, 1.7, kPi}) {
      const Direction horizon{std::cos(phi), std::sin(phi), cosine};
      for (const Direction& other :
           {Direction{0, 0, 1}, Direction{0.6, 0, 0.8}, Direction{0, -1, cosine},
            Direction{-std::cos(phi), -std::sin(phi), cosine}, horizon, Direction{1, 0, 1e-3}}) {
        set.add(horizon, other, "light on the horizon");
        set.add(other, horizon, "view on the horizon");
      }
    }
  return set;
}

ParameterSet defaults(const Model& model) { return {model.defaults(), "defaults"}; }

std::vector<ParameterSet> softSets(const Model& model, std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<ParameterSet> sets;
  if (model.parameters().empty()) return sets;
  const auto add = [&](const std::string& name, auto share) {
    ParameterSet set{{}, name};
    for (const Parameter& p : model.parameters())
      set.values.push_back(between(p, p.softMinimum, p.softMaximum, share()));
    sets.push_back(std::move(set));
  };
  add("soft minima", [] { return 0.0; });
  add("soft maxima", [] { return 1.0; });
  for (std::size_t k = 0; k < count; ++k) add("soft corner", [&] { return std::round(uniform(random)); });
  for (std::size_t k = 0; k < count; ++k) add("inside soft bounds", [&] { return uniform(random); });
  return sets;
}

std::vector<ParameterSet> hardSets(const Model& model, std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<ParameterSet> sets;
  if (model.parameters().empty()) return sets;
  const auto add = [&](const std::string& name, auto upper) {
    ParameterSet set{{}, name};
    for (const Parameter& p : model.parameters()) set.values.push_back(upper() ? p.maximum : p.minimum);
    sets.push_back(std::move(set));
  };
  add("hard minima", [] { return false; });
  add("hard maxima", [] { return true; });
  for (std::size_t k = 0; k < count; ++k) add("hard corner", [&] { return uniform(random) < 0.5; });
  // One parameter at a bound, the others at their defaults.
  for (std::size_t which = 0; which < model.parameters().size(); ++which)
    for (const bool upper : {false, true}) {
      const Parameter& p = model.parameters()[which];
      ParameterSet set{model.defaults(), p.name + (upper ? " at its maximum" : " at its minimum")};
      set.values[which] = upper ? p.maximum : p.minimum;
      sets.push_back(std::move(set));
    }
  return sets;
}

const Conditioning* illConditioned(const Model& model) {
  static const std::map<std::string, Conditioning> models = {
      // The shadowing term is 1 less a power of the angle of exponent 24 and more, clamped where it passes through
      // zero.
      {"SGD", {1e-12, 3e-3, true}},
      // Powers of a cosine that passes through zero at right angles to the lobe: a difference of products there.
      {"Phong", {1e-12, 1e-3, false}},
      {"Neumann", {1e-12, 1e-3, false}},
      {"Lafortune", {1e-12, 1e-3, false}},
      {"LafortuneNgan", {1e-12, 1e-3, false}},
      // Terms of both signs, which nearly cancel for rough surfaces at grazing.
      {"OrenNayarFull", {1e-12, 3e-3, false}},
      // 1 less a tabulated albedo, which toward the horizon tends to 1: the difference loses its digits.
      {"GGXMultiscatter", {1e-8, 1e-3, false}},
  };
  const auto it = models.find(model.name());
  return it == models.end() ? nullptr : &it->second;
}

bool isSlow(const Model& model) {
  const auto* formula = dynamic_cast<const FormulaModel*>(&model);
  if (formula == nullptr) return false;
  const formula::Graph& graph = formula->graph();
  for (formula::NodeId id = 0; id < graph.size(); ++id)
    if (graph[id].op == formula::Op::Sum || graph[id].op == formula::Op::Solve) return true;
  return false;
}

std::string text(const Model& model, const std::vector<double>& values) {
  std::string result = model.name() + "(";
  for (std::size_t k = 0; k < values.size(); ++k)
    result += (k == 0 ? "" : ", ") + model.parameters()[k].name + "=" + formatNumber(values[k]);
  return result + ")";
}

std::string text(const Direction& wi, const Direction& wo) {
  std::string result;
  for (const auto& [name, w] : {std::pair{"wi", wi}, std::pair{" wo", wo}}) {
    result += std::string(name) + "=(";
    for (std::size_t axis = 0; axis < 3; ++axis) result += (axis == 0 ? "" : ",") + formatNumber(w[axis], 9);
    result += ")";
  }
  return result;
}

std::vector<std::string> modelNames() {
  std::vector<std::string> names;
  for (const ModelPointer& model : allModels()) names.push_back(model->name());
  return names;
}

}  // namespace brdf::test
