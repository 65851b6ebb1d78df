#pragma once

#include <filesystem>

namespace eyebridge::apps {

/// Where our own files lie: after an installation beside this program's prefix, else in the trees
/// that it was built from and in.
struct OwnFiles {
  std::filesystem::path library;   ///< libeyebridge.so
  std::filesystem::path header;    ///< eyebot.h
  std::filesystem::path worlds;    ///< Folder.
  std::filesystem::path lab;       ///< Folder of the lab's scripts.
  std::filesystem::path firmware;  ///< eyebridge-mps2.elf
  std::filesystem::path udev;      ///< The rules for udev.
  std::filesystem::path python;    ///< Folder of the Python packages.
};

/// Does not say whether they exist. Throws std::filesystem::filesystem_error without /proc.
OwnFiles own_files();

}  // namespace eyebridge::apps
