// One program for every target: --target=NAME picks it, --list prints the names. The other arguments are libFuzzer's.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "Targets.h"

namespace {

FuzzTarget chosen;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  constexpr const char* option = "--target=";
  for (int i = 1; i < *argc; ++i) {
    const char* argument = (*argv)[i];
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
