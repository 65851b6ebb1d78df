#include "host/open_host.hpp"

#include <cstdlib>
#include <optional>
#include <utility>

#include "eyebridge/files/hdt.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/hal/world_control.hpp"
#include "host/host_backend.hpp"
#include "host/host_serial.hpp"
#include "host/host_sound.hpp"
#include "host/serial_devices.hpp"
#include "radio/radio_medium.hpp"
#include "radio/radio_setting.hpp"
#include "radio/udp_radio.hpp"

namespace eyebridge::hal {
namespace {

using Medium = RadioSetting::Medium;

RadioSetting radio_setting(const Config& config) {
  RadioSetting setting = from_setting(config, "radio", parse_radio);
  if (setting.medium == Medium::Udp && config.boolean("fast")) {
    throw ConfigError(config.value("radio").where,
                      "found a radio among processes, which live in real time, and this robot in "
                      "virtual time; expected all in real time: leave --fast out");
  }
  return setting;
}

SerialDevices serial_devices(const Config& config) {
  SerialDevices devices = from_setting(config, "serial", parse_serial_devices);
  if (!config.is_set("hdt")) return devices;
  const std::string path = config.path("hdt").string();
  std::vector<Warning> known;  // the board tells them
  const files::Hdt hdt = files::read_hdt(files::read_text_file(path), path, known);
  for (const files::HdtSerial& line : hdt.serials) {
    // What the user says goes before what the file says.
    devices.emplace(line.id, line.device.empty() ? line.name : line.device);
  }
  return devices;
}

std::unique_ptr<Sound> make_sound(const Config& config, Clock& clock) {
  const std::string player = config.text("player");
  if (clock.is_virtual() || player == "none") return make_silent_sound(clock);
  const char* const path = std::getenv("PATH");
  return make_played_sound(player, path == nullptr ? "" : path);
}

/// Where a simulated robot is; nothing for a real one, of which nobody knows. `robot` is lent.
RadioPlace place_of(Backend& robot) {
  WorldControl* const world = robot.world();
  if (world == nullptr) return {};
  return [world]() -> std::optional<Vec2> {
    const auto pose = world->robot_pose(0);
    return pose ? std::optional(pose->position()) : std::nullopt;
  };
}

std::unique_ptr<Radio> make_radio(Backend& robot, const BackendContext& context,
                                  std::shared_ptr<RadioMedium> air) {
  const RadioSetting setting = radio_setting(context.config);
  const RadioConditions model = robot.radio_conditions();
  const RadioErrors errors{setting.loss.value_or(model.loss),
                           setting.delay.value_or(model.delay),
                           static_cast<std::uint64_t>(context.config.integer("seed")),
                           setting.jitter.value_or(model.jitter),
                           setting.corrupt.value_or(model.corrupt),
                           setting.range.value_or(model.range)};
  const int id = setting.id.value_or(robot.robot_id());
  if (id > Radio::kLastId) return nullptr;  // nobody could send it anything
  switch (setting.medium) {
    case Medium::None:
      return nullptr;
    case Medium::World:
      if (air == nullptr) air = std::make_shared<RadioMedium>();
      return make_medium_radio(std::move(air), id, errors, robot.clock(), place_of(robot));
    case Medium::Udp:
      return make_udp_radio(setting, id, errors, robot.clock(), context.log);
  }
  return nullptr;
}

}  // namespace

void check_host_settings(const Config& config) {
  static_cast<void>(radio_setting(config));
  static_cast<void>(from_setting(config, "serial", parse_serial_devices));
}

std::unique_ptr<Backend> with_host_devices(std::unique_ptr<Backend> inner,
                                           const BackendContext& context,
                                           std::shared_ptr<RadioMedium> air) {
  HostDevices devices;
  for (auto& [id, device] : serial_devices(context.config)) {
    devices.serial_ports.emplace(id, std::make_unique<HostSerial>(id, device));
  }
  devices.sound = make_sound(context.config, inner->clock());
  devices.radio = make_radio(*inner, context, std::move(air));
  return with_host(std::move(inner), std::move(devices));
}

}  // namespace eyebridge::hal
