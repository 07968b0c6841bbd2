#include <brdf/io/MaterialXml.h>
#include <brdf/io/XmlText.h>
#include <brdf/models/Microfacet.h>

#include <algorithm>

namespace brdf {
namespace {

constexpr std::size_t kMostChannels = 10000;

std::vector<double> numbers(std::string_view text, const std::string& what, const std::string& where) {
  std::vector<double> values;
  for (std::string_view rest = trimmed(text); !rest.empty(); rest = trimmed(rest)) {
    const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
    values.push_back(xmlNumber(rest.substr(0, end), what, where));
    rest.remove_prefix(end);
    if (values.size() > kMostChannels)
      throw Error(Error::Kind::Format, {"too many values", where, what, std::to_string(kMostChannels)});
  }
  if (values.empty())
    throw Error(Error::Kind::Format, {what + " has no value", where, {}, "one number, or one a channel"});
  return values;
}

std::string text(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(formatNumber(value));
  return joined(texts, " ");
}

Channels readChannels(const pugi::xml_node& root, const std::string& where) {
  const std::string_view kind = root.attribute("channels").as_string("monochrome");
  if (kind == "monochrome") return Channels::monochrome();
  if (kind == "rgb") return Channels::rgb();
  if (kind != "spectral")
    throw Error(Error::Kind::Format,
                {"unknown channels", where, "'" + std::string(kind.substr(0, 40)) + "'", "monochrome, rgb, spectral"});
  std::vector<double> wavelengths = numbers(root.attribute("wavelengths").value(), "wavelengths", where);
  if (!std::is_sorted(wavelengths.begin(), wavelengths.end(), std::less_equal<>()) || !(wavelengths.front() >= 10) ||
      !(wavelengths.back() <= 1e6))
    throw Error(Error::Kind::Format,
                {"wrong wavelengths", where, text(wavelengths).substr(0, 60), "ascending, 10 to 1000000 nm"});
  return Channels::spectral(std::move(wavelengths));
}

Lobe readLobe(const pugi::xml_node& node, const std::string& where) {
  const std::string name = node.attribute("model").value();
  Lobe lobe;
  lobe.model = findMicrofacet(name);
  if (!lobe.model) lobe.model = findModel(name);
  for (const double value : lobe.model->defaults()) lobe.parameters.push_back({value});
  std::vector<bool> given(lobe.parameters.size(), false);
  for (const pugi::xml_node child : node.children()) {
    const std::string_view element = child.name();
    if (element == "scale") {
      lobe.scale = numbers(child.child_value(), "scale of " + name, where);
    } else if (element == "parameter") {
      const std::size_t index = lobe.model->parameterIndex(child.attribute("name").value());
      lobe.parameters[index] = numbers(child.child_value(), name + "." + child.attribute("name").value(), where);
      given[index] = true;
    } else if (child.type() == pugi::node_element) {
      throw Error(Error::Kind::Format,
                  {"unknown element", where, "<" + std::string(element.substr(0, 40)) + ">", "scale, parameter"});
    }
  }
  for (std::size_t k = 0; k < given.size(); ++k) {
    const std::string& followed = lobe.model->parameters()[k].follows;
    if (!given[k] && !followed.empty()) lobe.parameters[k] = lobe.parameters[lobe.model->parameterIndex(followed)];
  }
  return lobe;
}

}  // namespace

std::shared_ptr<const LobeSum> readMaterialXml(std::string_view source, const std::string& where) {
  pugi::xml_document document;
  const pugi::xml_node root = parseXml(document, source, where);
  if (std::string_view(root.name()) != "material")
    throw Error(Error::Kind::Format, {"wrong root element", where, "<" + std::string(root.name()) + ">", "<material>"});
  if (std::string_view(root.attribute("version").as_string("1")) != "1")
    throw Error(Error::Kind::Format, {"unknown version", where, root.attribute("version").value(), "1"});
  const Channels channels = readChannels(root, where);
  std::vector<Lobe> lobes;
  for (const pugi::xml_node node : root.children("lobe")) lobes.push_back(readLobe(node, where));
  return std::make_shared<LobeSum>(std::move(lobes), channels);
}

std::string writeMaterialXml(const LobeSum& material) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("material");
  root.append_attribute("version") = "1";
  const Channels& channels = material.channels();
  root.append_attribute("channels") = channels.kind == Channels::Kind::Monochrome ? "monochrome"
                                      : channels.kind == Channels::Kind::Rgb      ? "rgb"
                                                                                  : "spectral";
  if (channels.kind == Channels::Kind::Spectral)
    root.append_attribute("wavelengths") = text(channels.wavelengths).c_str();
  for (const Lobe& lobe : material.lobes()) {
    pugi::xml_node node = root.append_child("lobe");
    node.append_attribute("model") = lobe.model->name().c_str();
    node.append_child("scale").text() = text(lobe.scale).c_str();
    for (std::size_t k = 0; k < lobe.parameters.size(); ++k) {
      pugi::xml_node parameter = node.append_child("parameter");
      parameter.append_attribute("name") = lobe.model->parameters()[k].name.c_str();
      parameter.text() = text(lobe.parameters[k]).c_str();
    }
  }
  return xmlText(document);
}

}  // namespace brdf
