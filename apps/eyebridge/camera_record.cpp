#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "camera_commands.hpp"
#include "camera_input.hpp"
#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"
#include "stop_signals.hpp"

namespace eyebridge::apps {
namespace {

constexpr Time kReportPeriod = std::chrono::seconds(1);

struct CameraRecordOptions {
  CameraOptions camera;
  std::string out;
  double seconds = 0.0;  ///< 0: until Ctrl-C, or the camera's end.
  std::string codec = "lossless";
};

/// What was recorded so far.
struct Tally {
  std::uint64_t frames = 0;
  std::uint64_t dropped = 0;
  std::uint64_t damaged = 0;
  std::optional<std::uint64_t> last;
  Time first_time{0};
  Time last_time{0};

  void add(const camera::Frame& frame, Time now) {
    if (last && frame.sequence > *last + 1) dropped += frame.sequence - *last - 1;
    if (frames++ == 0) first_time = now;
    last = frame.sequence;
    last_time = now;
  }
  [[nodiscard]] std::string text() const {
    std::string out = fmt::format("{} frames in {:.1f} s, {} dropped", frames,
                                  to_seconds(last_time - first_time), dropped);
    return damaged == 0 ? out : out + fmt::format(", {} damaged", damaged);
  }
};

camera::RecordingFile make_frame_recording(const CameraRecordOptions& options) {
  // It would be replaced while it is read.
  const std::string& url = options.camera.url;
  const std::string path = url.substr(std::min(url.find(':'), url.size() - 1) + 1);
  std::error_code missing;  // what is not there is not the same
  if (std::filesystem::equivalent(path.substr(0, path.find('?')), options.out, missing)) {
    throw ConfigError({"--out"},
                      "found " + options.out + ", which --camera reads; expected another file");
  }
  try {
    return {options.out, {{"program", "eyebridge camera record --camera " + options.camera.url}}};
  } catch (const ConfigError& error) {
    throw ConfigError({"--out"}, error.text());
  }
}

int record_camera(const CameraRecordOptions& options) {
  CameraInput input(options.camera);
  camera::RecordingFile file = make_frame_recording(options);
  camera::FrameWriter writer(file, *camera::find_frame_codec(options.codec));
  stop_on_signals();
  Tally tally;
  Time report{0};
  int code = kFine;
  while (!stop_asked()) {
    const Result<camera::FramePtr> frame = input.next();
    if (!frame && frame.error().code == Errc::Corrupt) {
      ++tally.damaged;
      tell("warning: " + frame.error().what);
      continue;
    }
    if (!frame && !input.is_its_end(frame.error())) {
      tell(frame.error().what);
      code = kFailed;
    }
    if (!frame || *frame == nullptr) break;
    const Time now = input.now();
    writer.add(**frame, now);
    tally.add(**frame, now);
    if (now >= report) {
      tell("recording, Ctrl-C ends: " + tally.text());
      report = now + kReportPeriod;
    }
    if (options.seconds > 0.0 && now - tally.first_time >= from_seconds(options.seconds)) break;
  }
  file.commit();
  std::printf("%s: %s, %d x %d pixels, %s\n", printable(options.out).c_str(), tally.text().c_str(),
              input.size().width, input.size().height, options.codec.c_str());
  return tally.frames == 0 ? static_cast<int>(kFailed) : code;
}

}  // namespace

void add_camera_record(CLI::App& camera, int& code) {
  CLI::App* command = camera.add_subcommand("record", "Writes a camera's frames to a recording");
  auto options = std::make_shared<CameraRecordOptions>();
  add_camera_options(*command, options->camera);
  command->add_option("--out", options->out, "The recording (.ebrec), an SQLite file")
      ->required()
      ->type_name("FILE");
  command->add_option("--seconds", options->seconds, "How long [until Ctrl-C, or its end]")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--codec", options->codec, "How pixels are kept: lossless or mjpeg [lossless]")
      ->check(CLI::IsMember({"lossless", "mjpeg"}));
  command->footer(
      "Programs see what was recorded with --camera frames:FILE.ebrec; eyebridge record --show\n"
      "FILE.ebrec tells what is in it.");
  command->callback([options, &code] { code = record_camera(*options); });
}

}  // namespace eyebridge::apps
