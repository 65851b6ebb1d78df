#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/files/scenario.hpp"

namespace eyebridge::files {

/// The file that the scenario in the file `scenario` means by the program `name`: looked for beside
/// it, then in the working folder; `explorer.x` may also be called `explorer`. `name` itself where
/// there is none.
std::filesystem::path program_file(const std::string& name, const std::filesystem::path& scenario);

/// What `scenario` asks for when it starts that program, as Trust keeps it; nothing where the
/// program lies in the folder of the scenario or below, or where there is none.
std::optional<std::string> asked_for(const std::string& name,
                                     const std::vector<std::string>& arguments,
                                     const std::filesystem::path& scenario);

/// The same for all robots of `scenario`, read from `file`; each once.
std::vector<std::string> asked_by(const Scenario& scenario, const std::filesystem::path& file);

}  // namespace eyebridge::files
