#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {

/// One thing that can be configured. The table of these is the only list of keys there is: flags,
/// environment variables, `eyebridge.toml`, `eyebridge config` and the documentation follow it.
struct Setting {
  /// A NumberOrText is a text that TOML may have as a whole number, too.
  enum class Kind { Text, NumberOrText, Path, Boolean, Integer, Number, Duration, Size };

  std::string_view key;  ///< "world"; flag --world, variable EYEBRIDGE_WORLD, TOML key world.
  Kind kind;
  std::string_view fallback;  ///< Value when nobody says anything; "" means unset.
  std::string_view help;      ///< One line.
  double minimum =
      -std::numeric_limits<double>::infinity();  ///< Of an Integer, Number, Duration, Size.
  double maximum = std::numeric_limits<double>::infinity();  ///< Likewise; seconds for Durations,
                                                             ///< each side's pixels for Sizes.
  std::string_view choices = {};  ///< Of a Text: "a|b|c" when nothing else is allowed.
  /// What a value does that a folder's file may not do by itself; see Trust.
  enum class Effect { None, Starts, Writes } effect = Effect::None;
};

/// All settings, in the order they are shown.
std::span<const Setting> settings();

/// The row of `key`, or null when there is none.
const Setting* find_setting(std::string_view key);

/// The key in settings() that `key` was most likely meant to be (fewest edits; the first of
/// equals).
std::string_view nearest_key(std::string_view key);

/// A value and where it came from: "--world", "EYEBRIDGE_WORLD", "eyebridge.toml:3:9", "default".
/// An empty text is "unset", allowed for settings whose fallback is empty.
struct ConfigValue {
  std::string text;
  SourceLocation where;

  /// True when nobody set it.
  [[nodiscard]] bool is_default() const { return where.file == "default"; }
};

/// `error`, which was found while reading the text of `value`, at the place where the value was
/// set. The error's column is that within the text, kept where the place has none of its own.
ConfigError error_in(const ConfigValue& value, const ConfigError& error);

/// Width and height of a picture, pixels.
struct PixelSize {
  int width = 0;
  int height = 0;

  friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// The variable in which a configuration travels to another process: Config::plan().
inline constexpr const char* kPlanVariable = "EYEBRIDGE_PLAN";

/// Effective configuration. Precedence: command line > environment > eyebridge.toml (working
/// folder, then beside the program, then the user's) > defaults. Immutable once loaded.
class Config {
 public:
  /// Where to look; all explicit, so that tests need no real environment.
  struct Sources {
    std::map<std::string, std::string> flags;        ///< Key -> value, from the command line.
    std::map<std::string, std::string> environment;  ///< All variables of the process.
    std::vector<std::filesystem::path>
        toml_files;    ///< Highest precedence first; missing ones skipped.
    long process = 0;  ///< Its id.
    /// Whether `file`, one of these, may ask for `asked`: see asked_by(). Unset: for everything.
    std::function<bool(const std::string& file, const std::string& asked)> may_ask = {};
  };

  /// Throws ConfigError: unknown key (with line and column, and the nearest known one), or a value
  /// that is not of the setting's kind, out of its range or not one of its choices. Every source is
  /// checked whole, also where another one wins. A value that counts, has an effect and comes from
  /// a file that may not ask for it is an error. Variables that start with EYEBRIDGE_ count as
  /// keys, except EYEBRIDGE_PLAN, EYEBRIDGE_DATA and EYEBRIDGE_TEST_*. Without flags,
  /// EYEBRIDGE_PLAN counts: see plan().
  static Config load(const Sources& sources);
  /// That of the robot program `program`, in its process: by the plan that it was started with, the
  /// variables EYEBRIDGE_*, and the three usual places of eyebridge.toml. The name of a world
  /// becomes the path of its file (files::find_file()). A name without a file is kept: opening it
  /// throws the error that lists the folders searched.
  static Config from_process(const std::filesystem::path& program);
  /// That of `program` when this command starts it with `flags`. A plan that this process was
  /// started with does not count.
  static Config from_command_line(const std::filesystem::path& program,
                                  const std::map<std::string, std::string>& flags);

  /// This configuration as the text of EYEBRIDGE_PLAN, in which it travels to the program that this
  /// process becomes. That takes it as it is. Where it has set a variable EYEBRIDGE_* or changed
  /// its folder meanwhile, and in other processes that it starts, only the flags count, of these
  /// not those that write.
  [[nodiscard]] std::string plan() const;
  /// The same for a process that takes it as it is whatever it finds.
  [[nodiscard]] std::string sealed_plan() const;
  /// From now on the settings that write are this process's alone, which has begun to write: its
  /// children inherit the others. (A script that starts a robot program passes all of them on.)
  /// Changes the environment: no other thread may read that meanwhile.
  void keep_outputs() const;

  [[nodiscard]] const ConfigValue& value(
      std::string_view key) const;                        ///< Key must be in settings().
  [[nodiscard]] bool is_set(std::string_view key) const;  ///< Text not empty.
  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] bool boolean(std::string_view key) const;
  [[nodiscard]] long long integer(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key) const;   ///< Number, or Duration in seconds.
  [[nodiscard]] PixelSize size(std::string_view key) const;  ///< Of a Size.
  /// A Path: relative ones are taken from where they were written (the TOML file's folder, else the
  /// working folder).
  [[nodiscard]] std::filesystem::path path(std::string_view key) const;

  /// This configuration with another value of `key`, which must be in settings(); not checked.
  [[nodiscard]] Config with(std::string_view key, ConfigValue value) const;

  /// How `key` is spelled as a flag: "--time-limit".
  static std::string flag_name(std::string_view key);
  /// How `key` is spelled as an environment variable: "EYEBRIDGE_TIME_LIMIT".
  static std::string variable_name(std::string_view key);
  /// All settings as lines "key = value  # where", in the order of settings().
  [[nodiscard]] std::string describe() const;
  /// The robot program that from_process() was given: worlds are looked for beside it.
  [[nodiscard]] const std::filesystem::path& program() const { return program_; }

 private:
  static Config of_program(const std::filesystem::path& program, const Sources& sources);

  std::map<std::string, ConfigValue, std::less<>> values_;
  std::string sources_;  ///< Fingerprint of what it was loaded from.
  std::filesystem::path program_;
};

/// Whether `file` is the eyebridge.toml of the user's own configuration.
bool is_users_own(const std::string& file);

/// Whether `text` for `setting` does what a folder's file may not do by itself.
bool has_effect(const Setting& setting, std::string_view text);

/// "record = /home/me/run.ebrec": what a file asks for that says `text` for `setting`, as Trust
/// keeps it.
std::string asked_by(const Setting& setting, const std::string& text);

/// What the eyebridge.toml `file` asks for that has an effect. Throws ConfigError.
std::vector<std::string> asked_by_file(const std::filesystem::path& file);

/// What `read` makes of the text of `key`, and of an unknown place if it takes one. A ConfigError
/// of it is thrown at the place where the value was set.
template <class Read>
auto from_setting(const Config& config, std::string_view key, Read&& read) {
  const ConfigValue& value = config.value(key);
  try {
    if constexpr (std::is_invocable_v<Read, const std::string&, SourceLocation>) {
      return read(value.text, SourceLocation{});
    } else {
      return read(value.text);
    }
  } catch (const ConfigError& error) {
    throw error_in(value, error);
  }
}

/// "560x400": width and height. Throws ConfigError at `where`; checks no range.
PixelSize parse_size(std::string_view text, const SourceLocation& where);

}  // namespace eyebridge::hal
