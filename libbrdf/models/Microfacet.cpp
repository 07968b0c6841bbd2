#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/models/Microfacet.h>
#include <brdf/models/XmlRecord.h>

#include <map>
#include <mutex>
#include <sstream>

#include "componentFiles.h"

namespace brdf {
namespace {

constexpr std::string_view kPrefix = "Microfacet_";

const XmlSource& componentSource() {
  static const XmlSource source(componentFiles()[0].text, "components.xml");
  return source;
}

const pugi::xml_node& components() {
  static pugi::xml_document document;
  static const pugi::xml_node root = xmlRoot(document, componentSource(), "components");
  return root;
}

std::vector<std::string> namesOf(const char* kind) {
  std::vector<std::string> names;
  for (const pugi::xml_node node : components().children(kind)) names.emplace_back(node.attribute("name").value());
  return names;
}

pugi::xml_node findTerm(const char* kind, std::string_view name) {
  for (const pugi::xml_node node : components().children(kind))
    if (name == node.attribute("name").value()) return node;
  throw Error(Error::Kind::Value, {std::string("unknown term ") + kind, "Microfacet", "'" + std::string(name) + "'",
                                   joined(namesOf(kind))});
}

std::string compose(const std::string& name, const pugi::xml_node& d, const pugi::xml_node& f,
                    const pugi::xml_node& g) {
  pugi::xml_document document;
  pugi::xml_node model = document.append_child("model");
  const auto nameOf = [](const pugi::xml_node& node) { return std::string(node.attribute("name").value()); };
  model.append_attribute("name") = name.c_str();
  model.append_attribute("title") = ("Microfacets: " + nameOf(d) + ", " + nameOf(f) + ", " + nameOf(g)).c_str();
  bool anisotropic = false;
  for (const pugi::xml_node& term : {d, f})
    for (const pugi::xml_node parameter : term.children("parameter")) {
      model.append_copy(parameter);
      anisotropic = anisotropic || parameter.attribute("follows");
    }
  model.append_attribute("isotropic") = anisotropic ? "no" : "yes";
  const std::string call = g.attribute("call").value();
  const bool ofDistribution = call == "smith" || call == "separable";
  const std::string visibility = ofDistribution ? d.attribute(call.c_str()).value() : call;
  const std::string equation = std::string("D = ") + d.attribute("call").value() + "; D * (" + visibility + ") * (" +
                               f.attribute("call").value() + ")";
  model.append_child("equation").text() = equation.c_str();
  pugi::xml_node sampler = model.append_child("sampler");
  sampler.append_attribute("name") = d.attribute("sampler").value();
  sampler.append_attribute("arguments") = d.attribute("arguments").value();
  for (const pugi::xml_node& term : {d, f, g})
    for (const pugi::xml_node declaration : term.children("declares")) model.append_copy(declaration);
  pugi::xml_node reference = model.append_child("reference");
  reference.append_attribute("authors") = "Walter, Marschner, Li, Torrance";
  reference.append_attribute("year") = "2007";
  reference.append_attribute("title") = "Microfacet models for refraction through rough surfaces";
  reference.append_attribute("venue") = "EGSR 2007";
  reference.append_attribute("doi") = "10.2312/EGWR/EGSR07/195-206";
  reference.append_attribute("equations") = "(20)";
  std::ostringstream text;
  document.save(text, "", pugi::format_raw);
  return text.str();
}

}  // namespace

const MicrofacetTerms& microfacetTerms() {
  static const MicrofacetTerms terms{namesOf("D"), namesOf("F"), namesOf("G")};
  return terms;
}

const std::vector<MicrofacetTerm>& microfacetTermsOf(char kind) {
  static const std::map<char, std::vector<MicrofacetTerm>> all = [] {
    std::map<char, std::vector<MicrofacetTerm>> terms;
    for (const pugi::xml_node node : components().children()) {
      MicrofacetTerm term;
      term.name = node.attribute("name").value();
      term.call = node.attribute("call").value();
      for (const pugi::xml_node parameter : node.children("parameter"))
        term.parameters.push_back(readParameter(parameter, componentSource()));
      term.smith = node.attribute("smith").value();
      term.sampler = node.attribute("sampler").value();
      term.samplerArguments = splitArguments(node.attribute("arguments").value());
      terms[node.name()[0]].push_back(std::move(term));
    }
    return terms;
  }();
  const auto it = all.find(kind);
  if (it == all.end())
    throw Error(Error::Kind::Value,
                {"unknown kind of term", "Microfacet", "'" + std::string(1, kind) + "'", "D, F, G"});
  return it->second;
}

ModelPointer composeMicrofacet(std::string_view distribution, std::string_view fresnel, std::string_view shadowing) {
  static std::mutex mutex;
  static std::map<std::string, ModelPointer> made;
  const pugi::xml_node d = findTerm("D", distribution), f = findTerm("F", fresnel), g = findTerm("G", shadowing);
  const std::string name =
      std::string(kPrefix) + std::string(distribution) + "_" + std::string(fresnel) + "_" + std::string(shadowing);
  const std::lock_guard lock(mutex);
  ModelPointer& model = made[name];
  if (!model) model = std::make_shared<FormulaModel>(compose(name, d, f, g), name);
  return model;
}

ModelPointer findMicrofacet(std::string_view name) {
  if (name.substr(0, kPrefix.size()) != kPrefix) return nullptr;
  const std::vector<std::string_view> parts = split(name.substr(kPrefix.size()), '_');
  if (parts.size() != 3)
    throw Error(Error::Kind::Value,
                {"malformed name of a microfacet model", {}, "'" + std::string(name) + "'", "Microfacet_<D>_<F>_<G>"});
  return composeMicrofacet(parts[0], parts[1], parts[2]);
}

}  // namespace brdf
