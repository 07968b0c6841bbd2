#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/io/BrdfLabXml.h>
#include <brdf/io/Container.h>
#include <brdf/io/MaterialXml.h>
#include <brdf/io/SaveMaterial.h>
#include <brdf/measured/Format.h>

#include <algorithm>

namespace brdf {
namespace {

constexpr const char* kContainer = "vtkhdf";
constexpr const char* kXml = "xml";
constexpr const char* kBrdfLabXml = "brdflab-xml";

std::shared_ptr<const LobeSum> lobesOf(const LoadedMaterial& material, const std::filesystem::path& path) {
  auto lobes = std::dynamic_pointer_cast<const LobeSum>(material.brdf);
  if (!lobes)
    throw Error(Error::Kind::Value, {"the format holds lobes only", path.string(), material.brdf->description(),
                                     "a sum of lobes, or another format"});
  return lobes;
}

}  // namespace

std::vector<std::string> materialFormats() {
  std::vector<std::string> names = {kContainer, kXml, kBrdfLabXml};
  for (const Format& format : allFormats())
    if (format.write) names.push_back(format.name);
  return names;
}

WriteReport saveMaterial(const LoadedMaterial& material, const std::filesystem::path& path, std::string_view format,
                         const std::string& action, const ColourSettings& colour) {
  const bool byExtension = format.empty();
  const auto known = materialFormats();
  if (!byExtension && std::find(known.begin(), known.end(), format.substr(0, format.find(':'))) == known.end())
    throw Error(Error::Kind::Value, {"unknown format", "format", std::string(format), joined(known)});
  if (format == kContainer || (byExtension && path.extension() == ".vtkhdf")) {
    writeContainer(path, "material", *material.brdf, makeProvenance(material.report, action), material.components);
    return {};
  }
  const bool lobes = dynamic_cast<const LobeSum*>(material.brdf.get()) != nullptr;
  if (format == kXml || (byExtension && lobes && path.extension() == ".xml")) {
    writeFile(path, writeMaterialXml(*lobesOf(material, path)));
    return {};
  }
  if (format == kBrdfLabXml) {
    BrdfLabFile file;
    file.name = "MainBRDF";
    file.type = "Analytic";
    file.analytic = lobesOf(material, path);
    writeFile(path, writeBrdfLabXml(file));
    return {};
  }
  return writeMeasured(*material.brdf, material.components, path, format, colour);
}

}  // namespace brdf
