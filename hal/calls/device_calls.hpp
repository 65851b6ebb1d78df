#pragma once

#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/quantity.hpp"

namespace eyebridge::hal {

// What each device can be asked, twice: as a table, for code that has a call's name and numbers,
// and as the functions of its interface, for code between a program and a device.

enum class CallStyle {
  Reads,     ///< May be asked again.
  Commands,  ///< Changes something.
  Takes,     ///< What came, once: nobody may be given it twice. Nothing is an answer.
};

/// One function of a device interface.
template <class Interface, class Answer, class... Args>
struct DeviceCall {
  std::string_view name;  ///< As recordings have it.
  Result<Answer> (Interface::*method)(Args...);
  CallStyle style = CallStyle::Reads;
  std::optional<Quantity> note{};  ///< What a window shows of it.
  bool is_of_line = false;         ///< Its first argument is a line or channel: the call's id.
  std::optional<int> id{};         ///< Another one than the device's.

  /// Whether an empty answer will do.
  [[nodiscard]] constexpr bool is_command() const { return style != CallStyle::Reads; }
};

template <class Interface, class Answer, class... Args>
constexpr auto reads(std::string_view name, Result<Answer> (Interface::*method)(Args...),
                     std::optional<Quantity> note = {}) {
  return DeviceCall<Interface, Answer, Args...>{name, method, CallStyle::Reads, note};
}
template <class Interface, class Answer, class... Args>
constexpr auto commands(std::string_view name, Result<Answer> (Interface::*method)(Args...),
                        std::optional<Quantity> note = {}) {
  return DeviceCall<Interface, Answer, Args...>{name, method, CallStyle::Commands, note};
}
template <class Interface, class Answer, class... Args>
constexpr auto takes(std::string_view name, Result<Answer> (Interface::*method)(Args...),
                     std::optional<Quantity> note = {}) {
  return DeviceCall<Interface, Answer, Args...>{name, method, CallStyle::Takes, note};
}
/// The same of a line or channel.
template <class Row>
constexpr Row of_line(Row row) {
  row.is_of_line = true;
  return row;
}
template <class Row>
constexpr Row with_id(Row row, int id) {
  row.id = id;
  return row;
}

/// The functions of an interface: `kAll`, and in `kFacts` what it says of itself without a call.
template <class Interface>
struct Calls;
struct NoFacts {
  static constexpr std::tuple<> kFacts{};
};
/// An interface of which each function calls carry() of `Carrier`, with its row of the table and
/// its arguments, or fact() for a fact.
template <class Interface, class Carrier>
class Relay;

template <>
struct Calls<Drive> : NoFacts {
  static constexpr auto kSetSpeed = commands("set_speed", &Drive::set_speed, Quantity::WantedSpeed);
  static constexpr auto kStart = commands("start", &Drive::start, Quantity::Goal);
  static constexpr auto kStatus = reads("status", &Drive::status, Quantity::Progress);
  static constexpr auto kTwist = reads("measured_twist", &Drive::measured_twist, Quantity::Speed);
  static constexpr auto kOdometry = reads("odometry", &Drive::odometry, Quantity::Pose);
  static constexpr auto kSetOdometry =
      commands("set_odometry", &Drive::set_odometry, Quantity::Pose);
  static constexpr std::tuple kAll{kSetSpeed, kStart, kStatus, kTwist, kOdometry, kSetOdometry};
};
template <class Carrier>
class Relay<Drive, Carrier> : public Carrier {
  using Is = Calls<Drive>;

