#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/material/ChannelView.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridWriting.h>
#include <brdf/measured/Lint.h>

#include <algorithm>
#include <fstream>

namespace brdf {
namespace {

constexpr std::size_t kHeadBytes = 8192;

std::vector<Format>& ownRegistry() {
  // One a line: additions then merge.
  // clang-format off
  static std::vector<Format> formats{
      merlFormat(),
      cornellFormat(),
      csvFormat(),
      utiaFormat(),
      utiaExrFormat(),
      csailFormat(),
      carPaintFormat(),
      altaFormat(),
      altaBinaryFormat(),
      astmFormat(),
      pabFormat(),
      birdFormat(),
      brdfLabTextFormat(),
      brdfLabExportFormat(),
      rglFormat(),
      kaistFormat(),
      integraFormat(),
      integraSpecularFormat(),
      lightToolsFormat(),
      zemaxFormat(),
      ssddFormat(),
      radianceFormat(),
      radianceKlemsFormat(),
      radianceTreeFormat(),
  };
  // clang-format on
  return formats;
}

std::vector<Format>& registry() {
  plugins();
  return ownRegistry();
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

/// The format that is surest that the head is its own, or null.
const Format* bestFormat(std::string_view head, std::uint64_t size) {
  const Format* best = nullptr;
  int bestScore = 0;
  for (const Format& format : registry()) {
    const int score = format.recognise(head, size);
    if (score > bestScore) {
      best = &format;
      bestScore = score;
    }
  }
  return best;
}

/// The format that recognises the content; where none does, one that the extension names, whose reader then says what
/// is wrong.
const Format& recognise(std::string_view bytes, const std::filesystem::path& path) {
  if (const Format* best = bestFormat(bytes.substr(0, kHeadBytes), bytes.size())) return *best;
  if (bytes.empty()) throw Error(Error::Kind::Format, {"the file is empty", path.string(), "0 bytes", {}});
  for (const Format& format : registry())
    if (format.read && format.extension == path.extension()) return format;
  throw Error(Error::Kind::Format,
              {"no format recognises the content", path.string(), shown(bytes), "one of " + joined(names())});
}

/// The regular files of a folder in alphabetical order, hidden ones left out.
std::vector<std::filesystem::path> filesOf(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code code;
  for (const auto& entry : std::filesystem::directory_iterator(folder, code))
    if (entry.is_regular_file(code) && !entry.path().filename().string().starts_with('.'))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The format of one file an incidence that recognises every file of the folder.
const Format& recogniseFolder(const std::vector<std::filesystem::path>& files, const std::filesystem::path& folder) {
  const Format* common = nullptr;
  for (const auto& file : files) {
    const std::string head = readFileHead(file, kHeadBytes);
    std::error_code ignored;
    const Format* format = bestFormat(head, std::filesystem::file_size(file, ignored));
    if (!format || !format->readFolder || (common && format != common)) {
      common = nullptr;
      break;
    }
    common = format;
  }
  if (!common)
    throw Error(Error::Kind::File, {"cannot be read", folder.string(), "a folder",
                                    "a file, or a folder of files that hold one incidence each (pab)"});
  return *common;
}

void checkOptions(const Format& format, const std::filesystem::path& path, const ReadOptions& options) {
  for (const std::string& key : options.keys())
    if (std::find(format.takes.begin(), format.takes.end(), key) == format.takes.end())
      throw Error(Error::Kind::Value, {"this assumption has no meaning for the format " + format.name, path.string(),
                                       key, format.takes.empty() ? "none" : joined(format.takes)});
}

ReadResult readFolder(const std::filesystem::path& folder, const ReadOptions& options, std::string& name) {
  const auto paths = filesOf(folder);
  const Format& format = recogniseFolder(paths, folder);
  checkOptions(format, folder, options);
  std::vector<NamedBytes> files;
  std::uint64_t left = std::uint64_t{4} << 30;
  for (const auto& path : paths) {
    files.push_back({path, readFile(path, left)});
    left -= files.back().bytes.size();
  }
  name = format.name;
  return format.readFolder(files, folder, options);
}

/// Writes a folder, which must be empty or not be there, and puts it in place when it is complete.
WriteReport writeFolder(const Format& format, const Brdf& brdf, std::filesystem::path folder) {
  if (!folder.has_filename()) folder = folder.parent_path();
  std::error_code code;
  if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder, code))
    throw Error(Error::Kind::File,
                {"cannot be written", folder.string(), "a folder with files", "an empty or new folder"});
  const std::filesystem::path temporary = folder.string() + ".part";
  if (!std::filesystem::create_directory(temporary, code))
    throw Error(Error::Kind::File,
                {"cannot be written", folder.string(), code ? code.message() : temporary.string() + " is there", {}});
  try {
    WriteReport report = format.writeFolder(brdf, temporary);
    std::filesystem::rename(temporary, folder, code);
    if (code) throw Error(Error::Kind::File, {"cannot be written", folder.string(), code.message(), {}});
    return report;
  } catch (...) {
    std::filesystem::remove_all(temporary, code);
    throw;
  }
}

bool hasSpectra(const Brdf& brdf, const Components& components) {
  const auto spectral = [](const Channels& channels) { return channels.kind == Channels::Kind::Spectral; };
  return spectral(brdf.channels()) ||
         std::ranges::any_of(components.scatter, [&](const auto& part) { return spectral(part.brdf->channels()); }) ||
         std::ranges::any_of(components.specular, [&](const auto& part) { return spectral(part.channels); });
}

/// The components with every spectrum seen as a colour.
Components inColours(Components components, const ColourSettings& colour) {
  for (ScatterComponent& part : components.scatter)
    if (part.brdf->channels().kind == Channels::Kind::Spectral) part.brdf = reducedToRgb(part.brdf, colour);
  for (SpecularComponent& part : components.specular) {
    if (part.channels.kind != Channels::Kind::Spectral) continue;
    part.values = inRgb(part.values, part.channels, colour);
    part.channels = Channels::rgb();
  }
  return components;
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

Format configuredFormat(std::string_view text) {
  const std::size_t colon = text.find(':');
  const Format& format = findFormat(text.substr(0, colon));
  if (colon == std::string_view::npos) return format;
  std::vector<std::string> allowed;
  for (const WriteSetting& setting : format.settings) allowed.push_back(setting.key + "=" + setting.values);
  std::map<std::string, std::string> values;
  for (const std::string_view item : split(text.substr(colon + 1), ',')) {
    const std::size_t equals = item.find('=');
    const std::string key(trimmed(item.substr(0, equals)));
    const auto known = std::ranges::find(format.settings, key, &WriteSetting::key);
    if (equals == std::string_view::npos || known == format.settings.end() ||
        !values.emplace(key, trimmed(item.substr(equals + 1))).second)
      throw Error(Error::Kind::Usage,
                  {"unknown or repeated setting of the format " + format.name, "format", "'" + std::string(item) + "'",
                   allowed.empty() ? "none" : joined(allowed, "; ")});
  }
  return format.configured(values);
}

ReadResult readMeasured(const std::filesystem::path& path, const ReadOptions& options) {
  std::string name;
  ReadResult result;
  if (std::filesystem::is_directory(path)) {
    result = readFolder(path, options, name);
  } else {
    const std::string bytes = readFile(path);
    const Format& format = recognise(bytes, path);
    checkOptions(format, path, options);
    name = format.name;
    result = format.read(bytes, path, options);
  }
  result.report.format = name;
  result.report.source = path.string();
  if (result.brdf)
    for (const LintFinding& finding : lint(*result.brdf)) result.report.warnings.push_back(finding.sentence());
  return result;
}

WriteReport writeMeasured(const Brdf& brdf, const std::filesystem::path& path, std::string_view format,
                          const ColourSettings& colour) {
  return writeMeasured(brdf, {}, path, format, colour);
}

WriteReport writeMeasured(const Brdf& brdf, const Components& components, const std::filesystem::path& path,
                          std::string_view format, const ColourSettings& colour) {
  Format chosen;
  std::vector<std::string> extensions;
  for (const Format& candidate : registry()) {
    if (!candidate.write) continue;
    extensions.push_back(candidate.extension);
    if (format.empty() && chosen.name.empty() && candidate.extension == path.extension()) chosen = candidate;
  }
  if (!format.empty()) chosen = configuredFormat(format);
  if (chosen.name.empty())
    throw Error(Error::Kind::Value, {"no format for this extension", path.string(), path.extension().string(),
                                     joined(extensions) + ", or name a format"});
  if (!chosen.write)
    throw Error(Error::Kind::Value, {"this format is read only", path.string(), chosen.name, joined(extensions)});
  const bool whole = chosen.writeMaterial != nullptr;
  if (chosen.coloursOnly && hasSpectra(brdf, whole ? components : Components{})) {
    const BrdfPointer reduced = reducedToRgb(BrdfPointer(BrdfPointer{}, &brdf), colour);
    WriteReport report =
        writeMeasured(*reduced, inColours(components, colour), path, format.empty() ? chosen.name : format);
    report.losses.insert(report.losses.begin(), "spectrum: reduced to linear sRGB under " + describe(colour));
    return report;
  }
  WriteReport report;
  if (chosen.writeFolder && (!path.has_filename() || std::filesystem::is_directory(path))) {
    report = writeFolder(chosen, brdf, path);
  } else {
    AtomicFile file(path);
    try {
      report = whole ? chosen.writeMaterial(components.front ? &brdf : nullptr, components, file.temporaryPath())
                     : chosen.write(brdf, file.temporaryPath());
    } catch (const Error& error) {  // the file that was asked for is spoken of
      Error::Details details = error.details();
      if (details.where == file.temporaryPath().string()) details.where = path.string();
      throw Error(error.kind(), details);
    }
    file.commit();
  }
  if (!whole) reportUnkept(components, {}, false, false, chosen.name, report);
  if (!whole && !components.front)
    report.losses.push_back("the material has no front reflection: what is written is what stands for it");
  return report;
}

}  // namespace brdf
