#include "key_script.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::robios {
namespace {

struct RemoteKey {
  std::string_view name;
  char code;
};
// As in eyebot.h.
constexpr std::array<RemoteKey, 10> kRemoteKeys = {{{"RED", 'R'},
                                                    {"GREEN", 'G'},
                                                    {"YELLOW", 'Y'},
                                                    {"BLUE", 'B'},
                                                    {"LEFT", 'L'},
                                                    {"RIGHT", '>'},
                                                    {"UP", 'U'},
                                                    {"DOWN", 'D'},
                                                    {"OK", 'O'},
                                                    {"POWER", 'P'}}};

constexpr double kLatest = 1e9;  // seconds; keeps Time far from overflow

/// Walks over the script and knows its column for error messages.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  [[nodiscard]] bool at_end() const { return position_ == text_.size(); }

  void skip_blanks() {
    while (!at_end() && (text_[position_] == ' ' || text_[position_] == '\t')) {
      ++position_;
    }
  }

  bool accept(std::string_view word) {
    if (text_.substr(position_).substr(0, word.size()) != word) {
      return false;
    }
    position_ += word.size();
    return true;
  }

  template <class Number>
  Number number(const char* expected) {
    Number value{};
    const char* begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc{}) {
      reject(expected);
    }
    position_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  [[noreturn]] void reject(const std::string& expected) const { reject_at(position_, expected); }

  [[noreturn]] void reject_at(std::size_t position, const std::string& expected) const {
    std::string found(text_.substr(position, text_.find(',', position) - position));
    constexpr std::size_t kLongest = 40;
    if (found.size() > kLongest) {
      found = found.substr(0, kLongest) + "…";
    }
    throw ConfigError(
        {"--keys", 1, static_cast<int>(position) + 1},
        (found.empty() ? "found nothing" : "found '" + found + "'") + ", expected " + expected);
  }

  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

Time read_time(Reader& in) {
  const std::size_t start = in.position();
  double seconds = in.number<double>("a time like 2s, 250ms or 1min");
  if (in.accept("ms")) {
    seconds /= 1000.0;
  } else if (in.accept("min")) {
    seconds *= 60.0;
  } else {
    in.accept("s");
  }
  if (!(seconds >= 0.0 && seconds <= kLatest)) {
    in.reject_at(start, "a time from 0 s to 1e9 s");
  }
  return from_seconds(seconds);
}

int read_remote(Reader& in) {
  for (char digit = '0'; digit <= '9'; ++digit) {
    if (in.accept({&digit, 1})) return digit;
  }
  for (const RemoteKey& key : kRemoteKeys) {
    if (in.accept(key.name)) return key.code;
  }
  in.reject(
      "a key of the remote control: 0..9, RED, GREEN, YELLOW, BLUE, LEFT, RIGHT, UP, DOWN, OK "
      "or POWER");
}

/// Whether a key by its name follows, which is read then.
bool read_named(Reader& in, ScriptedKey& key) {
  if (in.accept("IRTV_")) {
    key.remote = read_remote(in);
    return true;
  }
  if (!in.accept("KEY")) return false;
  const std::size_t start = in.position();
  const int number = in.number<int>("a key number 1..4");
  if (number < 1 || number > 4) {
    in.reject_at(start, "a key number 1..4");
  }
  key.key = 1 << (number - 1);
  return true;
}

/// "KEY1", "IRTV_5", "120:80", each also after the number of a robot and a colon.
void read_what(Reader& in, ScriptedKey& key) {
  if (read_named(in, key)) return;
  const std::size_t start = in.position();
  const int first = in.number<int>("KEY1..KEY4, IRTV_5 or a touch like 120:80");
  if (!in.accept(":")) {
    in.reject("':' and the y of a touch");
  }
  const auto take_robot = [&] {
    if (first < 1) in.reject_at(start, "the number of a robot, from 1");
    key.robot = first;
  };
  if (read_named(in, key)) return take_robot();
  const int second = in.number<int>("the y of a touch, in pixels, or a key of this robot");
  if (!in.accept(":")) {
    key.touch = {first, second};
    return;
  }
  take_robot();
  key.touch = {second, in.number<int>("the y of a touch, in pixels")};
}

ScriptedKey read_key(Reader& in) {
  ScriptedKey key;
  read_what(in, key);
  if (!in.accept("@")) {
    in.reject("'@' and a time");
  }
  key.at = read_time(in);
  return key;
}

}  // namespace

std::vector<ScriptedKey> parse_key_script(std::string_view text) {
  std::vector<ScriptedKey> script;
  Reader in(text);
  in.skip_blanks();
  while (!in.at_end()) {
    script.push_back(read_key(in));
    in.skip_blanks();
    if (in.at_end()) {
      break;
    }
    if (!in.accept(",")) {
      in.reject("',' or the end");
    }
    in.skip_blanks();
    if (in.at_end()) {
      in.reject("another key after ','");
    }
  }
  std::stable_sort(script.begin(), script.end(),
                   [](const ScriptedKey& a, const ScriptedKey& b) { return a.at < b.at; });
  return script;
}

}  // namespace eyebridge::robios
