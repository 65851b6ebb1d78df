#pragma once

#include <cstddef>
#include <string>
#include <vector>

struct link_map;

namespace eyebridge::robios {

/// The variables of libraries of which a program's image has copies of its own, as a program alone
/// has them: the library's variables (CAMWIDTH and the like) and the standard streams of C++.
///
/// How a program reaches a library's variable depends on the compiler. By a copy relocation (what
/// g++ and clang do on x86-64) the dynamic linker makes the copy. By the global offset table (on
/// arm64, and everywhere with -fPIC) the program reaches the library's own; here it gets a copy.
class ProgramVariables {
 public:
  ProgramVariables() = default;
  /// Of an image that is loaded, but for the constructors of its objects. Its relocated addresses
  /// must still be writable (ProgramFile).
  explicit ProgramVariables(const link_map& image);

  /// Where the image has its copy of the variable `name`; null when it has none.
  [[nodiscard]] void* find(const std::string& name) const;

 private:
  struct Variable {
    std::string name;
    void* place;
  };
  void add(const char* name, void* place, const void* original, std::size_t size);
  /// The copy that the image already has, or a new one; null for what all robots are to share.
  void* copy_of(const char* name, const void* original);

  std::vector<Variable> variables_;
};

}  // namespace eyebridge::robios
