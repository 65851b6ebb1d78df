#include "own_files.hpp"

#include "eyebridge/base/own_place.hpp"

namespace eyebridge::apps {

OwnFiles own_files() {
  namespace fs = std::filesystem;
  fs::path share = share_folder();
  // Where it is expected, for messages.
  if (share.empty()) share = own_binary().parent_path().parent_path() / "share/eyebridge";
  const fs::path prefix = share.parent_path().parent_path();
  return {plugin_folder().parent_path() / "libeyebridge.so.0",
          prefix / "include/eyebridge/eyebot.h",
          share / "worlds",
          share / "lab",
          share / "firmware/eyebridge-mps2.elf",
          prefix / "lib/udev/rules.d/60-eyebridge.rules",
          {prefix / "share/bash-completion/completions/eyebridge",
           prefix / "share/zsh/vendor-completions/_eyebridge",
           prefix / "share/fish/vendor_completions.d/eyebridge.fish"}};
}

}  // namespace eyebridge::apps
