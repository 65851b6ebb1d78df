#include <algorithm>
#include <array>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/hdt.hpp"
#include "hdt_table_reader.hpp"
#include "hdt_words.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr std::array<std::string_view, 17> kHdtKeywords = {
    "EYEBOT", "SSID",  "ROBIOS", "LCD", "IRTV", "USB",    "MOTOR",    "SERVO",       "ENCODER",
    "PSD",    "DRIVE", "TABLE",  "CAM", "ADC",  "SERIAL", "DEMOPATH", "SOFTWAREPATH"};
constexpr int kMotors = 4;
constexpr int kServos = 14;
constexpr int kPsds = 6;
constexpr int kUsbDevices = 20;
constexpr int kMostDevices = 255;  // of a kind, in the named dialect
constexpr double kMostMm = 1e4;

bool flag(const Statement& s, std::size_t i, std::string_view what) {
  return s.integer(i, what, 0, 1) != 0;
}

class HdtReader {
 public:
  HdtReader(std::string_view text, const std::string& file, Warnings& warnings)
      : file_(file), plain_(commas_blanked(text)), lines_(plain_, file), warnings_(warnings) {}

  Hdt read() {
    Statement s;
    while (lines_.next(s)) {
      if (tables_.take(s)) {
        any_ = true;
      } else {
        read_statement(s);
      }
    }
    tables_.finish(lines_.line());
    if (!any_) {
      throw ConfigError({file_, std::max(1, lines_.line()), 1},
                        "no keyword of an HDT in it: expected " + one_of(kHdtKeywords));
    }
    resolve();
    return std::move(out_);
  }

 private:
  void read_statement(const Statement& s) {
    const std::string keyword = lower(s.text(0));
    if (s.is_number(0) || keyword == "end") {
      s.fail(0, in_quotes(s.text(0)) + " outside a table: expected a keyword or TABLE before it");
    }
    bool known = true;
    if (keyword == "motor" || keyword == "servo" || keyword == "encoder" || keyword == "psd" ||
        keyword == "drive") {
      settle_dialect(s);
      const bool named = out_.dialect == HdtDialect::Named;
      if (keyword == "motor") named ? named_motor(s) : motor(s);
      if (keyword == "servo") named ? named_servo(s) : servo(s);
      if (keyword == "encoder") named ? named_encoder(s) : encoder(s);
      if (keyword == "psd") named ? named_psd(s) : psd(s);
      if (keyword == "drive") named ? named_drive(s) : drive(s);
    } else if (keyword == "irtv") {
      remote(s);
    } else if (keyword == "cam" || keyword == "adc" || keyword == "serial") {
      named_only(s, keyword);
    } else if (!machine(s, keyword)) {
      known = false;
      unknown(s);
    }
    any_ = any_ || known;
  }

  void unknown(const Statement& s) {
    const std::string_view near = nearest(s.text(0), kHdtKeywords);
    const bool compass = lower(s.text(0)) == "compass";
    warnings_.add(s.line(), s.token(0).column,
                  compass ? "COMPASS ignored: its fields are not documented"
                          : in_quotes(s.text(0)) + " ignored: expected " +
                                (near.empty() ? one_of(kHdtKeywords) : in_quotes(near) + "?"));
  }

  /// What the numbered dialect says of the computer. False for other keywords.
  bool machine(const Statement& s, const std::string& keyword) {
    if (keyword == "eyebot") {
      if (s.size() < 2) s.fail(1, "line ends: expected the robot's name");
      out_.name = s.rest(1);
    } else if (keyword == "ssid") {
      s.expect_arguments({2, 3}, "SSID network 0|1 password");
      out_.network = s.text(1);
      out_.joins_network = flag(s, 2, "0 (hotspot) or 1 (join)");
    } else if (keyword == "robios") {
      s.expect_arguments(1, "ROBIOS 0|1");
      out_.starts_at_boot = flag(s, 1, "0 or 1");
    } else if (keyword == "lcd") {
      s.expect_arguments(1, "LCD 0|1");
      out_.lcd_orientation = s.integer(1, "the orientation", 0, 1);
    } else if (keyword == "usb") {
      s.expect_arguments(2, "USB number name");
      const int id = s.integer(1, "the number of the interface", 0, kUsbDevices);
      for (const HdtSerial& other : out_.serials) {
        if (other.id == id) s.fail(1, "a second USB " + std::to_string(id) + ": expected one");
      }
      out_.serials.push_back({id, std::string(s.text(2)), ""});
    } else if (keyword == "demopath" || keyword == "softwarepath") {
      if (s.size() < 2) s.fail(1, "line ends: expected a folder");
      (keyword == "demopath" ? out_.demo_path : out_.software_path) = s.rest(1);
    } else {
      return false;
    }
    return true;
  }

