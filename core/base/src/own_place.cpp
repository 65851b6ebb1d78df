#include "eyebridge/base/own_place.hpp"

#include <system_error>

#include <dlfcn.h>
#include <link.h>

namespace eyebridge {

namespace fs = std::filesystem;

namespace {

/// The folder `name` in the nearest folder above `binary` that has one.
fs::path nearest(const fs::path& binary, const char* name) {
  std::error_code error;
  fs::path folder = fs::canonical(binary, error);
  while (!error && folder.has_relative_path()) {
    folder = folder.parent_path();
    fs::path found = folder / name;
    std::error_code unreadable;
    if (fs::is_directory(found, unreadable)) return found;
  }
  return {};
}

}  // namespace

fs::path own_binary() {
  Dl_info info{};
  link_map* map = nullptr;
  static const char here = 0;
  if (dladdr1(&here, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) == 0) return {};
  // dladdr() names the program itself by its first argument, which need not be its path.
  const bool is_program = map == nullptr || map->l_name[0] == '\0';
  std::error_code error;
  const fs::path found = fs::canonical(is_program ? "/proc/self/exe" : map->l_name, error);
  return error ? fs::path() : found;
}

fs::path share_folder(const fs::path& binary) { return nearest(binary, "share/eyebridge"); }

fs::path plugin_folder(const fs::path& binary) { return nearest(binary, EYEBRIDGE_PLUGIN_DIR); }

fs::path python_folder(const fs::path& binary) {
  const fs::path plugins = plugin_folder(binary);
  if (plugins.empty()) return {};
  // A wheel cannot hold links: there the plug-ins are in site-packages/eyebridge/lib/eyebridge.
  const fs::path site = plugins.parent_path().parent_path().parent_path();
  for (const fs::path& folder : {plugins / "python", site}) {
    std::error_code unreadable;
    if (fs::exists(folder / "eye/__main__.py", unreadable)) return folder;
  }
  return {};
}

}  // namespace eyebridge
