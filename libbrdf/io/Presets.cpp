#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/Presets.h>

#include <pugixml.hpp>

#include "embeddedPresets.h"

namespace brdf {
namespace {

/// The text with every run of blanks and line ends as one blank.
std::string oneLine(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
    if (!blank)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  if (line.ends_with(' ')) line.pop_back();
  return line;
}

std::vector<Preset> readPresets(std::string_view text) {
  pugi::xml_document document;
  const auto status = document.load_buffer(text.data(), text.size());
  if (!status)
    throw Error(Error::Kind::Format, {status.description(), "presets.xml, offset " + std::to_string(status.offset)});
  const pugi::xml_node root = document.child("presets");
  std::vector<Preset> all;
  for (const pugi::xml_node node : root.children("preset")) {
    const pugi::xml_node source = root.find_child_by_attribute("source", "id", node.attribute("source").value());
    const pugi::xml_node conversion =
        root.find_child_by_attribute("conversion", "id", node.attribute("conversion").value());
    const auto of = [&](const char* name) { return std::string(source.attribute(name).value()); };
    Preset preset;
    preset.name = node.attribute("name").value();
    preset.expression = oneLine(node.child_value());
    preset.measured = node.attribute("measured").value();
    preset.doi = of("doi");
    preset.citation =
        of("authors") + " " + of("year") + ", \"" + of("title") + "\", " + of("venue") + ", doi:" + preset.doi;
    preset.conversion = oneLine(conversion.child_value());
    all.push_back(std::move(preset));
  }
  return all;
}

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = readPresets(embeddedPresets().front().text);
  return all;
}

const Preset& findPreset(std::string_view name) {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) {
    if (preset.name == name) return preset;
    names.push_back(preset.name);
  }
  throw Error(Error::Kind::Value, {"no such preset", "preset:" + std::string(name), {}, joined(names)});
}

}  // namespace brdf
