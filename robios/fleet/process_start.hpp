#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/hal/config.hpp"

namespace eyebridge::robios {

/// The variables of a process that runs the program of robot `index`, whose line to its server is
/// `descriptor` there: this process's, with the settings `config` as they count here, but for those
/// of one robot alone. Its results go to `out`; "" for none.
std::vector<std::string> environment_of(const hal::Config& config, std::size_t index,
                                        int descriptor, const std::filesystem::path& out);

}  // namespace eyebridge::robios
