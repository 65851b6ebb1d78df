#pragma once

#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace eyebridge::apps {

/// What can come next on a command line.
struct Completions {
  enum class Files { None, Any, Folders };
  struct Word {
    std::string text;  ///< The whole word, not only its missing end.
    std::string help;  ///< One line, "" if there is nothing to say.
  };

  std::vector<Word> words;
  Files files = Files::None;  ///< Which files of the disk can come next as well.
  bool goes_on = false;       ///< What is behind such a word belongs to it: "serial:/dev/ttyACM0".
};

/// What can come after `before`, the words behind "eyebridge", and begins with `current`. It knows
/// what `root` knows: subcommands, options, and by the names of their types what their values are.
Completions complete(const CLI::App& root, std::span<const std::string> before,
                     const std::string& current);

}  // namespace eyebridge::apps
