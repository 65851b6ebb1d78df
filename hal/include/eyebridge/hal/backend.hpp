#pragma once

#include "eyebridge/base/clock.hpp"
#include "eyebridge/hal/compass.hpp"
#include "eyebridge/hal/drive.hpp"
#include "eyebridge/hal/lidar.hpp"
#include "eyebridge/hal/motor.hpp"
#include "eyebridge/hal/range_sensor.hpp"
#include "eyebridge/hal/servo.hpp"
#include "eyebridge/hal/switch_sensor.hpp"
#include "eyebridge/hal/trace.hpp"
#include "eyebridge/hal/world_control.hpp"

namespace eyebridge::camera {
class View;
}

namespace eyebridge::hal {

/// One robot, whichever way it is reached. Owns its devices; null means "this robot has none".
///
/// Device ids are those of RoBIOS: they start at 1. Lookups and devices: any thread.
class Backend {
 public:
  virtual ~Backend() = default;

  /// The time this robot's program lives in.
  virtual Clock& clock() = 0;
  /// 1-based number of this robot in its world (1 on real hardware).
  [[nodiscard]] virtual int robot_id() const = 0;

  virtual Drive* drive() = 0;
  virtual RangeSensor* range_sensor(int id) = 0;
  virtual SwitchSensor* proximity(int id) = 0;
  virtual SwitchSensor* bumper(int id) = 0;
  virtual Lidar* lidar() = 0;
  virtual Compass* compass() = 0;
  virtual Motor* motor(int id) = 0;
  virtual Encoder* encoder(int id) = 0;
  virtual Servo* servo(int id) = 0;

  /// Null on real hardware.
  virtual WorldControl* world() = 0;
  /// What a rendered camera on this robot looks at; null when nothing here can be rendered.
  virtual camera::View* camera_view() = 0;

  /// Tells `sink` of every step from now on; null ends it. The sink is lent until then.
  virtual void trace_to(TraceSink* sink) = 0;

  /// Stops all motors now. Called once, when the program ends in any way; never throws.
  virtual void stop() noexcept = 0;
};

}  // namespace eyebridge::hal
