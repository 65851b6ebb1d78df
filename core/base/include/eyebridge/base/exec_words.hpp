#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace eyebridge {

/// The environment of this process as "NAME=VALUE"; `changes` replaces or adds variables.
std::vector<std::string> environment_with(const std::map<std::string, std::string>& changes);

/// The array that execve() and posix_spawn() take: pointers into `words`, which must outlive it,
/// then null.
std::vector<char*> pointers_to(const std::vector<std::string>& words);

/// Becomes the program words[0], a path or a name in PATH. Returns only when the system refuses,
/// with errno. System calls only: for the child of a fork(), too.
void execute(char* const* words, char* const* environment);

/// True for a program that python3 runs.
bool is_python(const std::filesystem::path& program);

/// Why the robot program `program` cannot be started, in words; "" when nothing speaks against it.
std::string trouble_with(const std::filesystem::path& program);

/// The words that start the robot program `program`; a .py is run by python3.
std::vector<std::string> words_to_start(const std::filesystem::path& program,
                                        const std::vector<std::string>& arguments);

/// The variable with which Python finds our packages first; none where there are no packages.
std::map<std::string, std::string> python_variables();

}  // namespace eyebridge
