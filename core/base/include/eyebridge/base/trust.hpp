#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace eyebridge {

/// What a user lets the files of a folder ask for that starts programs or writes files
/// (docs/security.md): what is asked for is kept word by word, in a file for each file. When it
/// changes in the folder, the user has not agreed to it.
class Trust {
 public:
  /// One file and what it may ask for.
  struct Entry {
    std::filesystem::path file;
    std::vector<std::string> asked;
  };

  /// That of the user of this process: $XDG_DATA_HOME/eyebridge/trusted, where that is unset
  /// ~/.local/share/eyebridge/trusted. Without either nothing is trusted.
  static Trust of_user();

  /// Kept in `folder`, which give() makes. Empty: nothing is trusted.
  explicit Trust(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Whether `file` may ask for `asked`.
  [[nodiscard]] bool covers(const std::filesystem::path& file, std::string_view asked) const;

  /// From now on `file` may ask for `asked` and nothing else. Throws
  /// std::filesystem::filesystem_error when that cannot be kept.
  void give(const std::filesystem::path& file, const std::vector<std::string>& asked) const;

  /// False when `file` was not trusted.
  bool take_back(const std::filesystem::path& file) const;

  /// All that is trusted, by file.
  [[nodiscard]] std::vector<Entry> entries() const;

 private:
  [[nodiscard]] std::filesystem::path place_of(const std::filesystem::path& file) const;

  std::filesystem::path folder_;
};

/// The end of a message about something that Trust does not cover: what to do.
std::string how_to_trust(const std::filesystem::path& file);

/// Whether `file` lies in `folder` or below it, where their symbolic links lead.
bool is_within(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace eyebridge
