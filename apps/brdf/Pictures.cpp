#include "Pictures.h"

#include "Output.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace brdf::app {

PictureSize sizeOption(const std::string& text) {
  const auto sides = split(text, 'x');
  PictureSize size;
  if (sides.size() == 2) {
    const auto read = [](std::string_view side) {
      const auto number = parseNumber(side);
      const bool good = number && *number >= 16 && *number <= 8192 && *number == std::floor(*number);
      return good ? static_cast<std::size_t>(*number) : std::size_t{0};
    };
    size = {read(sides[0]), read(sides[1])};
  }
  if (size.width == 0 || size.height == 0)
    throw Error(Error::Kind::Usage,
                {"malformed size", "--size", "'" + text + "'", "WIDTHxHEIGHT, each 16 to 8192, say 900x700"});
  return size;
}

void checkPictureOutputs(const std::vector<std::string>& paths, const std::vector<std::string>& extensions) {
  for (const std::string& path : paths) {
    const std::string extension = std::filesystem::path(path).extension().string();
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
      throw Error(Error::Kind::Usage, {"unknown kind of picture", "--out", "'" + path + "'", joined(extensions)});
    checkWritable(path);
  }
}

MadeSurface surfaceOption(const std::string& expression) {
  SurfaceReaders readers;
  readers.mesh = [](const std::filesystem::path& path) { return pictures().surfaceReaders().mesh(path); };
  readers.picture = [](const std::filesystem::path& path) { return pictures().surfaceReaders().picture(path); };
  return makeSurface(expression, readers);
}

const PictureFunctions& pictures() {
  static const PictureFunctions* functions = [] {
    void* module = dlopen("libbrdf_pictures.so", RTLD_NOW | RTLD_LOCAL);
    void* symbol = module ? dlsym(module, "brdfPictures") : nullptr;
    if (!symbol) {
      const char* reason = dlerror();
      throw Error(Error::Kind::Device, {"the part that draws pictures cannot be loaded", "libbrdf_pictures.so",
                                        reason ? reason : "no brdfPictures in it", "a build with BRDF_BUILD_VTK=ON"});
    }
    return static_cast<const PictureFunctions*>(symbol);
  }();
  return *functions;
}

}  // namespace brdf::app