  /// Where a device is named by a quoted word, the file is of the named dialect, all of it.
  void settle_dialect(const Statement& s) {
    if (s.size() < 2) s.fail(1, "line ends: expected a number or a quoted name");
    const auto dialect = s.token(1).quoted ? HdtDialect::Named : HdtDialect::Numbered;
    if (dialect_line_ == 0) {
      out_.dialect = dialect;
      dialect_line_ = s.line();
    } else if (dialect != out_.dialect) {
      s.fail(1, in_quotes(s.text(1)) + " found: expected " +
                    (out_.dialect == HdtDialect::Named ? "a quoted name" : "a number") +
                    ", as in line " + std::to_string(dialect_line_));
    }
  }

  /// A new device of `list`, with the number of token 1.
  template <class Device>
  Device& add(const Statement& s, std::vector<Device>& list, std::string_view what, int most) {
    const int id = s.integer(1, "the number of the " + std::string(what), 1, most);
    for (const Device& other : list) {
      if (other.id == id) {
        s.fail(1, std::string(what) + " " + std::to_string(id) + " is given twice, first in line " +
                      std::to_string(other.where.line) + ": expected one");
      }
    }
    Device& device = list.emplace_back();
    device.id = id;
    device.where = s.where(0);
    return device;
  }

  /// A new device of `list`, with the name of token 1.
  template <class Device>
  Device& add_named(const Statement& s, std::vector<Device>& list) {
    for (const Device& other : list) {
      if (other.name == s.text(1)) {
        s.fail(1, in_quotes(s.text(1)) + " is given twice, first in line " +
                      std::to_string(other.where.line) + ": expected one");
      }
    }
    if (list.size() >= kMostDevices) {
      s.fail(0, "too many devices: expected at most " + std::to_string(kMostDevices));
    }
    Device& device = list.emplace_back();
    device.id = static_cast<int>(list.size());
    device.name = s.text(1);
    device.where = s.where(0);
    return device;
  }

  void use_table(const Statement& s, std::size_t i, HdtUse use, int id) {
    if (i < s.size()) uses_.push_back({use, id, std::string(s.text(i)), s.where(i)});
  }

  void motor(const Statement& s) {
    s.expect_arguments({1, 2}, "MOTOR number table");
    use_table(s, 2, HdtUse::Motor, add(s, out_.motors, "motor", kMotors).id);
  }
  void named_motor(const Statement& s) {
    s.expect_arguments({3, 4}, "MOTOR \"name\" register frequency \"table\"");
    HdtMotor& motor = add_named(s, out_.motors);
    motor.address = hex(s, 2, "the register");
    motor.pwm_frequency = s.integer(3, "the PWM frequency", 1, 1000000);
    use_table(s, 4, HdtUse::Motor, motor.id);
  }

  static void pulses(const Statement& s, std::size_t i, HdtServo& servo) {
    const double shortest = s.number(i, "the shortest pulse (us)", 1, 20000);
    const double longest = s.number(i + 1, "the longest pulse (us)", 1, 20000);
    if (longest <= shortest) s.fail(i + 1, "longest pulse found: expected more than the shortest");
    servo.shortest_pulse = shortest * 1e-6;
    servo.longest_pulse = longest * 1e-6;
  }
  void servo(const Statement& s) {
    s.expect_arguments({3, 4}, "SERVO number shortest longest [table]");
    HdtServo& servo = add(s, out_.servos, "servo", kServos);
    pulses(s, 2, servo);
    use_table(s, 4, HdtUse::Servo, servo.id);
  }
  void named_servo(const Statement& s) {
    s.expect_arguments(5, "SERVO \"name\" register frequency shortest longest");
    HdtServo& servo = add_named(s, out_.servos);
    servo.address = hex(s, 2, "the register");
    servo.frequency = s.integer(3, "the frequency", 1, 1000000);
    pulses(s, 4, servo);
  }

