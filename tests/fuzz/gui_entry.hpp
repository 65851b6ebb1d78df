#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

#include "code/messages.hpp"

// As entry.hpp, for what the windows read.
namespace eyebridge::fuzz {

/// A place is in its line, and is found again when it is written as compilers do.
inline void message(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    const auto found = gui::find_message(line);
    if (!found) continue;
    if (found->file.empty() || found->line < 1 || found->column < 0) std::abort();
    if (found->begin >= found->end || found->end > line.size()) std::abort();
    const std::string_view place = line.substr(found->begin, found->end - found->begin);
    if (place.find(found->file) == place.npos) std::abort();
    // Names with blanks, colons and quotes depend on what stands around them.
    if (found->file.find_first_of(" \t:\"(") != std::string::npos) continue;
    const std::string again = found->file + ":" + std::to_string(found->line) + ": error: x";
    const auto second = gui::find_message(again);
    const bool has_name = found->file.find_first_of("./") != std::string::npos;
    if (second && (second->file != found->file || second->line != found->line)) std::abort();
    // Python quotes names that no compiler would take for one.
    if (!second && has_name && place.find('"') == place.npos) std::abort();
  }
}

}  // namespace eyebridge::fuzz
