#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/io/BrdfLabXml.h>
#include <brdf/io/LoadXml.h>
#include <brdf/io/MaterialXml.h>
#include <brdf/io/XmlText.h>
#include <brdf/models/Registry.h>

#include <algorithm>

namespace brdf {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 20;

LoadedMaterial made(BrdfPointer brdf, const char* format, const std::filesystem::path& path) {
  LoadedMaterial loaded{std::move(brdf), "material", {}};
  loaded.report.format = format;
  loaded.report.source = path.string();
  return loaded;
}

LoadedMaterial loadModel(const std::filesystem::path& path) {
  const ModelPointer model = readModelFile(path);
  const auto known = allModels();
  // A file of a built-in model opens as that model; any other joins the registry, so that the description reads back.
  const auto same = std::find_if(known.begin(), known.end(), [&](const auto& m) { return m->name() == model->name(); });
  if (same == known.end() || (*same)->equation() != model->equation()) registerModel(model);
  return made(parseMaterialExpression(model->name()), "model", path);
}

/// The measured file that the original names: as the path says, from the folder of `path`, or beside it.
std::filesystem::path originalOf(const BrdfLabFile& file, const std::filesystem::path& path) {
  std::string name = file.path;
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path stated(name);
  for (const auto& candidate : {path.parent_path() / stated, path.parent_path() / stated.filename()}) {
    std::error_code ignored;
    if (stated.has_filename() && std::filesystem::is_regular_file(candidate, ignored)) return candidate;
  }
  return {};
}

std::string entryNames(const BrdfLabFile& file) {
  std::string names = "0 (" + (file.analytic && !file.name.empty() ? file.name : std::string("the original")) + ")";
  for (std::size_t i = 0; i < file.fittings.size(); ++i)
    names += ", " + std::to_string(i + 1) + " (" + file.fittings[i].name + ")";
  return names;
}

/// 0 the original, k the k-th fit; throws for a choice that is none.
std::size_t chosenEntry(const BrdfLabFile& file, std::string_view which, const std::string& where) {
  for (std::size_t i = 0; i < file.fittings.size(); ++i)
    if (which == file.fittings[i].name) return i + 1;
  const auto number = parseNumber(which);
  if (number && *number >= 0 && *number <= static_cast<double>(file.fittings.size()) &&
      *number == static_cast<double>(static_cast<std::size_t>(*number)))
    return static_cast<std::size_t>(*number);
  if (which == file.name && file.analytic) return 0;
  throw Error(Error::Kind::Value, {"no such entry", where, "#" + std::string(which), entryNames(file)});
}

LoadedMaterial loadOriginal(const BrdfLabFile& file, const std::filesystem::path& path, const ReadOptions& options) {
  if (file.analytic) return made(file.analytic, "brdflab-xml", path);
  const std::filesystem::path measured = originalOf(file, path);
  if (!measured.empty()) return loadMaterial(measured.string(), options);
  const bool database = !file.path.empty();
  throw Error(Error::Kind::File,
              {database ? "the original's measured file is not at hand" : "the original is a simulation, not data",
               path.string() + "#0", database ? file.path : file.type, "one of " + entryNames(file)});
}

LoadedMaterial loadBrdfLab(std::string_view text, const std::filesystem::path& path, std::string_view which,
                           const ReadOptions& options) {
  const std::string where = path.string();
  const BrdfLabFile file = readBrdfLabXml(text, where);
  const bool atHand = file.analytic || !originalOf(file, path).empty();
  std::size_t entry = which.empty() ? 0 : chosenEntry(file, which, where);
  if (which.empty() && !atHand && !file.fittings.empty()) entry = 1;
  if (entry == 0) {
    LoadedMaterial loaded = loadOriginal(file, path, options);
    if (file.analytic) loaded.report.assumptions = file.notes;
    return loaded;
  }
  const BrdfLabFitting& fitting = file.fittings[entry - 1];
  LoadedMaterial loaded = made(fitting.material, "brdflab-xml", path);
  loaded.report.assumptions = file.notes;
  loaded.report.metadata = {{"entry", std::to_string(entry) + " (" + fitting.name + ")"},
                            {"fit of", file.path.empty() ? file.type : file.path},
                            {"error", formatNumber(fitting.error) + " as BRDFLab 0.8.2 computed it"},
                            {"optimizer", fitting.optimizer}};
  if (which.empty())
    loaded.report.warnings.push_back("the original (" + (file.path.empty() ? file.type : file.path) +
                                     ") is not at hand; this is the first of its fits: " + entryNames(file));
  return loaded;
}

}  // namespace

bool isMaterialXml(std::string_view head) {
  const std::string_view root = xmlRootName(head);
  return root == "material" || root == "BRDF" || root == "model" || root == "AnalyticBRDFModel";
}

LoadedMaterial loadXml(const std::filesystem::path& path, std::string_view which, const ReadOptions& options) {
  const std::string text = readFile(path, kMostBytes);
  const std::string_view root = xmlRootName(text);
  if (root == "BRDF") return loadBrdfLab(text, path, which, options);
  if (!which.empty() && which != "0")
    throw Error(Error::Kind::Value,
                {"the file holds one material", path.string(), "#" + std::string(which), "#0, or none"});
  if (root == "material") return made(readMaterialXml(text, path.string()), "xml", path);
  return loadModel(path);
}

}  // namespace brdf
