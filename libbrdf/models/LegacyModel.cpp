#include <brdf/base/Error.h>
#include <brdf/models/LegacyModel.h>
#include <brdf/models/XmlRecord.h>

#include <algorithm>
#include <sstream>

namespace brdf {

bool isLegacyModel(std::string_view xml) { return xml.find("<AnalyticBRDFModel") != std::string_view::npos; }

std::string translateLegacyModel(std::string_view xml, const std::string& where) {
  const XmlSource source(xml, where);
  pugi::xml_document document;
  const pugi::xml_node root = xmlRoot(document, source, "AnalyticBRDFModel");
  pugi::xml_document target;
  pugi::xml_node model = target.append_child("model");
  const std::string name = requiredAttribute(root, "name", source);
  model.append_attribute("name") = ("BRDFLab082" + name).c_str();
  model.append_attribute("title") = (name + " as the model file of BRDFLab 0.8.2 has it").c_str();
  model.append_attribute("isotropic") =
      std::string_view(root.attribute("type").value()) == "Anisotropic" ? "no" : "yes";
  model.append_attribute("reciprocal") = "no";  // nothing in the file promises it
  model.append_attribute("clamp") = "yes";
  model.append_attribute("dialect") = "BRDFLab082";
  for (const pugi::xml_node parameter : root.child("Parameters").children("Parameter")) {
    pugi::xml_node record = model.append_child("parameter");
    const double low = numberAttribute(parameter, "lowBound", -1e30, source);
    const double high = numberAttribute(parameter, "highBound", 1e30, source);
    const double value = numberAttribute(parameter, "defaultVal", 0, source);
    record.append_attribute("name") = requiredAttribute(parameter, "name", source).c_str();
    record.append_attribute("default").set_value(value, 17);
    record.append_attribute("min").set_value(std::min({low, high, value}), 17);
    record.append_attribute("max").set_value(std::max({low, high, value}), 17);
    record.text() = "As declared by BRDFLab 0.8.2.";
  }
  std::string equation = root.child_value("Equation");
  constexpr std::string_view less = "U+003C";  // how that program writes '<' in XML
  for (std::size_t at; (at = equation.find(less)) != std::string::npos;) equation.replace(at, less.size(), "<");
  if (equation.empty()) throw Error(Error::Kind::Format, {"missing <Equation>", source.at(root)});
  model.append_child("equation").text() = equation.c_str();
  pugi::xml_node declares = model.append_child("declares");
  declares.append_attribute("check") = "energy";
  declares.text() = "nothing in the file promises a bound";
  std::ostringstream text;
  target.save(text, "", pugi::format_raw);
  return text.str();
}

}  // namespace brdf
