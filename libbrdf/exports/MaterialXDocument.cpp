#include <brdf/exports/MaterialXDocument.h>

#include <sstream>

namespace brdf {

MaterialXDocument::MaterialXDocument(const ExportText& text) {
  pugi::xml_node declaration = document_.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  std::string comment = "\n";
  for (const std::string& line : text.comments) comment += line + "\n";
  document_.append_child(pugi::node_comment).set_value(comment.c_str());
  root_ = document_.append_child("materialx");
  root_.append_attribute("version") = "1.39";
  root_.append_attribute("colorspace") = "lin_rec709";
}

pugi::xml_node MaterialXDocument::node(const std::string& category, const std::string& name, const char* type) {
  pugi::xml_node made = root_.append_child(category.c_str());
  made.append_attribute("name") = name.c_str();
  made.append_attribute("type") = type;
  return made;
}

void MaterialXDocument::value(pugi::xml_node node, const char* name, const char* type, const std::string& value) {
  pugi::xml_node input = node.append_child("input");
  input.append_attribute("name") = name;
  input.append_attribute("type") = type;
  input.append_attribute("value") = value.c_str();
}

void MaterialXDocument::connect(pugi::xml_node node, const char* name, const char* type, const std::string& source) {
  pugi::xml_node input = node.append_child("input");
  input.append_attribute("name") = name;
  input.append_attribute("type") = type;
  input.append_attribute("nodename") = source.c_str();
}

std::string MaterialXDocument::finish(const std::string& materialName, const std::string& shader) {
  connect(node("surfacematerial", materialName, "material"), "surfaceshader", "surfaceshader", shader);
  std::ostringstream out;
  document_.save(out, "  ");
  return out.str();
}

}  // namespace brdf
