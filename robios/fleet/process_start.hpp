#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/hal/config.hpp"

namespace eyebridge::robios {

/// The words that start `program`: itself, or python3 with our module `eye` for a .py.
std::vector<std::string> command_of(const std::filesystem::path& program,
                                    const std::vector<std::string>& arguments);

/// The variables of a process that runs the program of robot `index`, whose line to its server is
/// `descriptor` there: this process's, with the settings `config` as they count here, but for those
/// of one robot alone. Its results go to `out`; "" for none.
std::vector<std::string> environment_of(const hal::Config& config, std::size_t index,
                                        int descriptor, const std::filesystem::path& out);

}  // namespace eyebridge::robios
