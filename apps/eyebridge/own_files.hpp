#pragma once

#include <filesystem>

namespace eyebridge::apps {

/// What completes command lines, by shell.
struct CompletionFiles {
  std::filesystem::path bash;
  std::filesystem::path zsh;
  std::filesystem::path fish;
};

/// Where our own files lie, in an installation and in a build folder.
struct OwnFiles {
  std::filesystem::path library;   ///< libeyebridge.so.0
  std::filesystem::path header;    ///< eyebot.h
  std::filesystem::path worlds;    ///< Folder.
  std::filesystem::path lab;       ///< Folder of the lab's scripts.
  std::filesystem::path firmware;  ///< eyebridge-mps2.elf
  std::filesystem::path udev;      ///< The rules for udev.
  CompletionFiles completion;
};

/// Does not say whether they exist.
OwnFiles own_files();

}  // namespace eyebridge::apps
