#include "frames/frames_url.hpp"

#include <array>
#include <charconv>
#include <string>
#include <system_error>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/read_file.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/url.hpp"
#include "frames/frame_series.hpp"
#include "sources/frame_schedule.hpp"

namespace eyebridge::camera {
namespace {

namespace fs = std::filesystem;

const SourceLocation kWhere{"--camera"};
constexpr double kLowestRate = 0.01;  // frames a second
constexpr double kHighestRate = 1000.0;

template <class Value>
struct Word {
  std::string_view text;
  Value value;
};
constexpr std::array<Word<FramesUrl::End>, 3> kEnds{{
    {"loop", FramesUrl::End::Loop},
    {"hold", FramesUrl::End::Hold},
    {"end", FramesUrl::End::Stop},
}};
constexpr std::array<Word<FramesUrl::Pick>, 2> kPicks{{
    {"newest", FramesUrl::Pick::Newest},
    {"each", FramesUrl::Pick::Each},
}};

template <class Words>
auto value_of(const Words& words, std::string_view key, const std::string& text) {
  std::string known;
  for (const auto& word : words) {
    if (word.text == text) return word.value;
    known += (known.empty() ? "" : ", ") + std::string(word.text);
  }
  throw ConfigError(kWhere, "found " + std::string(key) + "=" + text.substr(0, 40) +
                                ", expected one of: " + known);
}

double rate_of(const std::string& text) {
  double rate = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rate);
  const bool is_number = error == std::errc{} && end == text.data() + text.size();
  if (is_number && rate >= kLowestRate && rate <= kHighestRate) return rate;
  throw ConfigError(kWhere, "found fps=" + text.substr(0, 40) + ", expected 0.01 ... 1000");
}

bool is_recording(const fs::path& path) {
  if (path.extension() == ".ebrec") return true;
  return first_bytes(path, 15) == "SQLite format 3";
}

FramesUrl::Kind kind_of(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) {
    pictures_in(path);
    return FramesUrl::Kind::Folder;
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw ConfigError({path.string()},
                      "is not a file: expected a folder of pictures, a video or a "
                      "recording (.ebrec)");
  }
  if (!fs::exists(status)) {
    throw ConfigError(kWhere,
                      "found nothing at " + path.string() +
                          ", expected a folder of pictures, a video or a recording (.ebrec)");
  }
  return is_recording(path) ? FramesUrl::Kind::Recording : FramesUrl::Kind::Video;
}

}  // namespace

FramesUrl parse_frames_url(std::string_view rest) {
  const Url url = parse_url("frames:" + std::string(rest), kWhere);
  if (url.rest.empty()) {
    throw ConfigError(kWhere,
                      "found no path, expected frames:PATH: a folder of pictures, a video or"
                      " a recording (.ebrec)");
  }
  FramesUrl wanted;
  wanted.path = url.rest;
  wanted.kind = kind_of(wanted.path);
  if (wanted.kind == FramesUrl::Kind::Folder) {
    wanted.rate = FrameSchedule::kFramesPerSecond;
  }
  for (const auto& [key, value] : url.options) {
    if (key == "end") {
      wanted.end = value_of(kEnds, key, value);
    } else if (key == "pick") {
      wanted.pick = value_of(kPicks, key, value);
    } else if (key != "fps") {
      throw ConfigError(kWhere,
                        "found the option " + in_quotes(key) + ", expected end, fps or pick");
    } else if (wanted.kind == FramesUrl::Kind::Recording ||
               (wanted.kind == FramesUrl::Kind::Video && !has_no_times(wanted.path))) {
      throw ConfigError(kWhere, "found fps for " + wanted.path.string() +
                                    ", expected it for a folder or JPEGs one after another: this "
                                    "file has times of its own");
    } else {
      wanted.rate = rate_of(value);
    }
  }
  return wanted;
}

}  // namespace eyebridge::camera
