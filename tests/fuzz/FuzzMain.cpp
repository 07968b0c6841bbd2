// One program for every target: --target=NAME picks it, --list prints the names, --seeds=FOLDER writes containers to
// start from. The other arguments are libFuzzer's.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "ContainerEdits.h"
#include "Targets.h"

#include <brdf/base/File.h>

namespace {

FuzzTarget chosen;

void writeSeeds(const std::string& folder) {
  for (std::size_t i = 0; i < containerCount(); ++i) {
    brdf::writeFile(folder + "/seed" + std::to_string(i), containerBytes(i));
    brdf::writeFile(folder + "/old" + std::to_string(i), withoutChecksums(containerBytes(i)));
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  constexpr const char *option = "--target=", *seeds = "--seeds=";
  for (int i = 1; i < *argc; ++i) {
    const char* argument = (*argv)[i];
    if (std::strncmp(argument, seeds, std::strlen(seeds)) == 0) {
      writeSeeds(argument + std::strlen(seeds));
      std::exit(0);
    }
    for (const FuzzTarget& target : fuzzTargets()) {
      if (std::strcmp(argument, "--list") == 0) std::printf("%s\n", target.name.c_str());
      if (std::strncmp(argument, option, std::strlen(option)) == 0 && target.name == argument + std::strlen(option))
        chosen = target;
    }
    if (std::strcmp(argument, "--list") == 0) std::exit(0);
  }
  if (!chosen.run) {
    std::fprintf(stderr, "--target=NAME, one of --list\n");
    std::exit(2);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen.run({reinterpret_cast<const char*>(data), size});
  return 0;
}
