#pragma once

#include <map>
#include <string>
#include <vector>

namespace eyebridge::testing {

/// What a finished program left behind.
struct ProgramRun {
  int exit_code = -1;  ///< 128 + signal when a signal ended it.
  std::string out;     ///< Standard output.
  std::string err;     ///< Standard error.
};

/// How to start a program.
struct ProgramStart {
  std::vector<std::string> command;  ///< Program first; found in PATH without a slash.
  std::map<std::string, std::string> environment;  ///< On top of this process's.
  std::string directory;                           ///< Working folder; this process's if empty.
};

/// Runs a program with an empty standard input to its end and collects both outputs. Under the leak
/// checker it does not answer for what lsan.supp lists.
/// A program that is still running after five minutes is killed, and the test fails by its exit
/// code.
ProgramRun run_program(const ProgramStart& start);

/// A fresh folder that goes away with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Writes a file in it and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
};

/// Lets `file` start programs outside of its folder, as `eyebridge trust` does; the variables with
/// which programs are to be run that find that out. Kept in `folder`.
std::map<std::string, std::string> trusted(const std::string& file, const ScratchFolder& folder);

/// The whole file, or "" when there is none.
std::string file_text(const std::string& path);

}  // namespace eyebridge::testing
