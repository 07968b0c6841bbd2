#include <brdf/io/BrdfLabLobes.h>
#include <brdf/io/BrdfLabXml.h>
#include <brdf/io/XmlText.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

using Node = pugi::xml_node;
constexpr double kUnit = 1e-12;  ///< a scale factor this near to 1 is none

/// One lobe element: for which channel (Fixed), with which scale factors (Linear).
struct Element {
  LobeFromBrdfLab lobe;
  std::size_t channel = 0;
  std::vector<double> scale;
};

/// A browser shows "- <BRDF>"; the text pasted from there has the hyphens.
std::string withoutHyphens(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    std::string_view line = text.substr(0, end);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string_view::npos && line[first] == '-') {
      const std::size_t open = line.find_first_not_of(" \t", first + 1);
      if (open != std::string_view::npos && line[open] == '<') line.remove_prefix(open);
    }
    result += line;
    text.remove_prefix(end);
  }
  return result;
}

std::string childText(const Node& node, const char* name) { return std::string(trimmed(node.child_value(name))); }

Element readLobe(const Node& node, const Node& scaling, bool linear, std::size_t channels, const std::string& where) {
  const std::string model = childText(node, "Model");
  std::map<std::string, double> parameters;
  for (const pugi::xml_attribute attribute : node.child("Parameters").attributes())
    parameters[attribute.name()] = xmlNumber(attribute.value(), model + "." + attribute.name(), where);
  Element element;
  element.lobe = fromBrdfLab(model, parameters, linear, where);
  if (linear) {
    for (std::size_t c = 0; c < channels; ++c) {
      const std::string name = "channel" + std::to_string(c);
      if (!scaling.attribute(name.c_str()))
        throw Error(Error::Kind::Format,
                    {"a lobe lacks its scale factor", where, model, name + " in <ScalingFactors>"});
      element.scale.push_back(element.lobe.factor * xmlNumber(scaling.attribute(name.c_str()).value(), name, where));
    }
  } else {
    const double channel = xmlNumber(node.attribute("channel").as_string("0"), "channel", where);
    if (!(channel >= 0 && channel < static_cast<double>(channels) && channel == std::floor(channel)))
      throw Error(Error::Kind::Format,
                  {"wrong channel of a lobe", where, formatNumber(channel), "0 to " + std::to_string(channels - 1)});
    element.channel = static_cast<std::size_t>(channel);
  }
  return element;
}

Lobe single(const LobeFromBrdfLab& from, std::vector<double> scale) {
  Lobe lobe{from.model, {}, std::move(scale)};
  for (const double value : from.parameters) lobe.parameters.push_back({value});
  return lobe;
}

/// The k-th lobes of the channels as one lobe where they are of one model, else as one lobe each.
std::vector<Lobe> fixedLobes(const std::vector<Element>& elements, std::size_t channels) {
  std::vector<std::vector<const Element*>> ofChannel(channels);
  std::size_t most = 0;
  for (const Element& element : elements) {
    auto& list = ofChannel[element.channel];
    list.push_back(&element);
    most = std::max(most, list.size());
  }
  std::vector<Lobe> lobes;
  for (std::size_t k = 0; k < most; ++k) {
    const auto& first = ofChannel[0];
    const bool together = std::all_of(ofChannel.begin(), ofChannel.end(), [&](const auto& list) {
      return k < list.size() && k < first.size() && list[k]->lobe.model == first[k]->lobe.model;
    });
    if (together) {
      Lobe lobe{first[k]->lobe.model, std::vector<std::vector<double>>(first[k]->lobe.parameters.size()), {}};
      for (const auto& list : ofChannel) {
        lobe.scale.push_back(list[k]->lobe.factor);
        for (std::size_t p = 0; p < lobe.parameters.size(); ++p)
          lobe.parameters[p].push_back(list[k]->lobe.parameters[p]);
      }
      for (auto& values : lobe.parameters)
        if (std::equal(values.begin() + 1, values.end(), values.begin())) values.resize(1);
      lobes.push_back(std::move(lobe));
      continue;
    }
    for (std::size_t c = 0; c < channels; ++c) {
      if (k >= ofChannel[c].size()) continue;
      std::vector<double> scale(channels, 0);
      scale[c] = ofChannel[c][k]->lobe.factor;
      lobes.push_back(single(ofChannel[c][k]->lobe, std::move(scale)));
    }
  }
  return lobes;
}

