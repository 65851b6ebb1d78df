#include "sweep/rank_link.hpp"

#include <cstdlib>

#include <dlfcn.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::apps {
namespace {

// What Open MPI's mpirun gives its processes.
constexpr const char* kMark = "OMPI_COMM_WORLD_SIZE";

}  // namespace

std::unique_ptr<RankLink> open_rank_link(const std::string& library) {
  if (std::getenv(kMark) == nullptr) return nullptr;
  // Global: Open MPI loads parts of itself that look for its names.
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (handle == nullptr) {
    throw ConfigError({"mpirun"}, std::string("found no MPI in this eyebridge (") + dlerror() +
                                      "); expected it built where libopenmpi-dev is installed");
  }
  // Never closed: MPI leaves threads behind.
  const auto open = reinterpret_cast<OpenRankLink>(dlsym(handle, kOpenRankLink));
  if (open == nullptr) throw ConfigError({library}, "found another library, expected our own");
  return std::unique_ptr<RankLink>(open());
}

}  // namespace eyebridge::apps
