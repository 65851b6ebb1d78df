#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace eyebridge::apps {

/// The commands below `command`, in the order of --help.
std::vector<const CLI::App*> subcommands_of(const CLI::App& command);

/// "--output", "-o"; none of a positional argument.
std::vector<std::string> names_of(const CLI::Option& option);

}  // namespace eyebridge::apps
