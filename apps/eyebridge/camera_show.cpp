#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <numeric>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "camera_commands.hpp"
#include "camera_input.hpp"
#include "command.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/png.hpp"
#include "stop_signals.hpp"
#include "terminal_picture.hpp"

namespace eyebridge::apps {
namespace {

constexpr int kMostColumns = 80;
constexpr int kMostRows = 30;

struct CameraShowOptions {
  CameraOptions camera;
  std::string out;
  int frames = 30;
};

/// What was seen of a camera.
struct Look {
  std::vector<Time> times;  ///< Of the frames.
  std::uint64_t dropped = 0;
  std::uint64_t damaged = 0;
  std::uint64_t odd = 0;                          ///< JPEGs of which all rows are there, …
  std::map<std::string, std::uint64_t> oddities;  ///< … by what was odd.
  camera::FramePtr last;
};

void count_oddities(const camera::Oddities& odd, Look& look) {
  if (!odd.any()) return;
  ++look.odd;
  ++look.oddities[odd.text()];
}

Look look_through(CameraInput& input, int frames, std::string& failure) {
  Look look;
  while (static_cast<int>(look.times.size()) < frames && !stop_asked()) {
    const Result<camera::FramePtr> frame = input.next();
    if (!frame && frame.error().code == Errc::Corrupt) {
      ++look.damaged;
      tell("warning: " + frame.error().what);
      continue;
    }
    if (!frame && !input.is_its_end(frame.error())) failure = frame.error().what;
    if (!frame || *frame == nullptr) break;
    if (look.last && (*frame)->sequence > look.last->sequence + 1) {
      look.dropped += (*frame)->sequence - look.last->sequence - 1;
    }
    count_oddities((*frame)->odd, look);
    look.times.push_back((*frame)->time);
    look.last = *frame;
  }
  return look;
}

std::string rate_text(const Look& look) {
  const std::size_t count = look.times.size();
  std::string out = fmt::format("{}", count);
  const Time span = look.times.back() - look.times.front();
  if (count > 1 && span > Time{0}) {
    Time shortest = span;
    Time longest{0};
    for (std::size_t i = 1; i < count; ++i) {
      const Time between = look.times[i] - look.times[i - 1];
      shortest = std::min(shortest, between);
      longest = std::max(longest, between);
    }
    out += fmt::format(" in {:.3f} s: {:.2f} a second, {:.1f} … {:.1f} ms apart", to_seconds(span),
                       static_cast<double>(count - 1) / to_seconds(span),
                       to_seconds(shortest) * 1e3, to_seconds(longest) * 1e3);
  }
  out += fmt::format(", {} dropped", look.dropped);
  if (look.damaged > 0) out += fmt::format(", {} damaged", look.damaged);
  if (look.odd > 0) out += fmt::format(", {} odd", look.odd);
  return out;
}

/// Mean, and what a twentieth of the pixels are darker and brighter than; 0 to 255.
std::string brightness_text(const camera::Frame& frame) {
  camera::Frame grey = camera::to_grey8(frame);
  auto& pixels = grey.bytes;  // of a new frame: rows without padding
  const double sum = std::accumulate(pixels.begin(), pixels.end(), 0.0);
  std::ranges::sort(pixels);
  const std::size_t twentieth = pixels.size() / 20;
  return fmt::format("{:.0f} of 255 in the mean, most pixels {} … {}",
                     sum / static_cast<double>(pixels.size()), pixels[twentieth],
                     pixels[pixels.size() - 1 - twentieth]);
}

void print_in_terminal(const camera::Frame& frame) {
  winsize window{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0) return;
  std::fputs(terminal_picture(frame, std::min<int>(window.ws_col, kMostColumns), kMostRows).c_str(),
             stdout);
}

int show_camera(const CameraShowOptions& options) {
  CameraInput input(options.camera);
  stop_on_signals();
  std::string failure;
  const Look look = look_through(input, options.frames, failure);
  if (look.last != nullptr) {
    std::printf("camera      %s\n", printable(options.camera.url).c_str());
    std::printf("size        %d x %d pixels\n", look.last->width, look.last->height);
    std::printf("frames      %s\n", rate_text(look).c_str());
    for (const auto& [what, count] : look.oddities) {
      std::printf("odd         %llu JPEGs %s: all their rows are there\n",
                  static_cast<unsigned long long>(count), what.c_str());
    }
    std::printf("brightness  %s\n", brightness_text(*look.last).c_str());
    if (!options.out.empty()) {
      camera::write_png(*look.last, options.out);
      std::printf("picture     %s\n", printable(options.out).c_str());
    }
    if (isatty(STDOUT_FILENO) != 0) print_in_terminal(*look.last);
  }
  if (look.last != nullptr && failure.empty()) return kFine;
  if (failure.empty()) failure = "camera: no frame came";
  tell(failure);
  return kFailed;
}

}  // namespace

void add_camera_show(CLI::App& camera, int& code) {
  CLI::App* command =
      camera.add_subcommand("show", "Looks through a camera: size, rate, brightness, a picture");
  auto options = std::make_shared<CameraShowOptions>();
  add_camera_options(*command, options->camera);
  command->add_option("--out", options->out, "Writes the last frame as a PNG")->type_name("FILE");
  command->add_option("--frames", options->frames, "How many are looked at [30]")
      ->check(CLI::Range(1, 1'000'000));
  command->callback([options, &code] { code = show_camera(*options); });
}

}  // namespace eyebridge::apps
