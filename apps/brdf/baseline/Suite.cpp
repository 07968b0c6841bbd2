#include "Suite.h"

#include <brdf/base/Error.h>
#include <brdf/io/JsonObject.h>

#include <nlohmann/json.hpp>
#include <set>

namespace brdf::app {
namespace {

// A hundredth of a per cent of the picture: at 450 x 350 a digit that changes in the title is twice that.
constexpr double kLayoutTolerance = 1e-4;

double share(const JsonObject& entry, const std::string& key, double otherwise, double largest) {
  const double value = entry.number(key, otherwise);
  if (!(value >= 0 && value <= largest))
    entry.fail("out of range", key, std::to_string(value), largest <= 1 ? "0 to 1" : "0 or more");
  return value;
}

BaselinePicture picture(const JsonObject& entry) {
  BaselinePicture result;
  result.file = entry.text("file");
  const std::filesystem::path path(result.file);
  const std::string kind = path.extension().string();
  if ((kind != ".png" && kind != ".exr") || path.stem().empty() || path.has_parent_path())
    entry.fail("not the name of a picture", "file", "\"" + result.file + "\"",
               "name.png or name.exr, without a folder");
  result.command = entry.texts("command");
  if (result.command.empty()) entry.fail("empty", "command", "[]", "the words after brdf, such as [\"lobe\", \"GGX\"]");
  for (const std::string& word : result.command)
    if (word == "--out" || word.starts_with("--out="))
      entry.fail("the file says where the picture goes", "command", word, "a command without --out");
  if (kind == ".exr") {
    result.radiance.absolute = share(entry, "absolute", result.radiance.absolute, 1e30);
    result.radiance.relative = share(entry, "relative", result.radiance.relative, 1e30);
    result.radiance.outliers = share(entry, "outliers", result.radiance.outliers, 1);
  } else {
    result.layout = share(entry, "layout", kLayoutTolerance, 1);
  }
  entry.finish();
  return result;
}

}  // namespace

std::vector<BaselinePicture> readBaselineSuite(const std::filesystem::path& path) {
  const JsonObject suite = JsonObject::read(path);
  std::vector<BaselinePicture> pictures;
  std::set<std::string> names;
  for (const JsonObject& entry : suite.objects("pictures")) {
    pictures.push_back(picture(entry));
    if (!names.insert(pictures.back().file).second)
      entry.fail("two pictures of one name", "file", "\"" + pictures.back().file + "\"", "different names");
  }
  if (pictures.empty()) suite.fail("no pictures", "pictures", "", "one at least");
  suite.finish();
  return pictures;
}

std::string exampleBaselineSuite() {
  return R"({
  "pictures": [
    {"file": "paint-lobe.png",
     "command": ["lobe", "preset:bagher-sgd-gold-metallic-paint", "--theta-i", "45", "--size", "450x350"]},
    {"file": "paint-sphere.exr", "relative": 0.01, "absolute": 1e-4, "outliers": 0.001,
     "command": ["render", "preset:bagher-sgd-gold-metallic-paint", "--light", "directional:45,30", "--size", "96x96"]}
  ]
}
)";
}

}  // namespace brdf::app
