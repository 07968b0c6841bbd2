#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/BrdfLabLobes.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr std::string_view kPrefix = "BRDFLab082";

/// Parameters by name, each taken once.
class Arguments {
 public:
  Arguments(const std::map<std::string, double>& given, std::string where) : left_(given), where_(std::move(where)) {}
  double take(const std::string& name, double otherwise) {
    const auto found = left_.find(name);
    if (found == left_.end()) return otherwise;
    const double value = found->second;
    left_.erase(found);
    return value;
  }
  void checkAllTaken(const std::string& model) const {
    if (!left_.empty())
      throw Error(Error::Kind::Format, {"unknown parameter of " + model, where_, "'" + left_.begin()->first + "'", {}});
  }

 private:
  std::map<std::string, double> left_;
  std::string where_;
};

/// max(0, C.(u v))^n (n + 2)/(2 pi max|C|^n): the power of the weights goes into them, the rest into the factor.
LobeFromBrdfLab lafortune(double cx, double cy, double cz, double n, const std::string& where) {
  const double largest = std::max({std::abs(cx), std::abs(cy), std::abs(cz)});
  if (!(largest > 0))
    throw Error(Error::Kind::Format, {"a Lafortune lobe without weights", where, "0", "a weight above 0"});
  return {findModel("Lafortune"), {cx / largest, cy / largest, cz / largest, n}, (n + 2) / (2 * kPi)};
}

}  // namespace

LobeFromBrdfLab fromBrdfLab(const std::string& model, const std::map<std::string, double>& parameters, bool linear,
                            const std::string& where) {
  Arguments arguments(parameters, where);
  LobeFromBrdfLab lobe;
  if (model == "Lambertian") {
    const double value = arguments.take("value", 1);
    lobe = {findModel("Lambertian"), {}, kPi * (linear ? 1 : value)};
  } else if (model == "LafortuneIso") {
    const double cxy = arguments.take("Cxy", -1), cz = arguments.take("Cz", 1);
    lobe = lafortune(cxy, cxy, cz, arguments.take("Exponent", 5), where);
  } else if (model == "LafortuneAniso") {
    const double cx = arguments.take("Cx", -1), cy = arguments.take("Cy", -1), cz = arguments.take("Cz", 1);
    lobe = lafortune(cx, cy, cz, arguments.take("Exponent", 5), where);
  } else {
    std::vector<std::string> known{"Lambertian", "LafortuneIso", "LafortuneAniso"};
    for (const ModelPointer& candidate : allModels()) {
      if (!candidate->name().starts_with(kPrefix)) continue;
      known.push_back(candidate->name().substr(kPrefix.size()));
      if (known.back() == model) lobe.model = candidate;
    }
    if (!lobe.model)
      throw Error(Error::Kind::Format, {"a model that is not known", where, "'" + model.substr(0, 60) + "'",
                                        joined(known) + ", or one whose model file is loaded (--model-path)"});
    for (const Parameter& parameter : lobe.model->parameters())
      lobe.parameters.push_back(arguments.take(parameter.name, parameter.defaultValue));
  }
  arguments.checkAllTaken(model);
  return lobe;
}

LobeForBrdfLab toBrdfLab(const Lobe& lobe, std::size_t channel) {
  const std::string& name = lobe.model->name();
  const std::vector<double> p = lobe.parametersOf(channel);
  if (name == "Lambertian") return {"Lambertian", {{"value", 1}}, 1 / kPi};
  if (name == "Lafortune") {
    const double largest = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    const double factor = largest > 0 ? 2 * kPi * std::pow(largest, p[3]) / (p[3] + 2) : 0;
    if (p[0] == p[1]) return {"LafortuneIso", {{"Cxy", p[0]}, {"Cz", p[2]}, {"Exponent", p[3]}}, factor};
    return {"LafortuneAniso", {{"Cx", p[0]}, {"Cy", p[1]}, {"Cz", p[2]}, {"Exponent", p[3]}}, factor};
  }
  if (!name.starts_with(kPrefix))
    throw Error(
        Error::Kind::Value,
        {"BRDFLab 0.8.2 does not know this lobe", name, {}, "Lambertian, Lafortune and the lobes BRDFLab082..."});
  LobeForBrdfLab result{name.substr(kPrefix.size()), {}, 1};
  for (std::size_t k = 0; k < p.size(); ++k) result.parameters.emplace_back(lobe.model->parameters()[k].name, p[k]);
  return result;
}

}  // namespace brdf
