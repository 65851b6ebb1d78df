#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device_facts.hpp"
#include "eyebridge/hal/device_kind.hpp"
#include "eyebridge/hal/trace.hpp"
#include "eyebridge/hal/world_control.hpp"

namespace eyebridge::camera {
class FrameSink;
class Source;
class View;
}  // namespace eyebridge::camera

namespace eyebridge::hal {

class Environment;
class HandGuide;
class SharedWorld;

/// One robot, whichever way it is reached. Owns its devices; null means "this robot has none".
///
/// Device ids are those of RoBIOS: they start at 1 (serial ports at 0), and any other number, too,
/// is "this robot has none". Lookups never fail otherwise, and give the same device every time; it
/// lives as long as the backend. Lookups and devices: any thread.
class Backend {
 public:
  virtual ~Backend() = default;

  /// The time this robot's program lives in; starts at 0. Owned by the backend.
  virtual Clock& clock() = 0;
  /// The program makes its first call: returns when those of all robots of its world have.
  virtual void arrive() {}
  /// Number of this robot in its world, from 1 (1 on real hardware).
  [[nodiscard]] virtual int robot_id() const = 0;

  /// The device of that kind and number; its type is InterfaceOf<kind>.
  virtual Device* find(DeviceKind kind, int id) = 0;
  template <DeviceKind kind>
  InterfaceOf<kind>* device(int id = 1) {
    return static_cast<InterfaceOf<kind>*>(find(kind, id));
  }

  Drive* drive() { return device<DeviceKind::Drive>(); }
  /// Motor 1 turns the left wheel, motor 2 the right one; encoders have the same numbers. Robots
  /// with another drive have other wheels: docs/drives.md.
  Motor* motor(int id) { return device<DeviceKind::Motor>(id); }
  Encoder* encoder(int id) { return device<DeviceKind::Encoder>(id); }
  /// 1 is the camera's pan, 2 its tilt, where there are such.
  Servo* servo(int id) { return device<DeviceKind::Servo>(id); }
  /// A distance sensor (PSD).
  RangeSensor* range_sensor(int id) { return device<DeviceKind::Psd>(id); }
  /// An infrared switch.
  SwitchSensor* proximity(int id) { return device<DeviceKind::Proximity>(id); }
  SwitchSensor* bumper(int id) { return device<DeviceKind::Bumper>(id); }
  RangeMatrix* range_matrix(int id) { return device<DeviceKind::Tof>(id); }
  Lidar* lidar() { return device<DeviceKind::Lidar>(); }
  Compass* compass() { return device<DeviceKind::Compass>(); }
  /// Null on real hardware, and of a robot that is not driven but put where another one is.
  Gyroscope* gyroscope() { return device<DeviceKind::Gyroscope>(); }
  /// Likewise.
  Accelerometer* accelerometer() { return device<DeviceKind::Accelerometer>(); }
  DigitalLines* digital() { return device<DeviceKind::Digital>(); }
  AnalogInputs* analog() { return device<DeviceKind::Analog>(); }
  /// Null for simulated robots.
  IoBoard* io_board() { return device<DeviceKind::Board>(); }
  /// A receiver of infrared codes that is part of the robot.
  Remote* remote() { return device<DeviceKind::Remote>(); }

  // Of the computer that the program runs on: what --serial, --player and --radio say.
  /// 0 is the serial port, 1 … 20 are USB devices.
  SerialPort* serial_port(int id) { return device<DeviceKind::Serial>(id); }
  Sound* sound() { return device<DeviceKind::Sound>(); }
  Radio* radio() { return device<DeviceKind::Radio>(); }

  /// What a radio on this robot suffers; nothing where nobody says.
  [[nodiscard]] virtual RadioConditions radio_conditions() const { return {}; }

  /// Null on real hardware.
  virtual WorldControl* world() = 0;
  /// The simulated world as a window sees it; null where there is none in this process.
  virtual Environment* environment() { return nullptr; }
  /// That world as other robots can join it while this one runs; null where none can.
  virtual std::shared_ptr<SharedWorld> shared_world() { return nullptr; }
  /// What guides the person who carries this robot's camera; null when nobody does.
  virtual HandGuide* hand_guide() { return nullptr; }
  /// What a rendered camera on this robot looks at; null when nothing here can be rendered.
  virtual camera::View* camera_view() = 0;
  /// The camera that is part of this robot and open already (a person carries both); null when
  /// frames come from wherever --camera says. For one reader.
  virtual camera::Source* camera_source() = 0;

  /// Where every frame that the program is given is to be handed, until stop(); null when this run
  /// is not recorded. Owned by the backend.
  virtual camera::FrameSink* frame_sink() { return nullptr; }
  /// After stop(): why a report or recording that was asked for is not whole; "" when all are.
  virtual std::string lost_results() { return {}; }

  /// What the robot's description says about its devices of one kind ("psd", "proximity", "bumper",
  /// "motor", "encoder", "servo"; "robot" is the robot itself); nothing where it says nothing.
  virtual std::vector<DeviceFacts> facts_of(std::string_view kind) = 0;

  /// Tells `sink` of every step from now on, in the place of an earlier sink; null ends it. The
  /// sink is lent until then: once this returns, the old one is not called any more. Any thread,
  /// but not from a sink.
  virtual void trace_to(TraceSink* sink) = 0;

  /// Stops all motors now. Fails where it is not known that they stand: a board that cannot be
  /// reached any more. Called when the program ends in any way, from any thread, maybe twice.
  virtual Result<void> stop() noexcept = 0;
};

}  // namespace eyebridge::hal
