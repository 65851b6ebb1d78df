#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

// What it takes to start a robot program, a binary or a Python file.
namespace eyebridge {

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
