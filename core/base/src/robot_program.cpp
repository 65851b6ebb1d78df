#include "eyebridge/base/robot_program.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <unistd.h>

#include "eyebridge/base/own_place.hpp"

namespace eyebridge {

bool is_python(const std::filesystem::path& program) { return program.extension() == ".py"; }

std::string trouble_with(const std::filesystem::path& program) {
  std::error_code unreadable;
  if (!std::filesystem::exists(program, unreadable)) return "no such program";
  if (std::filesystem::is_directory(program, unreadable)) {
    return "found a folder, expected a robot program";
  }
  if (!std::filesystem::is_regular_file(program, unreadable)) {
    return "found no regular file, expected a robot program";
  }
  const bool wants_python = is_python(program);
  if (access(program.c_str(), wants_python ? R_OK : X_OK) != 0) {
    const std::string why = std::strerror(errno);
    if (wants_python) return "cannot be read: " + why;
    return "not executable (" + why +
           "); expected a program built with eyebridge-cc, or a Python file (.py)";
  }
  if (!wants_python || !python_folder().empty()) return "";
  return "found no Python packages of this EyeBridge, which a program in Python needs: install "
         "python3-eyebridge, or build with EYEBRIDGE_WITH_PYTHON=ON";
}

std::vector<std::string> words_to_start(const std::filesystem::path& program,
                                        const std::vector<std::string>& arguments) {
  // Not one that is looked for in PATH.
  std::vector<std::string> words = {program.has_parent_path() ? program.string()
                                                              : "./" + program.string()};
  if (is_python(program)) {
    // Through our module, so that it is ours even beside another eye.py, and its time from the
    // start.
    words = {"python3", (python_folder() / "eye").string(), program.string()};
  }
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

std::map<std::string, std::string> python_variables() {
  const std::string folder = python_folder().string();
  if (folder.empty()) return {};
  const char* const others = std::getenv("PYTHONPATH");
  const std::string rest = others != nullptr ? others : "";
  return {{"PYTHONPATH", rest.empty() || rest == folder ? folder : folder + ":" + rest}};
}

}  // namespace eyebridge
