#include "control_file.hpp"

#include <iterator>
#include <regex>
#include <string>

#include "eyebridge/base/read_file.hpp"
#include "eyebridge/base/robot_program.hpp"

namespace eyebridge::apps {

bool is_control_text(std::string_view text) {
  // Who else writes def run(robot, …) has other parameters. Annotations and defaults are no matter.
  static const std::regex head(
      R"(^def[ \t]+run[ \t]*\(\s*robot\b[^)]*\bkeep_going\b[^)]*\bbelief_space\b[^)]*\bmap_space\b[^)]*\binteract\b)");
  // Line by line: libstdc++ matches by recursion, and a long text would take all of the stack.
  for (std::size_t at = 0; at < text.size();) {
    const bool is_head = text.substr(at).starts_with("def run");
    if (is_head && std::regex_search(std::string(text.substr(at, 1000)), head)) return true;
    const std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) break;
    at = end + 1;
  }
  return false;
}

bool is_control_file(const std::filesystem::path& program) {
  if (!is_python(program)) return false;
  constexpr std::uintmax_t kLargest = 64U << 20U;
  return is_control_text(read_file(program, kLargest).value_or(""));
}

}  // namespace eyebridge::apps
