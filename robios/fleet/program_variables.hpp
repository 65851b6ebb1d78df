#pragma once

#include <cstddef>
#include <string>
#include <vector>

struct link_map;

namespace eyebridge::robios {

/// A program image's own copies of library variables: ours (CAMWIDTH and the like) and the standard
/// streams of C++. Without them all robots would share one variable.
///
/// The compiler decides how a program reaches a library's variable. With a copy relocation (x86-64)
/// the dynamic linker makes the copy. With the global offset table (arm64, and -fPIC everywhere)
/// the program uses the library's variable; this class makes a copy and changes the table.
class ProgramVariables {
 public:
  ProgramVariables() = default;
  /// `image` is loaded and its constructors have not run. Its relocated addresses must be writable
  /// (ProgramFile).
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