std::shared_ptr<const LobeSum> readAnalytic(const Node& material, const std::string& where,
                                            std::vector<std::string>& notes) {
  const std::string combination = childText(material, "LobeCombination");
  if (combination != "Linear" && combination != "Fixed")
    throw Error(Error::Kind::Format,
                {"unknown LobeCombination", where, "'" + combination.substr(0, 40) + "'", "Linear, Fixed"});
  const bool linear = combination == "Linear";
  const Node parameters = material.child("Parameters");
  const double count = xmlNumber(parameters.attribute("nChannels").as_string("3"), "nChannels", where);
  if (count != 1 && count != 3)
    throw Error(Error::Kind::Format, {"wrong nChannels", where, formatNumber(count), "1, 3"});
  const auto channels = static_cast<std::size_t>(count);
  std::vector<Element> elements;
  Node scaling;
  bool lambertian = false;
  for (const Node node : parameters.children()) {
    const std::string_view name = node.name();
    if (name == "ScalingFactors") scaling = node;
    if (name != "Lobe") continue;
    lambertian = lambertian || childText(node, "Model") == "Lambertian";
    elements.push_back(readLobe(node, scaling, linear, channels, where));
    scaling = {};
  }
  const double stated = xmlNumber(parameters.attribute("nLobes").as_string("0"), "nLobes", where);
  if (stated != static_cast<double>(elements.size()))
    notes.push_back(where + ": nLobes says " + formatNumber(stated) + ", the file holds " +
                    std::to_string(elements.size()));
  if (lambertian)
    notes.push_back(where +
                    ": the Lambertian factor is the value f, as BRDFLab 0.8.2 draws it; fits copied from tables of "
                    "albedos (Ngan) are pi times too bright there");
  std::vector<Lobe> lobes;
  if (linear)
    for (Element& element : elements) lobes.push_back(single(element.lobe, std::move(element.scale)));
  else
    lobes = fixedLobes(elements, channels);
  return std::make_shared<LobeSum>(std::move(lobes), channels == 3 ? Channels::rgb() : Channels::monochrome());
}

void append(Node& node, const char* name, const std::string& text) { node.append_child(name).text() = text.c_str(); }

void writeLobe(Node& parameters, const LobeForBrdfLab& lobe, const std::vector<double>* scale, std::size_t channel,
               double value) {
  if (scale) {
    Node scaling = parameters.append_child("ScalingFactors");
    for (std::size_t c = 0; c < scale->size(); ++c)
      scaling.append_attribute(("channel" + std::to_string(c)).c_str()) = formatNumber((*scale)[c]).c_str();
  }
  Node node = parameters.append_child("Lobe");
  if (!scale) node.append_attribute("channel") = std::to_string(channel).c_str();
  append(node, "Model", lobe.model);
  append(node, "Type", lobe.model == "LafortuneAniso" ? "Anisotropic" : "Isotropic");
  Node list = node.append_child("Parameters");
  for (const auto& [name, number] : lobe.parameters)
    list.append_attribute(name.c_str()) = formatNumber(name == "value" && !scale ? value : number).c_str();
}

