#include "eyebridge/camera/prepare_process.hpp"

#include <cstdlib>
#include <mutex>

namespace eyebridge::camera {

void prepare_process() {
  // llvmpipe reads it once, with its first context. Worker threads of its own gain nothing for
  // several cameras and would run beside the virtual time of lockstep.
  static std::once_flag once;
  std::call_once(once, [] { setenv("LP_NUM_THREADS", "0", /*overwrite=*/0); });
}

}  // namespace eyebridge::camera
