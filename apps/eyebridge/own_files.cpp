#include "own_files.hpp"

namespace eyebridge::apps {

OwnFiles own_files() {
  namespace fs = std::filesystem;
  const fs::path bin = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path prefix = bin.parent_path();
  if (bin == fs::path(EYEBRIDGE_BUILD_DIR) / "bin") {
    const fs::path source = EYEBRIDGE_SOURCE_DIR;
    return {prefix / "lib/libeyebridge.so",
            source / "robios/include/eyebot.h",
            source / "worlds",
            source / "tests/lab",
            prefix / "firmware/eyebridge-mps2.elf",
            source / "apps/udev/60-eyebridge.rules",
            prefix / "python"};
  }
  return {prefix / "lib/libeyebridge.so",
          prefix / "include/eyebridge/eyebot.h",
          prefix / "share/eyebridge/worlds",
          prefix / "share/eyebridge/lab",
          prefix / "share/eyebridge/firmware/eyebridge-mps2.elf",
          prefix / "share/eyebridge/udev/60-eyebridge.rules",
          prefix / "lib/eyebridge/python"};
}

}  // namespace eyebridge::apps
