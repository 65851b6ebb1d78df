#pragma once

#include <cstdlib>
#include <string_view>

#include "dynamic_names.hpp"

// As entry.hpp, for the files of robots' programs.
namespace eyebridge::fuzz {

/// Whatever the file: names are of the file, and no more of them than it can hold.
inline void program_names(std::string_view file) {
  const auto names = robios::dynamic_names(file);
  if (!names) return;
  if (names->libraries.size() + names->wanted.size() > file.size()) std::abort();
  for (const auto* list : {&names->libraries, &names->wanted}) {
    for (const std::string_view name : *list) {
      if (name.data() < file.data() || name.end() > file.end()) std::abort();
    }
  }
}

}  // namespace eyebridge::fuzz
