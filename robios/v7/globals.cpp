#include "globals.hpp"

#include <map>
#include <mutex>
#include <string_view>

#include "session.hpp"

namespace eyebridge::robios {
namespace {

/// The variables of one of several robots.
struct ShownVariables {
  struct Variable {
    int spare = 0;  ///< For a program that does not use it.
    int* place = nullptr;
  };
  std::mutex mutex;
  std::map<std::string_view, Variable> variables;
};

}  // namespace

int& shown(int& ours, const char* name) {
  Session* const robot = Session::here();
  if (robot == nullptr) return ours;
  auto& shown = robot->own<ShownVariables>();
  const std::lock_guard lock(shown.mutex);
  auto& variable = shown.variables[name];
  if (variable.place == nullptr) {
    // With several robots nobody writes the process's: it still has what it began with.
    variable.spare = ours;
    auto* const in_program = static_cast<int*>(robot->variable(name));
    variable.place = in_program != nullptr ? in_program : &variable.spare;
  }
  return *variable.place;
}

}  // namespace eyebridge::robios