 public:
  using Carrier::Carrier;
  Result<void> set_speed(const Twist& t) override { return this->carry(Is::kSetSpeed, t); }
  Result<void> start(const DriveGoal& goal) override { return this->carry(Is::kStart, goal); }
  Result<DriveStatus> status() override { return this->carry(Is::kStatus); }
  Result<Twist> measured_twist() override { return this->carry(Is::kTwist); }
  Result<Pose> odometry() override { return this->carry(Is::kOdometry); }
  Result<void> set_odometry(const Pose& p) override { return this->carry(Is::kSetOdometry, p); }
};

template <>
struct Calls<Motor> : NoFacts {
  static constexpr auto kSetDuty = commands("set_duty", &Motor::set_duty, Quantity::Duty);
  static constexpr auto kSetSpeed = commands("set_speed", &Motor::set_speed, Quantity::TickRate);
  static constexpr auto kSetPid = commands("set_pid", &Motor::set_pid, Quantity::Gains);
  static constexpr std::tuple kAll{kSetDuty, kSetSpeed, kSetPid};
};
template <class Carrier>
class Relay<Motor, Carrier> : public Carrier {
  using Is = Calls<Motor>;

 public:
  using Carrier::Carrier;
  Result<void> set_duty(double duty) override { return this->carry(Is::kSetDuty, duty); }
  Result<void> set_speed(double rate) override { return this->carry(Is::kSetSpeed, rate); }
  Result<void> set_pid(int p, int i, int d) override { return this->carry(Is::kSetPid, p, i, d); }
};

template <>
struct Calls<Encoder> : NoFacts {
  static constexpr auto kRead = reads("read", &Encoder::read, Quantity::Ticks);
  static constexpr auto kReset = commands("reset", &Encoder::reset, Quantity::Ticks);
  static constexpr std::tuple kAll{kRead, kReset};
};
template <class Carrier>
class Relay<Encoder, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<int> read() override { return this->carry(Calls<Encoder>::kRead); }
  Result<void> reset() override { return this->carry(Calls<Encoder>::kReset); }
};

template <>
struct Calls<Servo> : NoFacts {
  static constexpr auto kSet = commands("set", &Servo::set, Quantity::Position);
  static constexpr std::tuple kAll{kSet};
};
template <class Carrier>
class Relay<Servo, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<void> set(double position) override { return this->carry(Calls<Servo>::kSet, position); }
};

template <>
struct Calls<RangeSensor> {
  static constexpr auto kRead = reads("read", &RangeSensor::read, Quantity::Distance);
  static constexpr auto kReadRaw = reads("read_raw", &RangeSensor::read_raw, Quantity::Raw);
  static constexpr std::tuple kAll{kRead, kReadRaw};
  static constexpr std::tuple kFacts{&RangeSensor::out_of_range};
};
template <class Carrier>
class Relay<RangeSensor, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<double> read() override { return this->carry(Calls<RangeSensor>::kRead); }
  Result<int> read_raw() override { return this->carry(Calls<RangeSensor>::kReadRaw); }
  [[nodiscard]] double out_of_range() const override {
    return this->fact(&RangeSensor::out_of_range);
  }
};

template <>
struct Calls<SwitchSensor> : NoFacts {
  static constexpr auto kRead = reads("read", &SwitchSensor::read, Quantity::Switch);
  static constexpr std::tuple kAll{kRead};
};
template <class Carrier>
class Relay<SwitchSensor, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<bool> read() override { return this->carry(Calls<SwitchSensor>::kRead); }
};

template <>
struct Calls<Lidar> {
  static constexpr auto kConfigure = commands("configure", &Lidar::configure);
  static constexpr auto kRead = reads("read", &Lidar::read, Quantity::Nearest);
  static constexpr std::tuple kAll{kConfigure, kRead};
  static constexpr std::tuple kFacts{&Lidar::max_range, &Lidar::shape};
};
template <class Carrier>
class Relay<Lidar, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<void> configure(double field_of_view, double tilt, int points) override {
    return this->carry(Calls<Lidar>::kConfigure, field_of_view, tilt, points);
  }
  Result<void> read(std::span<double> ranges) override {
    return this->carry(Calls<Lidar>::kRead, ranges);
  }
  [[nodiscard]] LidarShape shape() const override { return this->fact(&Lidar::shape); }
  [[nodiscard]] double max_range() const override { return this->fact(&Lidar::max_range); }
};

