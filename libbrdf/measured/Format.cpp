#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/measured/BuiltInFormats.h>

#include <algorithm>
#include <fstream>

namespace brdf {
namespace {

constexpr std::size_t kHeadBytes = 8192;

std::vector<Format>& registry() {
  static std::vector<Format> formats{merlFormat(),    cornellFormat(), csvFormat(),     utiaFormat(),
                                     utiaExrFormat(), csailFormat(),   carPaintFormat()};
  return formats;
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const Format& format : registry()) result.push_back(format.name);
  return result;
}

/// The first bytes, readable in an error message.
std::string shown(std::string_view head) {
  std::string text;
  for (const char c : head.substr(0, 24)) text += (c >= ' ' && c < 127) ? c : '.';
  return "\"" + text + "\"";
}

/// The format that recognises the content; where none does, one that the extension names, whose reader then says what
/// is wrong.
const Format& recognise(std::string_view bytes, const std::filesystem::path& path) {
  const Format* best = nullptr;
  int bestScore = 0;
  for (const Format& format : registry()) {
    const int score = format.recognise(bytes.substr(0, kHeadBytes), bytes.size());
    if (score > bestScore) {
      best = &format;
      bestScore = score;
    }
  }
  if (best) return *best;
  if (bytes.empty()) throw Error(Error::Kind::Format, {"the file is empty", path.string(), "0 bytes", {}});
  for (const Format& format : registry())
    if (format.extension == path.extension()) return format;
  throw Error(Error::Kind::Format,
              {"no format recognises the content", path.string(), shown(bytes), "one of " + joined(names())});
}

}  // namespace

std::span<const Format> allFormats() { return registry(); }

void registerFormat(Format format) {
  auto& formats = registry();
  const auto same =
      std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return f.name == format.name; });
  if (same != formats.end())
    *same = std::move(format);
  else
    formats.push_back(std::move(format));
}

const Format& findFormat(std::string_view name) {
  for (const Format& format : registry())
    if (format.name == name) return format;
  throw Error(Error::Kind::Value, {"unknown format", "format", std::string(name), joined(names())});
}

ReadResult readMeasured(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string bytes = readFile(path);
  const Format& format = recognise(bytes, path);
  for (const std::string& key : options.keys())
    if (std::find(format.takes.begin(), format.takes.end(), key) == format.takes.end())
      throw Error(Error::Kind::Value, {"this assumption has no meaning for the format " + format.name, path.string(),
                                       key, format.takes.empty() ? "none" : joined(format.takes)});
  ReadResult result = format.read(bytes, path, options);
  result.report.format = format.name;
  result.report.source = path.string();
  return result;
}

WriteReport writeMeasured(const Brdf& brdf, const std::filesystem::path& path, std::string_view format) {
  const Format* chosen = nullptr;
  std::vector<std::string> extensions;
  if (!format.empty()) {
    chosen = &findFormat(format);
  } else {
    for (const Format& candidate : registry()) {
      if (!candidate.write) continue;
      extensions.push_back(candidate.extension);
      if (!chosen && candidate.extension == path.extension()) chosen = &candidate;
    }
    if (!chosen)
      throw Error(Error::Kind::Value, {"no format for this extension", path.string(), path.extension().string(),
                                       joined(extensions) + ", or name a format"});
  }
  if (!chosen->write)
    throw Error(Error::Kind::Value, {"this format is read only", path.string(), chosen->name, joined(extensions)});
  AtomicFile file(path);
  WriteReport report = chosen->write(brdf, file.temporaryPath());
  file.commit();
  return report;
}

}  // namespace brdf
