#include "open_panel.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

#include "terminal/terminal_panel.hpp"

namespace eyebridge::robios {
namespace {

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Someone who reads and types, and a terminal that can place its cursor.
bool has_person() {
  const std::string_view term = variable("TERM");
  return isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1 && !term.empty() && term != "dumb";
}

}  // namespace

std::unique_ptr<TerminalPanel> open_panel(const hal::Config& config, const Screen& screen,
                                          bool has_windows) {
  const hal::ConfigValue& panel = config.value("panel");
  const bool is_auto = panel.text == "auto";
  if (panel.text == "none") return nullptr;
  if (is_auto && (has_windows || config.boolean("fast") || !has_person())) return nullptr;
  // Of its own: programs close standard input and output, or have them elsewhere.
  UniqueFd terminal(open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC));
  if (!terminal.valid()) {
    if (is_auto) return nullptr;
    throw ConfigError(
        panel.where, std::string("'term' needs a terminal, and this process has none (/dev/tty: ") +
                         std::strerror(errno) + "); expected none or auto");
  }
  return std::make_unique<TerminalPanel>(std::move(terminal), screen,
                                         colour_depth(variable("TERM"), variable("COLORTERM")));
}

}  // namespace eyebridge::robios
