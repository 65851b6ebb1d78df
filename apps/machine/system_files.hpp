#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eyebridge::apps {

// Reading what Linux says of itself. `root` is the folder that counts as "/": tests have another
// one. Nothing here throws or changes anything: what cannot be read is not there.

/// Where `path`, which begins with '/', lies below `root`.
std::filesystem::path below(const std::filesystem::path& root, std::string_view path);

/// The first line of a file of /sys or /proc, without blanks around it.
std::optional<std::string> line_of(const std::filesystem::path& file);
/// That line as a decimal number.
std::optional<long> number_of(const std::filesystem::path& file);

/// Names in `folder` that begin with one of `prefixes`, sorted; all when there is none.
std::vector<std::string> names_in(const std::filesystem::path& folder,
                                  std::initializer_list<std::string_view> prefixes = {});

/// A process that runs.
struct Process {
  int id = 0;        ///< 0: one that this container does not show.
  std::string name;  ///< "ModemManager"; at most 15 characters, as the kernel keeps it.

  friend bool operator==(const Process&, const Process&) = default;
};

/// All processes, by id.
std::vector<Process> processes(const std::filesystem::path& root);

/// "ModemManager (process 812)"
std::string described(const Process& process);

}  // namespace eyebridge::apps