template <>
struct Calls<RangeMatrix> {
  static constexpr auto kRead = reads("read", &RangeMatrix::read, Quantity::Nearest);
  static constexpr std::tuple kAll{kRead};
  static constexpr std::tuple kFacts{&RangeMatrix::out_of_range};
};
template <class Carrier>
class Relay<RangeMatrix, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<RangeMatrix::Ranges> read() override { return this->carry(Calls<RangeMatrix>::kRead); }
  [[nodiscard]] double out_of_range() const override {
    return this->fact(&RangeMatrix::out_of_range);
  }
};

template <>
struct Calls<Compass> : NoFacts {
  static constexpr auto kRead = reads("read", &Compass::read, Quantity::Heading);
  static constexpr std::tuple kAll{kRead};
};
template <class Carrier>
class Relay<Compass, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<double> read() override { return this->carry(Calls<Compass>::kRead); }
};

template <>
struct Calls<Gyroscope> : NoFacts {
  static constexpr auto kRead = reads("read", &Gyroscope::read, Quantity::TurnRate);
  static constexpr std::tuple kAll{kRead};
};
template <class Carrier>
class Relay<Gyroscope, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<double> read() override { return this->carry(Calls<Gyroscope>::kRead); }
};

template <>
struct Calls<Accelerometer> : NoFacts {
  static constexpr auto kRead = reads("read", &Accelerometer::read, Quantity::Acceleration);
  static constexpr std::tuple kAll{kRead};
};
template <class Carrier>
class Relay<Accelerometer, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<Vec2> read() override { return this->carry(Calls<Accelerometer>::kRead); }
};

template <>
struct Calls<DigitalLines> : NoFacts {
  static constexpr int kFirstLine = 1, kLastLine = DigitalLines::kCount;
  static constexpr auto kSetup = of_line(commands("setup", &DigitalLines::setup));
  static constexpr auto kRead = of_line(reads("read", &DigitalLines::read, Quantity::Level));
  static constexpr auto kWrite =
      of_line(commands("write", &DigitalLines::write, Quantity::WrittenLevel));
  static constexpr auto kReadAll = reads("read_all", &DigitalLines::read_all, Quantity::Lines);
  static constexpr std::tuple kAll{kSetup, kRead, kWrite, kReadAll};
};
template <class Carrier>
class Relay<DigitalLines, Carrier> : public Carrier {
  using Is = Calls<DigitalLines>;

 public:
  using Carrier::Carrier;
  Result<void> setup(int line, LineMode mode) override {
    return this->carry(Is::kSetup, line, mode);
  }
  Result<bool> read(int line) override { return this->carry(Is::kRead, line); }
  Result<std::uint16_t> read_all() override { return this->carry(Is::kReadAll); }
  Result<void> write(int line, bool high) override { return this->carry(Is::kWrite, line, high); }
};

template <>
struct Calls<AnalogInputs> : NoFacts {
  static constexpr int kFirstLine = 0, kLastLine = AnalogInputs::kLast;
  static constexpr auto kSupply =
      with_id(reads("supply_voltage", &AnalogInputs::supply_voltage, Quantity::Voltage),
              AnalogInputs::kSupply);
  static constexpr auto kRead = of_line(reads("read", &AnalogInputs::read, Quantity::Count));
  static constexpr std::tuple kAll{kSupply, kRead};
};
template <class Carrier>
class Relay<AnalogInputs, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<int> read(int channel) override {
    return this->carry(Calls<AnalogInputs>::kRead, channel);
  }
  Result<double> supply_voltage() override { return this->carry(Calls<AnalogInputs>::kSupply); }
};

template <>
struct Calls<IoBoard> : NoFacts {
  static constexpr auto kVersion = reads("version", &IoBoard::version);
  static constexpr std::tuple kAll{kVersion};
};
template <class Carrier>
class Relay<IoBoard, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<std::string> version() override { return this->carry(Calls<IoBoard>::kVersion); }
};

