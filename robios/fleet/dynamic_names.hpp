#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eyebridge::robios {

/// What a program's file asks of the dynamic linker, by name.
struct DynamicNames {
  std::vector<std::string> libraries;
  std::string folders;              ///< Where to look for them first, "a:b:".
  std::vector<std::string> wanted;  ///< Functions and variables of theirs that it uses.
};

/// Of a file of this machine's kind (elf(5), 64 bits); nothing of any other, or without a dynamic
/// section. What lies outside of the file counts as empty.
std::optional<DynamicNames> dynamic_names(std::span<const char> file);

}  // namespace eyebridge::robios
