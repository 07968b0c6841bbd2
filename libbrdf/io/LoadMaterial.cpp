#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/io/BuiltInKinds.h>
#include <brdf/io/Container.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/LoadXml.h>
#include <brdf/io/Presets.h>
#include <brdf/material/LobeSum.h>

#include <algorithm>
#include <filesystem>

namespace brdf {
namespace {

constexpr std::string_view kPresetPrefix = "preset:";
constexpr std::size_t kHeadBytes = 4096;

bool isAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Whether text that is no expression was meant as a file: it has a '/', or ends with an extension such as ".brdf" (the
/// ".e5" of the number "1.e5" is none).
bool looksLikePath(std::string_view text) {
  if (text.find('/') != std::string_view::npos) return true;
  const std::size_t dot = text.rfind('.');
  if (dot == std::string_view::npos || dot + 1 == text.size()) return false;
  const std::string_view extension = text.substr(dot + 1);
  const bool exponent =
      (extension[0] == 'e' || extension[0] == 'E') && std::all_of(extension.begin() + 1, extension.end(), isDigit);
  return isAsciiLetter(extension[0]) && !exponent &&
         std::all_of(extension.begin(), extension.end(), [](char c) { return isAsciiLetter(c) || isDigit(c); });
}

bool isFile(std::string_view path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(std::filesystem::path(path), ignored);
  return std::filesystem::exists(status) && !std::filesystem::is_directory(status);
}

LoadedMaterial loadExpression(std::string_view expression, std::string_view spec, std::string kind) {
  LoadedMaterial loaded{parseMaterialExpression(expression), std::move(kind), {}};
  loaded.report.format = loaded.kind;
  loaded.report.source = spec;
  return loaded;
}

LoadedMaterial loadContainer(const std::filesystem::path& path, std::string_view which, const ReadOptions& options) {
  const Container container(path);
  if (container.entries().empty())
    throw Error(Error::Kind::Value, {"the container is empty", path.string(), "no entries", "at least one"});
  const std::size_t index = which.empty() ? 0 : container.find(which);
  LoadedMaterial loaded{container.load(index), "container", container.provenance(index).read,
                        container.components(index)};
  const Container::Entry& entry = container.entries()[index];
  loaded.report.metadata["container"] = path.string();
  loaded.report.metadata["entry"] = std::to_string(index) + " (" + entry.name + ")";
  if (!options.empty())
    loaded.report.warnings.push_back("assumptions (" + joined(options.keys()) +
                                     ") do not apply to a container: its entries keep those they were made with");
  if (which.empty() && container.entries().size() > 1)
    loaded.report.warnings.push_back("the container holds " + std::to_string(container.entries().size()) +
                                     " entries; this is the first (write " + path.string() + "#1 for the next)");
  return loaded;
}

/// `which` empty: the file's only, or first, BRDF.
LoadedMaterial loadFile(const std::filesystem::path& path, std::string_view which, const ReadOptions& options) {
  if (!std::filesystem::is_directory(path)) {
    const std::string head = readFileHead(path, kHeadBytes);
    if (Container::recognises(std::string_view(head).substr(0, 16))) return loadContainer(path, which, options);
    if (isMaterialXml(head)) return loadXml(path, which, options);
  }
  if (!which.empty() && which != "0")
    throw Error(Error::Kind::Value,
                {"the file holds one BRDF", path.string(), "#" + std::string(which), "#0, or none"});
  ReadResult result = readMeasured(path, options);
  return {std::move(result.brdf), "measured", std::move(result.report), std::move(result.components)};
}

std::vector<MaterialKind>& kinds() {
  static std::vector<MaterialKind> all = {programKind(), waveKind()};
  return all;
}

/// The kind that "name:arguments" names, or null.
const MaterialKind* kindOf(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return nullptr;
  for (const MaterialKind& kind : materialKinds())
    if (kind.name == text.substr(0, colon)) return &kind;
  return nullptr;
}

}  // namespace

const std::vector<MaterialKind>& materialKinds() {
  plugins();
  return kinds();
}

void registerMaterialKind(MaterialKind kind) {
  const bool good = kind.name.size() >= 2 && kind.name != "preset" && std::ranges::all_of(kind.name, [](char c) {
                      return isAsciiLetter(c) || isDigit(c) || c == '_' || c == '-';
                    });
  if (!good)
    throw Error(Error::Kind::Value, {"unusable name of a kind of materials",
                                     {},
                                     "'" + kind.name + "'",
                                     "letters, digits, '_' and '-', at least two, and not preset"});
  const auto same = std::ranges::find(kinds(), kind.name, &MaterialKind::name);
  if (same != kinds().end())
    *same = std::move(kind);
  else
    kinds().push_back(std::move(kind));
}

LoadedMaterial loadMaterial(std::string_view spec, const ReadOptions& options) {
  const std::string_view text = trimmed(spec);
  if (text.empty())
    throw Error(Error::Kind::Usage, {"no material given", {}, {}, "a file, an expression, or preset:NAME"});
  if (text.starts_with(kPresetPrefix)) {
    const Preset& preset = findPreset(text.substr(kPresetPrefix.size()));
    LoadedMaterial loaded = loadExpression(preset.expression, text, "preset");
    loaded.report.metadata = {
        {"citation", preset.citation}, {"conversion", preset.conversion}, {"measured", preset.measured}};
    return loaded;
  }
  if (isFile(text)) return loadFile(std::filesystem::path(text), {}, options);
  if (const MaterialKind* kind = kindOf(text)) {
    LoadedMaterial loaded{kind->make(text.substr(kind->name.size() + 1)), kind->name, {}};
    loaded.report.format = kind->name;
    loaded.report.source = text;
    if (kind->components) loaded.components = kind->components(*loaded.brdf);
    return loaded;
  }
  const std::size_t hash = text.rfind('#');
  if (hash != std::string_view::npos && hash + 1 < text.size()) {
    const std::string_view path = text.substr(0, hash);
    if (isFile(path) || looksLikePath(path))
      return loadFile(std::filesystem::path(path), text.substr(hash + 1), options);
  }
  if (looksLikePath(text))
    return loadFile(std::filesystem::path(text), {}, options);  // says what is wrong with the file
  return loadExpression(text, text, "expression");
}

}  // namespace brdf
