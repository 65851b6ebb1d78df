#include "board/dbc_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "board/dbc_commands.hpp"
#include "board/dbc_fields.hpp"
#include "board/dbc_names.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/bridges/dbc/read_dbc.hpp"
#include "eyebridge/bridges/dbc/signal.hpp"
#include "eyebridge/files/readers.hpp"

namespace eyebridge::hal {
namespace {

namespace dbc = bridges::dbc;

constexpr double kHuge = 1e6;
constexpr double kTiny = 1e-6;
constexpr int kLastRangeId = 64;

/// Reads one mapping file.
class MapReader {
 public:
  MapReader(const TomlDocument& document, const dbc::Database& database)
      : document_(document), database_(database), all_(document.table, document, "the file") {}

  DbcRobot read() {
    robot();
    commands();
    wheels();
    for_each("encoder", [this](DbcFields& fields) { encoder(fields); });
    for_each("range", [this](DbcFields& fields) { range(fields); });
    if (const toml::table* table = all_.table("pose")) pose(*table);
    heartbeat();
    stopped();
    all_.finish();
    return std::move(out_);
  }

 private:
  DbcFields fields_of(const toml::table& table, std::string name) const {
    return {table, document_, std::move(name)};
  }

  template <class Read>
  void for_each(std::string_view key, Read&& read) {
    const toml::array* const list = all_.list(key);
    if (list == nullptr) return;
    for (const toml::node& entry : *list) {
      DbcFields fields = fields_of(*entry.as_table(), fmt::format("[[{}]]", key));
      read(fields);
      fields.finish();
    }
  }

  void robot() {
    DbcFields fields = fields_of(all_.need_table("robot"), "[robot]");
    out_.plan.robot = fields.text("name").value_or("robot");
    BoardDriveShape& drive = out_.tables.drive;
    drive.wheel_base = need(fields, "wheel_base", "metres between the wheels");
    shape_.diameter = fields.number("wheel_diameter", kTiny, kHuge);
    shape_.ticks_per_metre = fields.number("ticks_per_metre", kTiny, 1e9);
    drive.max_linear = need(fields, "max_speed", "metres per second");
    drive.max_angular =
        fields.number("max_turn", kTiny, kHuge).value_or(2 * drive.max_linear / drive.wheel_base);
    out_.max_wheel_speed =
        fields.number("max_wheel_speed", kTiny, kHuge).value_or(drive.max_linear);
    out_.plan.has_watchdog = fields.flag("watchdog").value_or(false);
    fields.finish();
    shape_.max_speed = out_.max_wheel_speed;
    // v-omega counts in ticks; where there are none it takes tenths of a millimetre for them.
    constexpr double kTicks = 10'000;
    if (!shape_.ticks_per_metre) shape_.ticks_per_metre = kTicks;
    drive.left_ticks_per_metre = drive.right_ticks_per_metre = *shape_.ticks_per_metre;
  }

  static double need(DbcFields& fields, std::string_view key, std::string_view what) {
    const auto found = fields.number(key, kTiny, kHuge);
    if (!found) {
      fields.refuse(key, fmt::format("found no '{}' in {}, expected {}", key, fields.name(), what));
    }
    return *found;
  }

  void commands() {
    for_each("command", [this](DbcFields& fields) {
      out_.plan.commands.push_back(read_dbc_command(fields, database_, out_.plan.commands));
    });
  }

