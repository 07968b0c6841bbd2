#include <brdf/io/XmlText.h>

namespace brdf {

std::string_view xmlRootName(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (true) {
    const std::size_t open = text.find('<');
    if (open == std::string_view::npos) return {};
    text.remove_prefix(open + 1);
    std::string_view end;
    if (text.starts_with("!--"))
      end = "-->";
    else if (text.starts_with('!') || text.starts_with('?'))
      end = ">";
    else
      return text.substr(0, text.find_first_of(" \t\r\n/>"));
    const std::size_t close = text.find(end);
    if (close == std::string_view::npos) return {};
    text.remove_prefix(close + end.size());
  }
}

pugi::xml_node parseXml(pugi::xml_document& document, std::string_view text, const std::string& where) {
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result)
    throw Error(Error::Kind::Format,
                {"not well-formed XML", where + ", byte " + std::to_string(result.offset), result.description(), {}});
  return document.document_element();
}

double xmlNumber(std::string_view text, const std::string& what, const std::string& where) {
  const auto value = parseNumber(text);
  if (!value)
    throw Error(Error::Kind::Format, {what + " is no number", where, "'" + std::string(text.substr(0, 40)) + "'", {}});
  return *value;
}

std::string xmlText(const pugi::xml_document& document) {
  std::ostringstream out;
  document.save(out, "  ");
  return out.str();
}

}  // namespace brdf
