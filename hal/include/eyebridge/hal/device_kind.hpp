#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "eyebridge/hal/accelerometer.hpp"
#include "eyebridge/hal/analog_inputs.hpp"
#include "eyebridge/hal/compass.hpp"
#include "eyebridge/hal/digital_lines.hpp"
#include "eyebridge/hal/drive.hpp"
#include "eyebridge/hal/gyroscope.hpp"
#include "eyebridge/hal/io_board.hpp"
#include "eyebridge/hal/lidar.hpp"
#include "eyebridge/hal/motor.hpp"
#include "eyebridge/hal/radio.hpp"
#include "eyebridge/hal/range_matrix.hpp"
#include "eyebridge/hal/range_sensor.hpp"
#include "eyebridge/hal/remote.hpp"
#include "eyebridge/hal/serial_port.hpp"
#include "eyebridge/hal/servo.hpp"
#include "eyebridge/hal/sound.hpp"
#include "eyebridge/hal/switch_sensor.hpp"

namespace eyebridge::hal {

/// The kinds of devices: what moves the robot, what it senses, its lines, what its computer adds.
enum class DeviceKind : std::uint8_t {
  Drive,
  Motor,
  Encoder,
  Servo,
  Psd,
  Proximity,
  Bumper,
  Lidar,
  Tof,
  Compass,
  Gyroscope,
  Accelerometer,
  Digital,
  Analog,
  Board,
  Remote,
  Serial,
  Sound,
  Radio,
};

/// A kind of devices: how they are used, and which there can be.
template <class Type>
struct KindOfDevice {
  using Interface = Type;
  std::string_view name;  ///< As --faults, --mix and recordings name it.
  int first_id = 1;
  int last_id = 1;
};

/// The one table of devices, in the order of DeviceKind. What each of them can be asked is in
/// hal/calls/device_calls.hpp.
inline constexpr int kLastDeviceId = 255;
inline constexpr std::tuple kKinds{
    KindOfDevice<Drive>{"drive"},
    KindOfDevice<Motor>{"motor", 1, kLastDeviceId},
    KindOfDevice<Encoder>{"encoder", 1, kLastDeviceId},
    KindOfDevice<Servo>{"servo", 1, kLastDeviceId},
    KindOfDevice<RangeSensor>{"psd", 1, kLastDeviceId},
    KindOfDevice<SwitchSensor>{"proximity", 1, kLastDeviceId},
    KindOfDevice<SwitchSensor>{"bumper", 1, kLastDeviceId},
    KindOfDevice<Lidar>{"lidar"},
    KindOfDevice<RangeMatrix>{"tof", 1, RangeMatrix::kLastId},
    KindOfDevice<Compass>{"compass"},
    KindOfDevice<Gyroscope>{"gyroscope"},
    KindOfDevice<Accelerometer>{"accelerometer"},
    KindOfDevice<DigitalLines>{"digital"},
    KindOfDevice<AnalogInputs>{"analog"},
    KindOfDevice<IoBoard>{"board"},
    KindOfDevice<Remote>{"remote"},
    KindOfDevice<SerialPort>{"serial", 0, kLastDeviceId},
    KindOfDevice<Sound>{"sound"},
    KindOfDevice<Radio>{"radio"},
};
inline constexpr std::size_t kKindCount = std::tuple_size_v<decltype(kKinds)>;

template <DeviceKind kind>
inline constexpr auto& kKind = std::get<static_cast<std::size_t>(kind)>(kKinds);
template <DeviceKind kind>
using InterfaceOf = typename std::remove_cvref_t<decltype(kKind<kind>)>::Interface;

/// Calls `act.operator()<kind>()` for each kind, in the order of the table.
template <class Act>
constexpr void for_each_kind(Act&& act) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (act.template operator()<static_cast<DeviceKind>(i)>(), ...);
  }
  (std::make_index_sequence<kKindCount>{});
}

/// The names of all kinds.
inline constexpr std::array<std::string_view, kKindCount> kDeviceKinds = std::apply(
    [](const auto&... kinds) { return std::array<std::string_view, kKindCount>{kinds.name...}; },
    kKinds);

constexpr std::string_view name_of(DeviceKind kind) {
  return kDeviceKinds[static_cast<std::size_t>(kind)];
}
/// None: there is no such kind.
constexpr std::optional<DeviceKind> kind_named(std::string_view name) {
  for (std::size_t i = 0; i < kKindCount; ++i) {
    if (kDeviceKinds[i] == name) return static_cast<DeviceKind>(i);
  }
  return std::nullopt;
}

}  // namespace eyebridge::hal
