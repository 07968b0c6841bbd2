#include "ScatmechRequest.h"

#include <brdf/base/Text.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scatmech {
namespace {

const std::array<std::string, 3> kSymmetries = {"isotropic", "bilateral", "anisotropic"};  // as brdf::Symmetry

[[noreturn]] void fail(const std::string& where, const std::string& what, const std::string& found,
                       const std::string& allowed) {
  throw brdf::Error(brdf::Error::Kind::Value, {what, "scatmech " + where, "'" + found + "'", allowed});
}

brdf::Symmetry symmetryOf(const std::string& text, const std::string& where) {
  const auto found = std::ranges::find(kSymmetries, text);
  if (found == kSymmetries.end()) fail(where, "unknown symmetry", text, brdf::joined(kSymmetries));
  return static_cast<brdf::Symmetry>(found - kSymmetries.begin());
}

void checkWavelengths(const Request& request, const std::string& text) {
  const auto& list = request.wavelengths;
  const std::string where = request.model + ", lambda";
  if (std::ranges::any_of(list, [](double w) { return !(w > 0 && std::isfinite(w)); }))
    fail(where, "unusable wavelength", text, "micrometres, above 0");
  if (request.rgb && list.size() != 3) fail(where, "unusable wavelengths", text, "three: red, green, blue");
  if (!request.rgb && !std::ranges::is_sorted(list, std::ranges::less_equal{}))
    fail(where, "unusable wavelengths", text, "ascending, or channels=rgb with red, green, blue");
}

}  // namespace

brdf::Error errorOf(const Failure& failure, const std::string& where) {
  std::string allowed = brdf::joined(failure.allowed);
  const std::string nearest = brdf::closestName(failure.found, failure.allowed);
  if (!nearest.empty()) allowed = nearest + "? (all: " + allowed + ")";
  return {brdf::Error::Kind::Value,
          {failure.what(), "scatmech " + where, failure.found.empty() ? "" : "'" + failure.found + "'", allowed}};
}

Request parseRequest(std::string_view text) {
  const brdf::Call call = brdf::parseCall(text, "scatmech");
  Request request;
  request.model = call.name;
  std::string wavelengths;
  for (brdf::Call::Argument argument : call.arguments) {
    // "psd.A=0.01": calls know no names with a dot.
    const std::size_t equals = argument.text.find('=');
    if (argument.key.empty() && equals != std::string::npos) {
      argument.key = brdf::trimmed(std::string_view(argument.text).substr(0, equals));
      argument.text = std::string(brdf::trimmed(std::string_view(argument.text).substr(equals + 1)));
      if (std::ranges::find(request.parameters, argument.key, &brdf::Call::Argument::key) != request.parameters.end())
        fail(call.name, "a parameter is given twice", argument.key, "each once");
    }
    const std::string where = call.name + ", " + argument.key;
    if (argument.key.empty()) fail(call.name, "a value without a name", argument.text, "name=value");
    if (argument.key == "lambda") {
      request.wavelengths = brdf::numbersOf(call, argument);
      wavelengths = argument.text;
    } else if (argument.key == "channels") {
      request.rgb = argument.text == "rgb";
      if (!request.rgb && argument.text != "spectral")
        fail(where, "unknown meaning of several wavelengths", argument.text, "spectral, rgb");
    } else if (argument.key == "incident") {
      request.incident = argument.text;
    } else if (argument.key == "detected") {
      request.detected = argument.text;
    } else if (argument.key == "element") {
      request.element = argument.text;
    } else if (argument.key == "symmetry") {
      request.symmetry = symmetryOf(argument.text, where);
    } else if (argument.key == "type" && argument.text != "0") {
      fail(where, "not the reflection of light from outside", argument.text, "0");
    } else {
      request.parameters.push_back(argument);
    }
  }
  checkWavelengths(request, wavelengths);
  std::ranges::stable_sort(request.parameters, {},
                           [](const auto& argument) { return std::ranges::count(argument.key, '.'); });
  return request;
}

Model makeModel(const Request& request, double wavelength) {
  std::string where = request.model;
  try {
    Model model(request.model);
    for (const brdf::Call::Argument& argument : request.parameters) {
      where = request.model + ", " + argument.key;
      model.set(argument.key, argument.text);
    }
    if (wavelength > 0) model.setWavelength(wavelength);
    return model;
  } catch (const Failure& failure) {
    throw errorOf(failure, where);
  }
}

std::vector<brdf::MaterialModel> listModels() {
  const std::lock_guard lock(inside());
  std::vector<brdf::MaterialModel> list;
  for (const ModelFacts& facts : allModels()) list.push_back({facts.name, facts.description});
  return list;
}

brdf::MaterialModel describeModel(std::string_view text) {
  const Request request = parseRequest(text);
  const std::lock_guard lock(inside());
  const Model model = makeModel(request, request.wavelengths.empty() ? 0 : request.wavelengths[0]);
  brdf::MaterialModel described{request.model, model.description()};
  for (const ParameterFacts& p : model.parameters())
    described.parameters.push_back({p.name, p.type, p.value, p.description, p.choices});
  const auto ours = [&](const char* name, const std::string& value, const char* meaning,
                        std::vector<std::string> choices) {
    described.parameters.push_back({name, "choice", value, meaning, std::move(choices)});
  };
  std::vector<std::string> states = {"s", "p", "s+p", "s-p", "lcp", "rcp"}, incident = states, detected = states;
  incident.insert(incident.begin(), "unpolarized");
  detected.insert(detected.begin(), "all");
  ours("channels", request.rgb ? "rgb" : "spectral", "What several lambda mean", {"spectral", "rgb"});
  ours("incident", request.incident, "State of the light", incident);
  ours("detected", request.detected, "All light, or what an analyser of this state passes", detected);
  ours("element", request.element, "An element of the Mueller matrix, m00 to m33, in place of a value: signed", {});
  ours("symmetry", kSymmetries[static_cast<std::size_t>(request.symmetry)],
       "What you vouch for: tables and fits rely on it", {kSymmetries.begin(), kSymmetries.end()});
  return described;
}

}  // namespace scatmech
