#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace eyebridge::apps {

/// Finds the robot program `name`: with a slash as it stands, else in the working folder, else in
/// PATH. Throws ConfigError when there is none, or when it cannot be executed (a .py need only be
/// readable).
std::filesystem::path find_program(const std::string& name);

/// The executable file `name` in PATH; empty if there is none.
std::filesystem::path find_in_path(const std::string& name);

/// The Python that our compiled modules are for; in a virtual environment its own.
std::string python_of_modules();

/// True for a program that python3 runs.
bool is_python(const std::filesystem::path& program);

/// Becomes python3 with eyebridge.control, which runs the control file `program`. As become().
[[noreturn]] void become_control(const std::filesystem::path& program,
                                 const std::vector<std::string>& arguments);

/// Becomes `program` with `arguments`; a .py is run by python3, and Python finds our packages
/// (PYTHONPATH). Throws ConfigError when the system refuses; returns never.
[[noreturn]] void become(const std::filesystem::path& program,
                         const std::vector<std::string>& arguments);

}  // namespace eyebridge::apps
