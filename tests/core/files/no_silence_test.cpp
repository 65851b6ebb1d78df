// Whatever is changed in a valid file changes what is read, or gives a message.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <random>

#include <gmock/gmock.h>

#include "eyebridge/files/map_files.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

constexpr int kMutations = 100000;  // in all

/// Reads with `read(text, warnings)`; `same` compares two models.
template <class Read, class Same>
class TellTale {
 public:
  TellTale(Read read, Same same) : read_(read), same_(same) {}

  /// True when `changed` reads otherwise than `text`, or a message tells of it.
  bool tells(const std::string& text, const std::string& changed) const {
    std::vector<Warning> before;
    const auto model = read_(text, before);
    std::vector<Warning> after;
    try {
      const auto other = read_(changed, after);
      return !same_(model, other) || texts_of(before) != texts_of(after);
    } catch (const ConfigError&) {
      return true;
    }
  }

 private:
  static std::vector<std::string> texts_of(const std::vector<Warning>& warnings) {
    std::vector<std::string> out;
    for (const Warning& warning : warnings) out.push_back(warning.text);
    return out;
  }

  Read read_;
  Same same_;
};

/// A word as it counts: numbers by their value, words without case.
std::string meaning_of(const std::string& word) {
  if (const std::size_t equals = word.find('='); equals != std::string::npos && equals > 0) {
    return word.substr(0, equals + 1) + meaning_of(word.substr(equals + 1));
  }
  double value = 0;
  const char* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc{} && stop == end) {
    return std::to_string(value == 0 ? 0.0 : value == -180 ? 180.0 : value);  // half a turn
  }
  std::string out;
  for (const char c : word) out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// What a text of lines and words says: without comments, blanks and quotes. Lines with one of
/// `unused` as their first word say nothing: they are checked, and documented as not used.
std::vector<std::vector<std::string>> words_of(const std::string& text,
                                               const std::vector<std::string>& unused) {
  std::vector<std::vector<std::string>> lines;
  std::vector<std::string> line;
  std::string word;
  bool comment = false;
  const auto end_word = [&] {
    if (!word.empty()) line.push_back(meaning_of(word));
    word.clear();
  };
  for (const char c : text + "\n") {
    if (c == '\n') {
      end_word();
      const bool is_usual = line == std::vector<std::string>{"drive", "differential_drive"} ||
                            line == std::vector<std::string>{"name", "s4"};
      if (line.size() > 5 && line[0] == "ir") line.erase(line.begin() + 5);  // its height
      const bool counts =
          !line.empty() && !is_usual && std::ranges::find(unused, line[0]) == unused.end();
      if (counts) lines.push_back(line);
      line.clear();
      comment = false;
    } else if (comment || c == '#' || c == ';') {
      comment = true;
    } else if (c == ' ' || c == '\t' || c == '\r') {
      end_word();
    } else if (c != '"' && c != '\'' && c != '%') {  // of errors, per cent are meant without a word
      word += c;
    }
  }
  return lines;
}

/// What a drawing says: a dot is a blank, those at the end of a line are none, nor are empty lines
/// around it. Where EyeSim's walls end, an underscore beside one only draws it on.
std::string drawing_of(const std::string& text) {
  const bool has_posts = text.find("---") != std::string::npos;
  const auto goes_on = [](char c) {
    return c == '_' || std::isupper(static_cast<unsigned char>(c));
  };
  std::string out;
  std::string line;
  for (const char c : text + "\n") {
    if (c != '\n') {
      line += c == '.' || c == '\r'   ? ' '
              : has_posts && c == '_' ? '-'
              : has_posts && c == '+' ? 'o'
                                      : c;
      continue;
    }
    const std::string drawn = line;
    for (std::size_t i = 0; !has_posts && i < line.size(); i += 2) {
      const bool is_joint =
          (i > 0 && goes_on(drawn[i - 1])) || (i + 1 < drawn.size() && goes_on(drawn[i + 1]));
      if (line[i] == '_' && is_joint) line[i] = ' ';
    }
    line.erase(line.find_last_not_of(' ') + 1);
    if (!out.empty() || !line.empty()) out += line + '\n';
    line.clear();
  }
  while (out.ends_with("\n\n")) out.pop_back();
  // A start in the lower left cell of a contest's maze is where it is without a word.
  const std::size_t lowest = out.rfind("\n|");
  if (has_posts && lowest != std::string::npos) {
    for (std::size_t i = lowest + 2; i < lowest + 5; ++i) {
      if (out[i] == 'S') out[i] = ' ';
    }
  }
  // The size of a cell: a number, and a comment may follow it.
  const std::size_t last = out.rfind('\n', out.size() - 2) + 1;
  const auto size = words_of(out.substr(last), {});
  if (size.size() == 1 && size[0].size() == 1 &&
      std::isdigit(static_cast<unsigned char>(size[0][0][0]))) {
    out.erase(last);
    if (size[0][0] != meaning_of("360")) out += size[0][0] + "\n";  // EyeSim's without a word
  }
  while (out.ends_with("\n\n")) out.pop_back();
  return out;
}

/// `text` with one change: another character, one more, one less, or a line less.
std::string changed(const std::string& text, std::mt19937& dice) {
  static const std::string kCharacters = "0123456789 -+.|_oXSGaez#\"'\n[]:,";
  std::string out = text;
  const std::size_t at = dice() % out.size();
  const char c = kCharacters[dice() % kCharacters.size()];
  switch (dice() % 5) {
    case 0:
    case 1:
      out[at] = c;
      break;
    case 2:
      out.insert(at, 1, c);
      break;
    case 3:
      out.erase(at, 1);
      break;
    default: {
      const std::size_t begin = text.rfind('\n', at) + 1;
      const std::size_t end = std::min(text.find('\n', at) + 1, text.size());
      if (end > begin) out.erase(begin, end - begin);
    }
  }
  return out;
}