  void encoder(const Statement& s) {
    s.expect_arguments(2, "ENCODER number ticks_per_metre");
    HdtEncoder& encoder = add(s, out_.encoders, "encoder", kMotors);
    encoder.ticks_per_metre = s.number(2, "ticks per metre", 1, 1e7);
    encoder.motor = encoder.id;
  }
  void named_encoder(const Statement& s) {
    s.expect_arguments(5, "ENCODER \"name\" register ticks_per_metre max_speed \"motor\"");
    HdtEncoder& encoder = add_named(s, out_.encoders);
    encoder.address = hex(s, 2, "the register");
    encoder.ticks_per_metre = s.number(3, "ticks per metre", 1, 1e7);
    encoder.max_speed = s.number(4, "the top speed", 0, 1e7);
    names_.push_back({HdtUse::Motor, encoder.id, std::string(s.text(5)), s.where(5)});
  }

  void psd(const Statement& s) {
    s.expect_arguments(2, "PSD number table");
    use_table(s, 2, HdtUse::Psd, add(s, out_.psds, "PSD", kPsds).id);
  }
  void named_psd(const Statement& s) {
    s.expect_arguments(3, "PSD \"name\" register \"table\"");
    HdtPsd& psd = add_named(s, out_.psds);
    psd.address = hex(s, 2, "the register");
    use_table(s, 3, HdtUse::Psd, psd.id);
  }

  HdtDrive& new_drive(const Statement& s) {
    if (out_.drive) {
      s.fail(0, "a second DRIVE, after the one in line " + std::to_string(out_.drive->where.line) +
                    ": expected one");
    }
    HdtDrive& drive = out_.drive.emplace();
    drive.where = s.where(0);
    return drive;
  }
  void drive(const Statement& s) {
    s.expect_arguments(4, "DRIVE wheel_distance_mm max_speed_cm_s left_direction right_direction");
    HdtDrive& drive = new_drive(s);
    drive.wheel_base = s.millimetres(1, "the distance between the wheels", 1, kMostMm);
    drive.max_speed = cm_to_m(s.number(2, "the top speed (cm/s)", 1, 1e4));
    drive.left_clockwise = flag(s, 3, "the left motor's direction");
    drive.right_clockwise = flag(s, 4, "the right motor's direction");
  }
  void named_drive(const Statement& s) {
    HdtDrive& drive = new_drive(s);
    drive.name = s.text(1);
    const std::string kind = s.size() > 2 ? lower(s.text(2)) : "";
    const auto length = [&](std::size_t i, std::string_view what) {
      return s.millimetres(i, what, 1, kMostMm);
    };
    std::size_t first_encoder = 4;
    std::size_t wheels = 2;
    if (kind == "differential") {
      s.expect_arguments(5, "DRIVE \"name\" DIFFERENTIAL wheel_distance \"left\" \"right\"");
    } else if (kind == "ackermann") {
      s.expect_arguments(7, "DRIVE \"name\" ACKERMANN front rear axles \"left\" \"right\"");
      drive.kind = robot::DriveKind::Ackermann;
      drive.rear_wheel_base = length(4, "the distance between the rear wheels");
      drive.axle_distance = length(5, "the distance between the axles");
      first_encoder = 6;
    } else if (kind == "omni") {
      s.expect_arguments(8, "DRIVE \"name\" OMNI wheel_distance axles \"1\" \"2\" \"3\" \"4\"");
      drive.kind = robot::DriveKind::Omni;
      drive.axle_distance = length(4, "the distance between the axles");
      first_encoder = 5;
      wheels = 4;
    } else {
      s.fail(2, (s.size() > 2 ? in_quotes(s.text(2)) + " found" : "line ends") +
                    ": expected DIFFERENTIAL, ACKERMANN or OMNI");
    }
    drive.wheel_base = length(3, "the distance between the wheels");
    drive.encoders.assign(wheels, 0);
    for (std::size_t i = 0; i < wheels; ++i) {
      names_.push_back({HdtUse::Drive, static_cast<int>(i), std::string(s.text(first_encoder + i)),
                        s.where(first_encoder + i)});
    }
  }

