#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <tuple>

#include "eyebridge/files/search.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kWorlds = {".wld", ".maz", ".sim", ".p"};

bool is_world(const std::string& ending) {
  return std::ranges::find(kWorlds, ending) != kWorlds.end();
}

/// An ending that nobody types by mistake where a world is meant.
bool is_part(const std::string& ending) { return ending == ".robi" || ending == ".esobj"; }

struct Candidate {
  std::size_t edits = 0;
  std::string name;

  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

/// What was asked for: a folder, a name and an ending, in lower case.
class Wanted {
 public:
  explicit Wanted(const fs::path& written)
      : folder_(written.parent_path()),
        stem_(lower(written.stem().string())),
        ending_(lower(written.extension().string())) {}

  /// Adds the files of `folder` that are near enough, as `prefix` and their name.
  void look_in(const fs::path& folder, const fs::path& prefix, std::vector<Candidate>& out) const {
    std::error_code error;
    for (fs::directory_iterator file(folder.empty() ? "." : folder, error), end;
         !error && file != end; file.increment(error)) {
      const std::string ending = lower(file->path().extension().string());
      const bool is_same = ending == ending_;
      if (!is_same && (is_part(ending_) || !is_world(ending))) continue;
      const std::string stem = lower(file->path().stem().string());
      if (stem.size() > kLongest) continue;
      const std::size_t edits = edit_distance(stem_, stem) + (is_same || ending_.empty() ? 0 : 1);
      // Three edits turn any short name into any other: they must leave most of it standing.
      if (edits > 3 || 2 * edits >= std::max<std::size_t>(stem.size(), 1)) continue;
      out.push_back({edits, (prefix / file->path().filename()).string()});
    }
  }

  void look_below(const fs::path& folder, std::vector<Candidate>& out) const {
    if (stem_.size() > kLongest) return;
    look_in(folder / folder_, folder_, out);
    if (!folder_.empty()) look_in(folder, {}, out);
  }

 private:
  static constexpr std::size_t kLongest = 100;

  fs::path folder_;
  std::string stem_;
  std::string ending_;
};

}  // namespace

std::vector<std::string> similar_files(const std::string& written,
                                       const std::vector<fs::path>& folders) {
  constexpr std::size_t kMost = 3;
  const Wanted wanted(written);
  std::vector<Candidate> found;
  for (const fs::path& folder : folders) wanted.look_below(folder, found);
  std::ranges::sort(found);
  // clang 14 cannot read the std::ranges::unique() of libstdc++ 12.
  found.erase(std::unique(found.begin(), found.end(),
                          [](const Candidate& a, const Candidate& b) { return a.name == b.name; }),
              found.end());
  std::vector<std::string> out;
  for (std::size_t i = 0; i < std::min(kMost, found.size()); ++i) out.push_back(found[i].name);
  return out;
}

}  // namespace eyebridge::files