template <class Read, class Same, class Meaning>
void look(const std::vector<std::filesystem::path>& files, int mutations, Read read, Same same,
          Meaning meaning) {
  const TellTale reader(read, same);
  std::mt19937 dice(5);
  int silent = 0;
  for (const std::filesystem::path& file : files) {
    const std::string text = read_maze_file(file);
    for (int i = 0; i < mutations / static_cast<int>(files.size()); ++i) {
      const std::string other = changed(text, dice);
      if (meaning(text) == meaning(other) || reader.tells(text, other)) continue;
      if (++silent > 5) return;
      const std::size_t at =
          static_cast<std::size_t>(std::ranges::mismatch(text, other).in1 - text.begin());
      const std::size_t from = at < 60 ? 0 : at - 60;
      ADD_FAILURE() << file << ": no word about\n"
                    << other.substr(from, 120) << "\ninstead of\n"
                    << text.substr(from, 120);
    }
  }
}

std::vector<std::filesystem::path> own(const std::string& folder, const std::string& ending) {
  std::vector<std::filesystem::path> out;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(EYEBRIDGE_SOURCE_DIR) + folder)) {
    if (entry.path().extension() == ending) out.push_back(entry.path());
  }
  std::ranges::sort(out);
  return out;
}

const auto kEqual = [](const auto& a, const auto& b) { return a == b; };

TEST(NoSilence, InWorlds) {
  look(
      own("/worlds", ".wld"), kMutations / 5,
      [](const std::string& text, std::vector<Warning>& w) { return read_world(text, "f", w); },
      kEqual, [](const std::string& text) { return words_of(text, {}); });
}

TEST(NoSilence, InMazes) {
  std::vector<std::filesystem::path> files = own("/worlds", ".maz");
  const std::filesystem::path cases = EYEBRIDGE_SHARED_DIR "/cases/mazes";
  for (const char* name : {"posts.txt", "plus-posts.maz"}) files.push_back(cases / name);
  look(
      files, kMutations / 5,
      [](const std::string& text, std::vector<Warning>& w) { return read_maze(text, "f", w); },
      kEqual, drawing_of);
  look(
      {cases / "list.num"}, kMutations / 20,
      [](const std::string& text, std::vector<Warning>& w) { return read_maze(text, "f", w); },
      kEqual,
      [](const std::string& text) {
        auto lines = words_of(text, {});
        std::ranges::sort(lines);  // in any order
        return lines;
      });
}

TEST(NoSilence, InSimulations) {
  look(
      own("/worlds", ".sim"), kMutations / 5,
      [](const std::string& text, std::vector<Warning>& w) { return read_sim(text, "f", w); },
      [](const SimFile& a, const SimFile& b) { return same_meaning(a, b); },
      [](const std::string& text) { return words_of(text, {}); });
}

TEST(NoSilence, InRobots) {
  look(
      own("/worlds/robots", ".robi"), kMutations / 5,
      [](const std::string& text, std::vector<Warning>& w) { return read_robi(text, "f", w); },
      kEqual,
      [](const std::string& text) {
        return words_of(text, {"model", "mass", "axis", "axel", "collider"});
      });
}

TEST(NoSilence, InParameters) {
  look(
      own("/worlds", ".p"), kMutations / 10,
      [](const std::string& text, std::vector<Warning>& w) {
        return read_parameter_file(text, "f", w);
      },
      [](const ParameterFile& a, const ParameterFile& b) {
        return a.robot == b.robot && a.world == b.world && a.maze == b.maze && a.pause == b.pause &&
               a.debug == b.debug;
      },
      [](const std::string& text) { return words_of(text, {}); });
}

TEST(NoSilence, InMaps) {
  look(
      {EYEBRIDGE_SHARED_DIR "/cases/maps/good.yaml"}, kMutations / 10,
      [](const std::string& text, std::vector<Warning>& w) {
        return read_map_description(text, "f", w);
      },
      [](const MapDescription& a, const MapDescription& b) {
        return a.image == b.image && a.resolution == b.resolution && a.origin == b.origin &&
               a.yaw == b.yaw && a.negate == b.negate && a.occupied_thresh == b.occupied_thresh &&
               a.free_thresh == b.free_thresh && a.mode == b.mode;
      },
      [](std::string text) {
        for (char& c : text) {
          if (c == '[' || c == ']' || c == ',') c = ' ';
        }
        for (std::size_t i = 0; i < text.size(); ++i) {
          if (text[i] == ':') text.replace(i++, 1, " : ");
        }
        std::string words;  // lines mean nothing within a value
        for (const auto& line : words_of(text, {})) {
          for (const std::string& word : line) words += word + " ";
        }
        // What counts without a word.
        for (const auto& [key, value] : {std::pair{"negate : ", "0"},
                                         {"occupied_thresh : ", "0.65"},
                                         {"free_thresh : ", "0.196"}}) {
          const std::string usual = key + meaning_of(value) + " ";
          if (const std::size_t at = words.find(usual); at != std::string::npos) {
            words.erase(at, usual.size());
          }
        }
        return words;
      });
}

}  // namespace
}  // namespace eyebridge::files