  void wheels() {
    DbcFields both = fields_of(all_.need_table("wheels"), "[wheels]");
    int id = 0;
    for (const char* const side : {"left", "right"}) {
      DbcFields fields = fields_of(both.need_table(side), fmt::format("[wheels] {}", side));
      const DbcSignalRef ref = signal_of(fields, "signal", database_);
      const double factor = factor_of(fields);
      const double per_speed = units_per_speed(fields, ref.signal(), shape_) / factor;
      out_.plan.wheels.push_back(set_point(fields, ref));
      out_.value_per_speed.at(static_cast<std::size_t>(id)) = per_speed;
      out_.tables.motors.push_back({++id, {}});
      fields.finish();
      for (const double speed : {out_.max_wheel_speed, -out_.max_wheel_speed}) {
        if (dbc::bits_for(ref.signal(), speed * per_speed)) continue;
        const dbc::ValueRange range = dbc::value_range(ref.signal());
        fields.refuse("signal", fmt::format("found a speed of {:.6g} at {:.6g} m/s, expected what "
                                            "{} can say: {:.6g} … {:.6g}",
                                            speed * per_speed, speed, ref.signal().name,
                                            range.lowest, range.highest));
      }
    }
    both.finish();
    if (out_.plan.wheels[0].command == out_.plan.wheels[1].command &&
        out_.plan.wheels[0].signal == out_.plan.wheels[1].signal) {
      both.refuse("right", "found one signal for both wheels, expected one for each");
    }
  }

  bridges::DbcSetPoint set_point(const DbcFields& fields, const DbcSignalRef& ref) {
    const auto is_it = [&](const bridges::DbcCommand& command) {
      return command.message.name == ref.message->name;
    };
    const auto found = std::ranges::find_if(out_.plan.commands, is_it);
    if (found == out_.plan.commands.end()) {
      fields.refuse("signal", fmt::format("found a signal of {}, expected a [[command]] with this "
                                          "message",
                                          ref.message->name));
    }
    const auto zero = dbc::bits_for(ref.signal(), 0);
    if (!zero) fields.refuse("signal", "found a speed that cannot be 0: " + zero.error().what);
    dbc::put_bits(ref.signal(), *zero, found->resting);
    if (!dbc::is_present(*ref.message, ref.index, found->resting)) {
      fields.refuse("signal", fmt::format("found {}, which a multiplexer selects, expected its "
                                          "number in 'constants' of {}",
                                          ref.signal().name, ref.message->name));
    }
    return {static_cast<std::size_t>(found - out_.plan.commands.begin()), ref.index};
  }

  std::size_t status_of(const dbc::Message& message) {
    auto& statuses = out_.plan.statuses;
    const auto found = std::ranges::find(statuses, message.name, &dbc::Message::name);
    if (found != statuses.end()) return static_cast<std::size_t>(found - statuses.begin());
    statuses.push_back(message);
    return statuses.size() - 1;
  }

  std::size_t reading_of(DbcFields& fields, const DbcSignalRef& ref) {
    bridges::DbcReading reading{status_of(*ref.message), ref.index, std::nullopt};
    if (const auto invalid = fields.whole("invalid", 0, std::numeric_limits<long>::max())) {
      reading.invalid = static_cast<std::uint64_t>(*invalid);
    }
    out_.plan.readings.push_back(reading);
    return out_.plan.readings.size() - 1;
  }

  template <class Entry>
  int new_id(DbcFields& fields, const std::vector<Entry>& others) {
    const auto id = fields.whole("id", 1, kLastRangeId);
    if (!id) fields.refuse("id", fmt::format("found no 'id' in {}, expected it", fields.name()));
    if (std::ranges::find(others, static_cast<int>(*id), &Entry::id) != others.end()) {
      fields.refuse("id", fmt::format("found the id {} a second time, expected another one", *id));
    }
    return static_cast<int>(*id);
  }

  void encoder(DbcFields& fields) {
    DbcEncoder encoder;
    encoder.id = new_id(fields, out_.encoders);
    const DbcSignalRef ref = signal_of(fields, "signal", database_);
    const dbc::Signal& signal = ref.signal();
    if (signal.kind != dbc::NumberKind::Signed && signal.kind != dbc::NumberKind::Unsigned) {
      fields.refuse("signal", fmt::format("found {}, a float, expected a counter", signal.name));
    }
    encoder.bits = signal.length;
    encoder.ticks_per_bit =
        factor_of(fields) * signal.factor * ticks_per_unit(fields, signal, shape_);
    encoder.reading = reading_of(fields, ref);
    out_.plan.still.push_back(encoder.reading);
    out_.tables.encoders.push_back(encoder.id);
    out_.encoders.push_back(encoder);
  }