void writeAnalytic(Node material, const std::string& name, const LobeSum& sum) {
  if (sum.channels().kind == Channels::Kind::Spectral)
    throw Error(Error::Kind::Value, {"BRDFLab 0.8.2 has no spectra", name,
                                     std::to_string(sum.channels().count()) + " wavelengths", "monochrome or RGB"});
  const std::size_t channels = sum.channels().count();
  // Fixed has no scale factors; only the Lambertian's value can stand for one.
  bool fixed = false, unscaled = true;
  for (const Lobe& lobe : sum.lobes()) {
    fixed = fixed || !lobe.channelIndependent();
    for (std::size_t c = 0; c < channels; ++c) {
      const LobeForBrdfLab old = toBrdfLab(lobe, c);
      unscaled = unscaled && (old.model == "Lambertian" || std::abs(old.factor * lobe.scaleOf(c) - 1) < kUnit);
    }
  }
  fixed = fixed && unscaled;
  if (!name.empty()) append(material, "Name", name);
  append(material, "Type", "Analytic");
  append(material, "LobeCombination", fixed ? "Fixed" : "Linear");
  Node parameters = material.append_child("Parameters");
  std::size_t count = 0;
  for (const Lobe& lobe : sum.lobes()) {
    if (!fixed && lobe.channelIndependent()) {
      const LobeForBrdfLab old = toBrdfLab(lobe, 0);
      std::vector<double> scale;
      for (std::size_t c = 0; c < channels; ++c) scale.push_back(old.factor * lobe.scaleOf(c));
      writeLobe(parameters, old, &scale, 0, 0);
      ++count;
      continue;
    }
    for (std::size_t c = 0; c < channels; ++c) {  // shapes that differ by channel: one lobe each, the others' factors 0
      const LobeForBrdfLab old = toBrdfLab(lobe, c);
      std::vector<double> scale(channels, 0);
      scale[c] = old.factor * lobe.scaleOf(c);
      writeLobe(parameters, old, fixed ? nullptr : &scale, c, scale[c]);
      ++count;
    }
  }
  parameters.append_attribute("nLobes") = std::to_string(count).c_str();
  parameters.append_attribute("nChannels") = std::to_string(channels).c_str();
}

}  // namespace

BrdfLabFile readBrdfLabXml(std::string_view text, const std::string& where) {
  pugi::xml_document document;
  const std::string clean = withoutHyphens(text);
  const Node root = parseXml(document, clean, where);
  const Node material = root.child("Material");
  if (std::string_view(root.name()) != "BRDF" || !material)
    throw Error(Error::Kind::Format,
                {"no material", where, "<" + std::string(root.name()) + ">", "<BRDF> with <Material>"});
  BrdfLabFile file;
  file.name = childText(material, "Name");
  file.type = childText(material, "Type");
  file.url = childText(material, "URL");
  if (file.type == "Analytic")
    file.analytic = readAnalytic(material, where, file.notes);
  else
    file.path = file.name;
  for (const Node node : root.children("Fitting")) {
    BrdfLabFitting fitting;
    const Node fitted = node.child("Material");
    fitting.name = childText(fitted, "Name");
    if (fitting.name.empty()) fitting.name = "Fit-" + std::to_string(file.fittings.size());
    const std::string here = where + ", " + fitting.name;
    if (childText(fitted, "Type") != "Analytic")
      throw Error(Error::Kind::Format,
                  {"a fit that is not analytic", here, childText(fitted, "Type").substr(0, 40), "Analytic"});
    fitting.material = readAnalytic(fitted, here, file.notes);
    fitting.error = xmlNumber(node.attribute("error").as_string("0"), "error", here);
    const char* optimizer = node.attribute("optimizerName") ? "optimizerName" : "optimizer";
    fitting.optimizer = node.attribute(optimizer).as_string("none");
    fitting.readOnly = std::string_view(node.attribute("readOnly").value()) == "true";
    file.fittings.push_back(std::move(fitting));
  }
  return file;
}

std::string writeBrdfLabXml(const BrdfLabFile& file) {
  pugi::xml_document document;
  document.append_child(pugi::node_doctype).set_value("BRDF");
  Node root = document.append_child("BRDF");
  Node info = root.append_child("Info");
  append(info, "Program", "BRDFLab");
  append(info, "Version", "0.1");
  Node material = root.append_child("Material");
  if (file.analytic) {
    writeAnalytic(material, file.name, *file.analytic);
  } else {
    append(material, "Type", file.type);
    append(material, "URL", file.url);
    append(material, "Name", file.path);
    append(material, "Format", "isotropic");
  }
  for (const BrdfLabFitting& fitting : file.fittings) {
    Node node = root.append_child("Fitting");
    node.append_attribute("error") = formatNumber(fitting.error).c_str();
    node.append_attribute("readOnly") = fitting.readOnly ? "true" : "false";
    node.append_attribute("optimizerName") = fitting.optimizer.c_str();
    writeAnalytic(node.append_child("Material"), fitting.name, *fitting.material);
  }
  return xmlText(document);
}

}  // namespace brdf
