#include "Ranks.h"

#include <brdf/base/Error.h>

#include <dlfcn.h>

#include <cstdlib>

namespace brdf::app {
namespace {

/// What mpirun, mpiexec and srun tell a process about its ranks: Open MPI; MPICH and its kin; PMIx.
bool startedByMpi() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (const char* value = std::getenv(name); value && std::string(value) != "") return true;
  return false;
}

}  // namespace

std::unique_ptr<Ranks> joinRanks() {
  if (!startedByMpi()) return nullptr;
  // Global: MPI loads plug-ins of its own, which look for its symbols.
  void* module = dlopen("libbrdf_ranks.so", RTLD_NOW | RTLD_GLOBAL);
  void* symbol = module ? dlsym(module, "brdfJoinRanks") : nullptr;
  if (!symbol) {
    const char* reason = dlerror();
    throw Error(Error::Kind::Device, {"started by mpirun, but the part that speaks MPI cannot be loaded",
                                      "libbrdf_ranks.so", reason ? reason : "no brdfJoinRanks in it",
                                      "a build with BRDF_BUILD_VTK=ON and a VTK that has ParallelMPI"});
  }
  Ranks* (*join)() = nullptr;
  *reinterpret_cast<void**>(&join) = symbol;
  return std::unique_ptr<Ranks>(join());
}

}  // namespace brdf::app
