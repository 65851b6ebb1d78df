#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <span>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "eyebridge/base/text.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "host/host_sound.hpp"
#include "host/sound_file.hpp"
#include "host/tone.hpp"

namespace eyebridge::hal {
namespace {

struct PlayerRow {
  const char* name;
  const char* option;  ///< Quiet, without a window; "" for none.
  bool wav;
  bool mp3;
};
// In order of preference: what goes through the desktop's mixer first.
constexpr std::array<PlayerRow, 5> kPlayers = {{{"pw-play", "", true, true},
                                                {"paplay", "", true, true},
                                                {"aplay", "-q", true, false},
                                                {"mpg123", "-q", false, true},
                                                {"mplayer", "-really-quiet", true, true}}};

using Words = std::vector<std::string>;

Words split(std::string_view text) {
  Words words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

/// Starts `words` with nothing to read and nowhere to write. Its process number, or 0.
pid_t start(Words words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int fd : {0, 1, 2}) {
    posix_spawn_file_actions_addopen(&actions, fd, "/dev/null", O_RDWR, 0);
  }
  pid_t pid = 0;
  const int error = ::posix_spawn(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? pid : 0;
}

class PlayedSound final : public Sound {
 public:
  PlayedSound(std::string player, std::string path)
      : player_(std::move(player)), path_(std::move(path)) {}

  Result<void> tone(double frequency, double duration) override {
    if (auto good = check_tone(frequency, duration); !good) return good;
    const std::vector<std::uint8_t> wav = make_tone(frequency, duration);
    UniqueFd file(::memfd_create("eyebridge-tone", MFD_CLOEXEC));
    if (!file.valid() || ::write(file.get(), wav.data(), wav.size()) < 0) {
      return fail(Errc::Unsupported,
                  "sound: no memory for a tone: " + std::generic_category().message(errno));
    }
    // As others see a file that has no name.
    const std::string name =
        "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(file.get());
    return play(name, SoundFormat::Wav).map([&] {
      const std::lock_guard lock(mutex_);
      tone_ = std::move(file);
    });
  }

  Result<void> play(const std::string& path) override {
    const auto facts = read_sound_file(path);
    // A player that the user named may know more formats than we do.
    if (!facts && (player_ == "auto" || facts.error().code == Errc::OutOfRange)) {
      return tl::unexpected(facts.error());
    }
    return play(path, facts ? facts->format : SoundFormat::Wav);
  }

  Result<bool> is_playing() override {
    const std::lock_guard lock(mutex_);
    std::erase_if(playing_, [](pid_t pid) { return ::waitpid(pid, nullptr, WNOHANG) != 0; });
    return last_ != 0 && std::ranges::find(playing_, last_) != playing_.end();
  }

 private:
  Result<void> play(const std::string& path, SoundFormat format) {
    Words words = command_for(format);
    const bool found = !words.empty() && !(words[0] = find_in_path(words[0], path_)).empty();
    if (!found) return no_player();
    words.push_back(path);
    const pid_t pid = start(std::move(words));
    if (pid == 0) return no_player();
    (void)is_playing();  // those that have ended are not to stay as zombies
    const std::lock_guard lock(mutex_);
    playing_.push_back(pid);
    last_ = pid;
    return {};
  }

  [[nodiscard]] Words command_for(SoundFormat format) const {
    if (player_ != "auto") return split(player_);
    for (const PlayerRow& player : kPlayers) {
      if (!(format == SoundFormat::Wav ? player.wav : player.mp3)) continue;
      if (find_in_path(player.name, path_).empty()) continue;
      Words words{player.name};
      if (*player.option != '\0') words.emplace_back(player.option);
      return words;
    }
    return {};
  }

  [[nodiscard]] tl::unexpected<Error> no_player() const {
    if (player_ != "auto") {
      return fail(Errc::Unsupported, "sound: " + in_quotes(player_) +
                                         " is no program that can be started; see --player");
    }
    std::string names;
    for (const PlayerRow& player : kPlayers)
      names += (names.empty() ? "" : ", ") + std::string(player.name);
    return fail(Errc::Unsupported,
                "sound: found no player, expected one of " + names + "; --player none for silence");
  }

  const std::string player_;
  const std::string path_;
  std::mutex mutex_;
  std::vector<pid_t> playing_;
  pid_t last_ = 0;
  UniqueFd tone_;  ///< Of the last tone: its player may still read it.
};

}  // namespace

std::string find_in_path(const std::string& name, std::string_view path) {
  if (name.find('/') != std::string::npos) return name;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find(':'), path.size());
    std::string file = (std::filesystem::path(path.substr(0, end)) / name).string();
    if (end > 0 && ::access(file.c_str(), X_OK) == 0) return file;
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return "";
}

std::unique_ptr<Sound> make_played_sound(std::string player, std::string path) {
  return std::make_unique<PlayedSound>(std::move(player), std::move(path));
}

}  // namespace eyebridge::hal
