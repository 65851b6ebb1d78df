#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

#include "dynamic_names.hpp"

// As entry.hpp, for the files of robots' programs.
namespace eyebridge::fuzz {

/// Whatever the file: names are of the file, and end where a text does.
inline void program_names(std::string_view file) {
  const auto names = robios::dynamic_names(file);
  if (!names) return;
  for (const auto* list : {&names->libraries, &names->wanted}) {
    for (const std::string& name : *list) {
      if (file.find(name) == std::string_view::npos) std::abort();
    }
  }
}

}  // namespace eyebridge::fuzz
