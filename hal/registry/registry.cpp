#include "eyebridge/hal/registry.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "board/open_board.hpp"
#include "config/mix_text.hpp"
#include "eyebridge/base/text.hpp"
#include "fault/fault_injector.hpp"
#include "hand/open_hand.hpp"
#include "host/open_host.hpp"
#include "mix/mix_backend.hpp"
#include "remote_robot/open_remote_robot.hpp"
#include "replay/open_replay.hpp"
#include "replay/recorder.hpp"
#include "shared/open_only.hpp"
#include "shared/open_slot.hpp"

namespace eyebridge::hal {
namespace {

constexpr auto kBackends = std::to_array<BackendFactory>({
    {"sim", "a simulated robot in the world that --world names", open_sim, false, true},
    {"serial", "a board on a serial port: serial:/dev/ttyACM0?profile=io7&baud=115200&hdt=FILE",
     open_io7_board, true},
    {"tcp", "a board behind a TCP port: tcp:HOST:PORT?profile=io7&hdt=FILE", open_io7_board, true},
    {"can",
     "a robot on a CAN bus: can:can0?node=1&fd=0&ids=11&offset=0&hdt=FILE, or dbc=FILE&map=FILE",
     open_can_board, true},
    {"replay", "what a robot answered in a recorded run: replay:FILE.ebrec", open_replay, false,
     true},
    {"remote", "one of several robots, in the world of the process that started this one",
     open_remote_robot, true},
});

const BackendFactory& row_of(const std::string& text, const SourceLocation& where) {
  const BackendUrl url = parse_backend_url(text, where);
  const auto* row = std::ranges::find(kBackends, url.scheme, &BackendFactory::scheme);
  if (row != kBackends.end()) return *row;
  std::string known;
  for (const BackendFactory& backend : kBackends) {
    known += known.empty() ? "" : ", ";
    known += backend.scheme;
  }
  throw ConfigError(where,
                    fmt::format("unknown backend '{}', expected one of: {}", url.scheme, known));
}

std::vector<MixEntry> mix_of(const Config& config) {
  std::vector<MixEntry> entries = from_setting(config, "mix", parse_mix);
  for (const MixEntry& entry : entries) {
    static_cast<void>(row_of(entry.url, config.value("mix").where));
  }
  return entries;
}

/// The robot of `row`, and what this computer adds to it, unless the row does so itself.
std::unique_ptr<Backend> opened(const BackendFactory& row, const std::string& text,
                                const SourceLocation& where, const BackendContext& context) {
  auto robot = row.open(parse_backend_url(text, where), context);
  if (row.answers_for_host) return robot;
  return with_host_devices(std::move(robot), context);
}

std::unique_ptr<Backend> mixed(std::unique_ptr<Backend> main, const BackendContext& context) {
  const Config& config = context.config;
  const ConfigValue& mix = config.value("mix");
  std::vector<MixPart> parts;
  for (MixEntry& entry : mix_of(config)) {
    if (entry.url == config.text("hal")) continue;
    auto part = std::ranges::find(parts, entry.url, &MixPart::url);
    if (part == parts.end()) {
      const Config other = config.with("hal", {entry.url, mix.where});
      auto backend =
          opened(row_of(entry.url, mix.where), entry.url, mix.where, {other, context.log});
      parts.push_back({{}, entry.url, std::move(backend)});
      part = std::prev(parts.end());
    }
    part->devices.push_back(std::move(entry.device));
  }
  return from_setting(config, "mix", [&](const std::string&) {
    return make_mix(std::move(main), std::move(parts));
  });
}

FaultScript faults_of(const Config& config) {
  return from_setting(config, "faults", parse_fault_script);
}

/// How this process was started, its words between blanks.
std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string line(4096, '\0');
  file.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(file.gcount()));
  std::ranges::replace(line, '\0', ' ');
  return std::string(trimmed(line));
}

/// A recording is replaced: it must not be the one that this run answers from.
void check_record_is_not_read(const Config& config) {
  const ConfigValue& record = config.value("record");
  for (const char* key : {"hal", "camera"}) {
    const std::string_view url = config.value(key).text;
    const std::string_view path = url.substr(std::min(url.find(':'), url.size() - 1) + 1);
    std::error_code error;  // a path that is not there is not the same
    if (!std::filesystem::equivalent(path.substr(0, path.find('?')), config.path("record"),
                                     error)) {
      continue;
    }
    throw ConfigError(record.where, fmt::format("found {}, which --{} reads; expected another file",
                                                in_quotes(record.text), key));
  }
}

std::unique_ptr<Backend> recorded(std::unique_ptr<Backend> backend, const BackendContext& context) {
  const Config& config = context.config;
  return from_setting(config, "record", [&](const std::string& path) {
    return with_recording(std::move(backend), path, context.log,
                          {command_line(), config.text("hal"), config.text("world")},
                          camera::find_frame_codec(config.text("record_frames")));
  });
}

}  // namespace

std::span<const BackendFactory> backend_table() { return kBackends; }

const BackendFactory& find_backend(const Config& config) {
  const ConfigValue& hal = config.value("hal");
  const BackendFactory& row = row_of(hal.text, hal.where);
  static_cast<void>(faults_of(config));
  static_cast<void>(mix_of(config));
  check_drive(config);
  check_host_settings(config);
  return row;
}

bool opening_has_effects(const Config& config) {
  bool has_effects = find_backend(config).has_effects;
  for (const MixEntry& entry : mix_of(config)) {
    has_effects = has_effects || row_of(entry.url, config.value("mix").where).has_effects;
  }
  return has_effects;
}

std::unique_ptr<Backend> open_backend(const BackendContext& context) {
  const Config& config = context.config;
  const ConfigValue& hal = config.value("hal");
  FaultScript script = faults_of(config);
  auto backend = context.slot != nullptr
                     ? open_slot(*context.slot, context)
                     : opened(find_backend(config), hal.text, hal.where, context);
  if (config.is_set("record")) check_record_is_not_read(config);
  if (config.is_set("mix")) backend = mixed(std::move(backend), context);
  backend = with_hand(std::move(backend), context);
  if (!script.empty()) {
    const auto seed = static_cast<std::uint64_t>(config.integer("seed"));
    backend = with_faults(std::move(backend), std::move(script), seed);
  }
  // Outermost: what the program sees.
  if (config.is_set("record")) backend = recorded(std::move(backend), context);
  return backend;
}

}  // namespace eyebridge::hal
