#pragma once
#include <brdf/exports/Exporter.h>

#include <pugixml.hpp>

namespace brdf {

/// A MaterialX 1.39 document under way: nodes are added to root(); finish() binds the surface shader of one to a
/// material. Colours are linear sRGB (lin_rec709).
class MaterialXDocument {
 public:
  explicit MaterialXDocument(const ExportText& text);

  /// A node of a type, such as ("conductor_bsdf", "gloss", "BSDF").
  pugi::xml_node node(const std::string& category, const std::string& name, const char* type);
  /// An input with a value, or fed by another node.
  static void value(pugi::xml_node node, const char* name, const char* type, const std::string& value);
  static void connect(pugi::xml_node node, const char* name, const char* type, const std::string& source);

  std::string finish(const std::string& materialName, const std::string& shader);

 private:
  pugi::xml_document document_;
  pugi::xml_node root_;
};

}  // namespace brdf
