#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/LobeRequests.h>

namespace brdf {

std::vector<LobeRequest> parseLobeRequests(std::string_view text) {
  std::vector<LobeRequest> requests;
  const auto sum = parseMaterialExpression(text);
  for (const Lobe& lobe : sum->lobes()) {
    if (lobe.scale != std::vector<double>{1.0})
      throw Error(Error::Kind::Usage, {"scale factors are fitted, not given", "lobes to fit", std::string(text),
                                       "lobes without factors, as in Lambertian + GGX(alpha=0.1)"});
    LobeRequest request;
    request.model = lobe.model;
    for (std::size_t k = 0; k < lobe.parameters.size(); ++k) {
      const Parameter& parameter = lobe.model->parameters()[k];
      if (lobe.parameters[k].size() != 1)
        throw Error(Error::Kind::Usage, {"a starting value is one number", "lobes to fit", parameter.name, ""});
      if (lobe.parameters[k][0] != parameter.defaultValue) request.start[parameter.name] = lobe.parameters[k][0];
    }
    requests.push_back(std::move(request));
  }
  return requests;
}

void holdParameter(std::vector<LobeRequest>& requests, std::string_view text) {
  const std::size_t equals = text.find('=');
  const auto value = equals == std::string_view::npos ? std::nullopt : parseNumber(trimmed(text.substr(equals + 1)));
  if (!value)
    throw Error(Error::Kind::Usage,
                {"malformed value", "parameter to hold", std::string(text), "name=number, say ior=1.5 or GGX.ior=1.5"});
  const std::string_view left = trimmed(text.substr(0, equals));
  const std::size_t dot = left.find('.');
  const std::string_view model = dot == std::string_view::npos ? std::string_view() : left.substr(0, dot);
  const std::string name(dot == std::string_view::npos ? left : left.substr(dot + 1));
  bool found = false;
  std::vector<std::string> known;
  for (LobeRequest& request : requests) {
    const auto& parameters = request.model->parameters();
    known.push_back(request.model->name() + ".scale");
    for (const Parameter& parameter : parameters) known.push_back(request.model->name() + "." + parameter.name);
    if (!model.empty() && model != request.model->name()) continue;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      if (parameters[k].name != name) continue;
      request.model->checkBounds(k, *value);
      request.fixed[name] = *value;
      found = true;
    }
    if (name == "scale") {
      if (!(*value >= 0))
        throw Error(Error::Kind::Value, {"out of bounds", "scale", formatNumber(*value), "0 or more"});
      request.fixed[name] = *value;
      found = true;
    }
  }
  if (!found)
    throw Error(Error::Kind::Value,
                {"no lobe has such a parameter", "parameter to hold", std::string(text), joined(known)});
}

void tieParameter(std::vector<LobeRequest>& requests, std::string_view text) {
  const std::size_t equals = text.find('=');
  const auto parts = [&](std::string_view side) {
    side = trimmed(side);
    const std::size_t dot = side.find('.');
    return dot == std::string_view::npos
               ? std::pair(std::string(), std::string(side))
               : std::pair(std::string(side.substr(0, dot)), std::string(side.substr(dot + 1)));
  };
  const auto [model, name] = parts(text.substr(0, equals));
  const auto [otherModel, leader] =
      equals == std::string_view::npos ? std::pair<std::string, std::string>() : parts(text.substr(equals + 1));
  if (name.empty() || leader.empty())
    throw Error(Error::Kind::Usage,
                {"malformed tie", "parameters to tie", std::string(text), "name=name, say ay=ax or Ward.ay=ax"});
  if (!otherModel.empty() && otherModel != model)
    throw Error(Error::Kind::Value, {"parameters of two lobes cannot be tied", "parameters to tie", std::string(text),
                                     "two parameters of one lobe"});
  bool found = false;
  std::vector<std::string> known;
  for (LobeRequest& request : requests) {
    const auto has = [&](const std::string& wanted) {
      for (const Parameter& parameter : request.model->parameters())
        if (parameter.name == wanted) return true;
      return false;
    };
    for (const Parameter& parameter : request.model->parameters())
      known.push_back(request.model->name() + "." + parameter.name);
    if ((!model.empty() && model != request.model->name()) || !has(name) || !has(leader)) continue;
    request.tied[name] = leader;
    found = true;
  }
  if (!found)
    throw Error(Error::Kind::Value,
                {"no lobe has both parameters", "parameters to tie", std::string(text), joined(known)});
}

std::vector<LobeRequest> requestsFrom(const LobeSum& material) {
  std::vector<LobeRequest> requests;
  for (const Lobe& lobe : material.lobes()) {
    LobeRequest request;
    request.model = lobe.model;
    for (std::size_t k = 0; k < lobe.parameters.size(); ++k) {
      double sum = 0;
      for (const double value : lobe.parameters[k]) sum += value;
      request.start[lobe.model->parameters()[k].name] = sum / static_cast<double>(lobe.parameters[k].size());
    }
    requests.push_back(std::move(request));
  }
  return requests;
}

}  // namespace brdf
