#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace eyebridge::robios {

/// What a program's file asks of the dynamic linker. The texts are the file's own: a damaged file
/// that names one long text a million times takes no more memory than itself.
struct DynamicNames {
  std::vector<std::string_view> libraries;
  std::string_view folders;              ///< Where to look for them first, "a:b".
  std::vector<std::string_view> wanted;  ///< Functions and variables of theirs that it uses.
};

/// Of a file of this machine's kind (elf(5), 64 bits); nothing of any other, or without a dynamic
/// section. What lies outside of the file counts as empty.
std::optional<DynamicNames> dynamic_names(std::span<const char> file);

}  // namespace eyebridge::robios