  void remote(const Statement& s) {
    if (s.size() > 1 && !s.token(1).quoted) {
      s.expect_arguments(1, "IRTV 0|1");
      out_.remote_enabled = flag(s, 1, "0 or 1");
      return;
    }
    s.expect_arguments(8, "IRTV \"name\" type length toggle_mask invert_mask mode buffer delay");
    const auto count = [&](std::size_t i, std::string_view what) {
      return s.integer(i, what, 0, 1000000);
    };
    out_.remotes.push_back({std::string(s.text(1)), count(2, "the type"), count(3, "the length"),
                            hex(s, 4, "the toggle mask"), hex(s, 5, "the invert mask"),
                            count(6, "the mode"), count(7, "the buffer size"),
                            count(8, "the delay")});
  }

  void named_only(const Statement& s, const std::string& keyword) {
    if (keyword == "cam") {
      s.expect_arguments(5, "CAM \"name\" register io width height");
      if (out_.camera) s.fail(0, "a second CAM: expected one");
      HdtCamera& camera = out_.camera.emplace();
      camera.id = 1;
      camera.name = s.text(1);
      camera.where = s.where(0);
      camera.address = hex(s, 2, "the register");
      camera.io = s.integer(3, "the io number", 0, 1000000);
      camera.width = s.integer(4, "the width", 1, 65535);
      camera.height = s.integer(5, "the height", 1, 65535);
    } else if (keyword == "adc") {
      s.expect_arguments(3, "ADC \"name\" constant \"procedure\"");
      add_named(s, out_.adcs).address = s.integer(2, "the constant", 0, 1000000);
    } else {
      s.expect_arguments(2, "SERIAL \"name\" \"device\"");
      out_.serials.push_back(
          {static_cast<int>(out_.serials.size()), std::string(s.text(1)), std::string(s.text(2))});
    }
  }

  template <class Device>
  static Device& with_id(std::vector<Device>& list, int id) {
    return *std::find_if(list.begin(), list.end(), [&](const Device& d) { return d.id == id; });
  }
  template <class Device>
  static int named(const std::vector<Device>& list, const HdtReference& reference,
                   const char* what) {
    for (const Device& device : list) {
      if (device.name == reference.name) return device.id;
    }
    throw ConfigError(reference.where, in_quotes(reference.name) + " found: expected the name of " +
                                           what + " of this file");
  }

  void resolve() {
    for (const HdtReference& use : uses_) {
      const std::size_t table = tables_.index_for(use);
      if (use.use == HdtUse::Motor) with_id(out_.motors, use.id).table = table;
      if (use.use == HdtUse::Servo) with_id(out_.servos, use.id).table = table;
      if (use.use == HdtUse::Psd) with_id(out_.psds, use.id).table = table;
    }
    for (const HdtReference& use : names_) {
      if (use.use == HdtUse::Motor) {
        with_id(out_.encoders, use.id).motor = named(out_.motors, use, "a MOTOR");
      } else {
        out_.drive->encoders[static_cast<std::size_t>(use.id)] =
            named(out_.encoders, use, "an ENCODER");
      }
    }
    const auto by_id = [](const HdtDevice& a, const HdtDevice& b) { return a.id < b.id; };
    std::sort(out_.motors.begin(), out_.motors.end(), by_id);
    std::sort(out_.servos.begin(), out_.servos.end(), by_id);
    std::sort(out_.encoders.begin(), out_.encoders.end(), by_id);
    std::sort(out_.psds.begin(), out_.psds.end(), by_id);
    out_.tables = tables_.release();
  }

  const std::string& file_;
  std::string plain_;
  StatementReader lines_;
  Warnings& warnings_;
  HdtTableReader tables_{file_};
  std::vector<HdtReference> uses_;   ///< Of tables.
  std::vector<HdtReference> names_;  ///< Of motors (by encoders) and encoders (by the drive).
  Hdt out_;
  int dialect_line_ = 0;
  bool any_ = false;  ///< A line with a known keyword.
};

}  // namespace

Hdt read_hdt(std::string_view text, const std::string& file, std::vector<Warning>& out_warnings) {
  Warnings warnings(file, out_warnings);
  return HdtReader(text, file, warnings).read();
}

}  // namespace eyebridge::files
