#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::robios {

/// What goes over a control socket at a time, either way.
using Words = std::vector<std::string>;

/// The first word of who wants a robot to leave; its number follows. Else a robot is to enter.
inline constexpr const char* kRemove = "remove";

/// Longest message, bytes.
inline constexpr std::size_t kLongestMessage = 65536;

/// The folder of the control sockets of this user's runs. Empty where there is none that belongs to
/// this user alone; made when it is missing.
std::filesystem::path control_folder();

/// The numbers of the processes that have a control socket, ascending; they may have ended since.
std::vector<pid_t> controllable_runs();

/// Where the control socket of process `pid` is.
std::filesystem::path control_socket_of(pid_t pid);

/// Opens that of this process; nothing when the system refuses.
UniqueFd open_control_socket();
/// Who connects next; waits for that. Nothing when `listener` is broken.
UniqueFd accept_next(const UniqueFd& listener);
/// Takes away the control socket of this process.
void close_control_socket() noexcept;

/// Connects to `pid`; nothing when nobody is there. What is left of a control socket whose process
/// has died is taken away.
UniqueFd connect_to_run(pid_t pid);

/// False when `words` could not be sent: too long, or the other side is gone.
bool send_words(const UniqueFd& socket, const Words& words);
/// The other side's words; nothing when it sends none, within `patience_s` seconds unless 0.
std::optional<Words> receive_words(const UniqueFd& socket, int patience_s = 0);

}  // namespace eyebridge::robios