template <>
struct Calls<Remote> : NoFacts {
  static constexpr auto kRead = takes("read", &Remote::read, Quantity::RemoteCode);
  static constexpr std::tuple kAll{kRead};
};
template <class Carrier>
class Relay<Remote, Carrier> : public Carrier {
 public:
  using Carrier::Carrier;
  Result<int> read() override { return this->carry(Calls<Remote>::kRead); }
};

template <>
struct Calls<SerialPort> : NoFacts {
  static constexpr auto kOpen = commands("open", &SerialPort::open);
  static constexpr auto kSend = commands("send", &SerialPort::send);
  static constexpr auto kReceive = takes("receive", &SerialPort::receive);
  static constexpr auto kPending = reads("pending", &SerialPort::pending);
  static constexpr auto kFlush = commands("flush", &SerialPort::flush);
  static constexpr auto kClose = commands("close", &SerialPort::close);
  static constexpr std::tuple kAll{kOpen, kSend, kReceive, kPending, kFlush, kClose};
};
template <class Carrier>
class Relay<SerialPort, Carrier> : public Carrier {
  using Is = Calls<SerialPort>;

 public:
  using Carrier::Carrier;
  Result<void> open(int baud, bool handshake) override {
    return this->carry(Is::kOpen, baud, handshake);
  }
  Result<void> send(std::span<const std::uint8_t> bytes) override {
    return this->carry(Is::kSend, bytes);
  }
  Result<std::size_t> receive(std::span<std::uint8_t> buffer, Time patience) override {
    return this->carry(Is::kReceive, buffer, patience);
  }
  Result<std::size_t> pending() override { return this->carry(Is::kPending); }
  Result<void> flush() override { return this->carry(Is::kFlush); }
  Result<void> close() override { return this->carry(Is::kClose); }
};

template <>
struct Calls<Sound> : NoFacts {
  static constexpr auto kTone = commands("tone", &Sound::tone);
  static constexpr auto kPlay = commands("play", &Sound::play);
  static constexpr auto kIsPlaying = reads("is_playing", &Sound::is_playing);
  static constexpr std::tuple kAll{kTone, kPlay, kIsPlaying};
};
template <class Carrier>
class Relay<Sound, Carrier> : public Carrier {
  using Is = Calls<Sound>;

 public:
  using Carrier::Carrier;
  Result<void> tone(double frequency, double duration) override {
    return this->carry(Is::kTone, frequency, duration);
  }
  Result<void> play(const std::string& path) override { return this->carry(Is::kPlay, path); }
  Result<bool> is_playing() override { return this->carry(Is::kIsPlaying); }
};

template <>
struct Calls<Radio> {
  static constexpr auto kStart = commands("start", &Radio::start);
  static constexpr auto kStop = commands("stop", &Radio::stop);
  static constexpr auto kSend = commands("send", &Radio::send);
  static constexpr auto kReceive = takes("receive", &Radio::receive);
  static constexpr auto kRobots = reads("robots", &Radio::robots);
  static constexpr std::tuple kAll{kStart, kStop, kSend, kReceive, kRobots};
  static constexpr std::tuple kFacts{&Radio::id};
};
template <class Carrier>
class Relay<Radio, Carrier> : public Carrier {
  using Is = Calls<Radio>;

 public:
  using Carrier::Carrier;
  [[nodiscard]] int id() const override { return this->fact(&Radio::id); }
  Result<void> start() override { return this->carry(Is::kStart); }
  Result<void> stop() override { return this->carry(Is::kStop); }
  Result<void> send(int receiver, const std::string& text) override {
    return this->carry(Is::kSend, receiver, text);
  }
  Result<std::optional<RadioMessage>> receive() override { return this->carry(Is::kReceive); }
  Result<std::vector<int>> robots() override { return this->carry(Is::kRobots); }
};

}  // namespace eyebridge::hal
