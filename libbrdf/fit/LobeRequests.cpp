#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/LobeRequests.h>

#include <algorithm>
#include <cmath>

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

namespace {

/// One side of a tie: "name", "Lobe.name" or "Lobe#2.name".
struct TieSide {
  std::string model;       ///< empty: any lobe
  std::size_t number = 0;  ///< of the lobes of that model, from 1; 0: not said
  std::string name;
};

TieSide tieSide(std::string_view text) {
  text = trimmed(text);
  TieSide side;
  if (const std::size_t dot = text.find('.'); dot != std::string_view::npos) {
    const std::string_view lobe = text.substr(0, dot);
    const std::size_t hash = lobe.find('#');
    side.model = lobe.substr(0, hash);
    if (hash != std::string_view::npos) {
      const auto number = parseNumber(lobe.substr(hash + 1));
      if (!number || !(*number >= 1) || *number != std::floor(*number) || *number > 1e6 || side.model.empty())
        return {};
      side.number = static_cast<std::size_t>(*number);
    }
    text = text.substr(dot + 1);
  }
  side.name = text;
  return side;
}

bool hasParameter(const LobeRequest& request, const std::string& name) {
  return std::ranges::any_of(request.model->parameters(), [&](const Parameter& p) { return p.name == name; });
}

/// The lobes that a side means and that have its parameter.
std::vector<std::size_t> lobesOf(const TieSide& side, const std::vector<LobeRequest>& requests) {
  std::vector<std::size_t> lobes;
  std::size_t ofModel = 0;
  for (std::size_t k = 0; k < requests.size(); ++k) {
    const bool named = side.model.empty() || requests[k].model->name() == side.model;
    if (named) ++ofModel;
    if (named && (side.number == 0 || side.number == ofModel) && hasParameter(requests[k], side.name))
      lobes.push_back(k);
  }
  return lobes;
}

}  // namespace

void tieParameter(std::vector<LobeRequest>& requests, std::string_view text) {
  const std::size_t equals = text.find('=');
  const TieSide side = tieSide(text.substr(0, equals));
  TieSide other = equals == std::string_view::npos ? TieSide{} : tieSide(text.substr(equals + 1));
  if (side.name.empty() || other.name.empty())
    throw Error(Error::Kind::Usage, {"malformed tie", "parameters to tie", std::string(text),
                                     "name=name, say ay=ax, Ward.ay=ax or GGX#2.alpha=GGX#1.alpha"});
  std::vector<std::string> known;
  for (const LobeRequest& request : requests)
    for (const Parameter& parameter : request.model->parameters())
      known.push_back(request.model->name() + "." + parameter.name);
  const auto refuse = [&](const char* what) {
    throw Error(Error::Kind::Value, {what, "parameters to tie", std::string(text), joined(known)});
  };
  const std::vector<std::size_t> lobes = lobesOf(side, requests);
  if (other.model.empty() || (other.model == side.model && other.number == side.number)) {
    bool found = false;
    for (const std::size_t lobe : lobes)
      if (hasParameter(requests[lobe], other.name)) {
        requests[lobe].tied[side.name] = other.name;
        found = true;
      }
    if (!found) refuse("no lobe has both parameters");
    return;
  }
  const std::vector<std::size_t> leaders = lobesOf(other, requests);
  if (lobes.empty() || leaders.empty()) refuse("no lobe has such a parameter");
  if (lobes.size() > 1 || leaders.size() > 1 || lobes == leaders)
    refuse("a tie of two lobes must name one each, as GGX#2");
  // The one that comes later follows.
  const bool swapped = lobes[0] < leaders[0];
  LobeRequest& follower = requests[swapped ? leaders[0] : lobes[0]];
  follower.tiedElsewhere[swapped ? other.name : side.name] = {swapped ? lobes[0] : leaders[0],
                                                              swapped ? side.name : other.name};
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
