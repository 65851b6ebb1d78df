#include "tap/carry_out.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "tap/tapped_io.hpp"

namespace eyebridge::hal {
namespace {

/// What a device function gave, as numbers.
template <class Value>
Result<Values> packed(Result<Value> result) {
  if (!result) return tl::unexpected(std::move(result).error());
  if constexpr (std::is_void_v<Value>) {
    return Values{};
  } else {
    return AsValues<Value>::pack(*result);
  }
}

tl::unexpected<Error> no_such(const Call& call) {
  return fail(Errc::Unsupported,
              fmt::format("this robot has no {} {} {}", call.device, call.id, call.name));
}

Result<void> check_size(const Call& call, std::size_t expected) {
  if (call.request.size() == expected) return {};
  return fail(Errc::Corrupt,
              fmt::format("{} {} {}: {} numbers in the request, expected {}", call.device, call.id,
                          call.name, call.request.size(), expected));
}

/// A whole number, whatever was sent.
int whole(double value) {
  return std::isnan(value) ? 0 : static_cast<int>(std::clamp(value, -1e9, 1e9));
}

/// `act(request)` when it has `size` numbers.
template <class Act>
Result<Values> with(const Call& call, std::size_t size, const Act& act) {
  if (Result<void> fits = check_size(call, size); !fits) return tl::unexpected(fits.error());
  return packed(act(call.request));
}

// Each device: null when the robot has none.

Result<Values> carry_out(Drive& drive, const Call& call) {
  if (call.name == "set_speed") {
    return with(call, 2, [&](const Values& v) { return drive.set_speed({v[0], v[1]}); });
  }
  if (call.name == "start") {
    return with(call, 3, [&](const Values& v) { return drive.start({v[0], v[1], v[2]}); });
  }
  if (call.name == "set_odometry") {
    return with(call, 3, [&](const Values& v) { return drive.set_odometry({v[0], v[1], v[2]}); });
  }
  if (call.name == "status") return packed(drive.status());
  if (call.name == "measured_twist") return packed(drive.measured_twist());
  if (call.name == "odometry") return packed(drive.odometry());
  return no_such(call);
}

Result<Values> carry_out(RangeSensor& sensor, const Call& call) {
  if (call.name == "read") return packed(sensor.read());
  if (call.name == "read_raw") return packed(sensor.read_raw());
  return no_such(call);
}

Result<Values> carry_out(SwitchSensor& sensor, const Call& call) {
  return call.name == "read" ? packed(sensor.read()) : no_such(call);
}

Result<Values> carry_out(Compass& compass, const Call& call) {
  return call.name == "read" ? packed(compass.read()) : no_such(call);
}

Result<Values> carry_out(Gyroscope& gyroscope, const Call& call) {
  return call.name == "read" ? packed(gyroscope.read()) : no_such(call);
}

Result<Values> carry_out(Accelerometer& accelerometer, const Call& call) {
  return call.name == "read" ? packed(accelerometer.read()) : no_such(call);
}

Result<Values> carry_out(Lidar& lidar, const Call& call) {
  if (call.name == "configure") {
    return with(call, 3, [&](const Values& v) { return lidar.configure(v[0], v[1], whole(v[2])); });
  }
  if (call.name != "read") return no_such(call);
  Values ranges(static_cast<std::size_t>(std::max(lidar.points(), 0)));
  return lidar.read(ranges).map([&] { return std::move(ranges); });
}

Result<Values> carry_out(Motor& motor, const Call& call) {
  if (call.name == "set_duty") {
    return with(call, 1, [&](const Values& v) { return motor.set_duty(v[0]); });
  }
  if (call.name == "set_speed") {
    return with(call, 1, [&](const Values& v) { return motor.set_speed(v[0]); });
  }
  if (call.name == "set_pid") {
    return with(call, 3, [&](const Values& v) {
      return motor.set_pid(whole(v[0]), whole(v[1]), whole(v[2]));
    });
  }
  return no_such(call);
}

Result<Values> carry_out(Encoder& encoder, const Call& call) {
  if (call.name == "read") return packed(encoder.read());
  if (call.name == "reset") return packed(encoder.reset());
  return no_such(call);
}

Result<Values> carry_out(Servo& servo, const Call& call) {
  if (call.name != "set") return no_such(call);
  return with(call, 1, [&](const Values& v) { return servo.set(v[0]); });
}

Result<Values> carry_out(DigitalLines& lines, const Call& call) {
  if (call.name == "setup") {
    return with(call, 1, [&](const Values& v) {
      return lines.setup(call.id, static_cast<LineMode>(std::clamp(whole(v[0]), 0, 3)));
    });
  }
  if (call.name == "write") {
    return with(call, 1, [&](const Values& v) { return lines.write(call.id, v[0] != 0.0); });
  }
  if (call.name == "read") return packed(lines.read(call.id));
  if (call.name == "read_all") return packed(lines.read_all());
  return no_such(call);
}

Result<Values> carry_out(AnalogInputs& inputs, const Call& call) {
  if (call.name == "read") return packed(inputs.read(call.id));
  if (call.name == "supply_voltage") return packed(inputs.supply_voltage());
  return no_such(call);
}

Result<Values> carry_out(IoBoard& board, const Call& call) {
  if (call.name != "version") return no_such(call);
  return board.version().map(pack_bytes<std::string>);
}

Result<Values> carry_out(Remote& remote, const Call& call) {
  return call.name == "read" ? packed(remote.read()) : no_such(call);
}

Result<Values> carry_out(Radio& radio, const Call& call) {
  if (call.name == "start") return packed(radio.start());
  if (call.name == "stop") return packed(radio.stop());
  if (call.name == "receive") return radio.receive().map(pack_message);
  if (call.name == "robots") {
    return radio.robots().map(
        [](const std::vector<int>& ids) { return Values(ids.begin(), ids.end()); });
  }
  if (call.name != "send") return no_such(call);
  if (call.request.empty()) return tl::unexpected(check_size(call, 1).error());
  const std::string text = unpack_text(std::span(call.request).subspan(1));
  return packed(radio.send(whole(call.request[0]), text));
}

template <class Device>
Result<Values> ask(Device* device, const Call& call) {
  return device != nullptr ? carry_out(*device, call) : no_such(call);
}

}  // namespace

Result<Values> carry_out(Backend& robot, const Call& call) {
  if (call.device == "drive") return ask(robot.drive(), call);
  if (call.device == "psd") return ask(robot.range_sensor(call.id), call);
  if (call.device == "proximity") return ask(robot.proximity(call.id), call);
  if (call.device == "bumper") return ask(robot.bumper(call.id), call);
  if (call.device == "lidar") return ask(robot.lidar(), call);
  if (call.device == "compass") return ask(robot.compass(), call);
  if (call.device == "gyroscope") return ask(robot.gyroscope(), call);
  if (call.device == "accelerometer") return ask(robot.accelerometer(), call);
  if (call.device == "motor") return ask(robot.motor(call.id), call);
  if (call.device == "encoder") return ask(robot.encoder(call.id), call);
  if (call.device == "servo") return ask(robot.servo(call.id), call);
  if (call.device == "digital") return ask(robot.digital(), call);
  if (call.device == "analog") return ask(robot.analog(), call);
  if (call.device == "board") return ask(robot.io_board(), call);
  if (call.device == "remote") return ask(robot.remote(), call);
  if (call.device == "radio") return ask(robot.radio(), call);
  return no_such(call);
}

}  // namespace eyebridge::hal