  void range(DbcFields& fields) {
    DbcRange range;
    range.id = new_id(fields, out_.ranges);
    const DbcSignalRef ref = signal_of(fields, "signal", database_);
    range.distance.scale = factor_of(fields) * metres_per_unit(fields, ref.signal());
    range.distance.reading = reading_of(fields, ref);
    out_.tables.psds.push_back({range.id, {}});
    out_.ranges.push_back(range);
  }

  void pose(const toml::table& table) {
    DbcFields all = fields_of(table, "[pose]");
    const auto quantity = [&](std::string_view key, auto&& scale) {
      DbcFields fields = fields_of(all.need_table(key), fmt::format("[pose] {}", key));
      const DbcSignalRef ref = signal_of(fields, "signal", database_);
      DbcQuantity out{0, factor_of(fields) * scale(fields, ref.signal())};
      out.reading = reading_of(fields, ref);
      fields.finish();
      return out;
    };
    DbcPose pose;
    pose.x = quantity("x", metres_per_unit);
    pose.y = quantity("y", metres_per_unit);
    pose.theta = quantity("theta", radians_per_unit);
    all.finish();
    out_.pose = pose;
  }

  void heartbeat() {
    DbcFields fields = fields_of(all_.need_table("heartbeat"), "[heartbeat]");
    const std::string name = fields.need_text("message", "the name of a message");
    const dbc::Message& message = find_message(database_, name, fields, "message");
    const auto timeout = fields.duration("timeout");
    if (!timeout && !message.period_ms) {
      fields.refuse("timeout", fmt::format("found no 'timeout' in [heartbeat], and no cycle time "
                                           "of {} in the DBC file, expected one of them",
                                           name));
    }
    // Three that are missing are no accident.
    out_.plan.heartbeat_limit = timeout.value_or(
        Time{std::chrono::milliseconds(7 * static_cast<long>(message.period_ms.value_or(0)) / 2)});
    out_.plan.heartbeat = status_of(message);
    fields.finish();
  }

  void stopped() {
    const toml::table* const table = all_.table("stopped");
    if (table == nullptr) return;
    DbcFields fields = fields_of(*table, "[stopped]");
    const DbcSignalRef ref = signal_of(fields, "signal", database_);
    if (ref.signal().selector) {
      fields.refuse("signal", fmt::format("found {}, which a multiplexer selects, expected a "
                                          "signal that is always there",
                                          ref.signal().name));
    }
    const auto value = fields.number("value", -1e15, 1e15).value_or(0);
    const auto bits = dbc::bits_for(ref.signal(), value);
    if (!bits) fields.refuse("value", "found a value that cannot be: " + bits.error().what);
    out_.plan.stopped_bits = *bits;
    out_.plan.stopped = reading_of(fields, ref);
    fields.finish();
  }

  const TomlDocument& document_;
  const dbc::Database& database_;
  DbcFields all_;
  DbcWheelShape shape_;
  DbcRobot out_;
};

}  // namespace

DbcRobot read_dbc_map(std::string_view text, const std::string& file,
                      const dbc::Database& database) {
  const TomlDocument document = read_toml_document(text, file);
  return MapReader(document, database).read();
}

DbcRobot load_dbc_robot(const std::string& dbc_path, const std::string& map_path) {
  const dbc::Database database = dbc::read_dbc(files::read_bytes(dbc_path, "a DBC file"), dbc_path);
  return read_dbc_map(files::read_text_file(map_path), map_path, database);
}

}  // namespace eyebridge::hal
