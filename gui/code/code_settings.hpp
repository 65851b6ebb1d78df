#pragma once

#include <QString>

namespace eyebridge::gui {

/// Where the code panel finds what it starts, and leaves what it writes. Paths are absolute.
struct CodeSettings {
  QString eyebridge;  ///< The command, the two compilers …
  QString c_compiler;
  QString cpp_compiler;
  QString examples;  ///< Folders: of programs to begin with …
  QString worlds;    ///< … and of worlds to choose from; either may be missing.
  QString drafts;    ///< Folder of unsaved texts (recovery.hpp).
  QString builds;    ///< Folder of what is built.
  QString world;     ///< The world that is chosen at first; "" is the one of last time.

  /// Those of the installation, or of the build tree, that this code is in.
  static CodeSettings defaults();
};

}  // namespace eyebridge::gui
