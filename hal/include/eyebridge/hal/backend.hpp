#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/accelerometer.hpp"
#include "eyebridge/hal/analog_inputs.hpp"
#include "eyebridge/hal/compass.hpp"
#include "eyebridge/hal/device_facts.hpp"
#include "eyebridge/hal/digital_lines.hpp"
#include "eyebridge/hal/drive.hpp"
#include "eyebridge/hal/gyroscope.hpp"
#include "eyebridge/hal/io_board.hpp"
#include "eyebridge/hal/lidar.hpp"
#include "eyebridge/hal/motor.hpp"
#include "eyebridge/hal/radio.hpp"
#include "eyebridge/hal/range_sensor.hpp"
#include "eyebridge/hal/remote.hpp"
#include "eyebridge/hal/serial_port.hpp"
#include "eyebridge/hal/servo.hpp"
#include "eyebridge/hal/sound.hpp"
#include "eyebridge/hal/switch_sensor.hpp"
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

  virtual Drive* drive() = 0;
  /// A distance sensor (PSD).
  virtual RangeSensor* range_sensor(int id) = 0;
  /// An infrared switch.
  virtual SwitchSensor* proximity(int id) = 0;
  virtual SwitchSensor* bumper(int id) = 0;
  virtual Lidar* lidar() = 0;
  virtual Compass* compass() = 0;
  /// Null on real hardware, and of a robot that is not driven but put where another one is.
  virtual Gyroscope* gyroscope() = 0;
  /// Likewise.
  virtual Accelerometer* accelerometer() = 0;
  /// 1 is the left wheel's motor, 2 the right one's; encoders likewise. Robots that are no
  /// differential ones have other wheels: docs/drives.md.
  virtual Motor* motor(int id) = 0;
  virtual Encoder* encoder(int id) = 0;
  /// 1 is the camera's pan, 2 its tilt, where there are such.
  virtual Servo* servo(int id) = 0;
  virtual DigitalLines* digital() = 0;
  virtual AnalogInputs* analog() = 0;
  /// Null for simulated robots.
  virtual IoBoard* io_board() = 0;
  /// A receiver of infrared codes that is part of the robot.
  virtual Remote* remote() = 0;

  // Of the computer that the program runs on: what --serial, --player and --radio say.
  /// 0 is the serial port, 1 … 20 are USB devices.
  virtual SerialPort* serial_port(int id) = 0;
  virtual Sound* sound() = 0;
  virtual Radio* radio() = 0;

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
