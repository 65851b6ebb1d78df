#include "eyebridge/base/config_error.hpp"
#include "replay/ebrec.hpp"
#include "replay/numbers.hpp"

namespace eyebridge::hal {
namespace {

namespace sqlite = camera::sqlite;

Values numbers(const sqlite::Statement& row, int column) {
  const std::string text = sqlite::text(row, column);
  std::optional<Values> values = read_numbers(text);
  if (!values) throw std::runtime_error("found '" + text.substr(0, 40) + "', expected numbers");
  return std::move(*values);
}

RecordingOrigin read_origin(sqlite3* database) {
  RecordingOrigin origin;
  const auto row = sqlite::prepare(database, "SELECT key,value FROM meta");
  while (sqlite::step(row)) {
    const std::string key = sqlite::text(row, 0);
    if (key == "program") origin.program = sqlite::text(row, 1);
    if (key == "hal") origin.hal = sqlite::text(row, 1);
    if (key == "world") origin.world = sqlite::text(row, 1);
  }
  return origin;
}

std::vector<ListedDevice> read_devices(sqlite3* database) {
  std::vector<ListedDevice> devices;
  const auto row = sqlite::prepare(database, "SELECT kind,id,facts FROM device");
  while (sqlite::step(row)) {
    devices.push_back(
        {sqlite::text(row, 0), static_cast<int>(sqlite::integer(row, 1)), numbers(row, 2)});
  }
  return devices;
}

Result<Values> read_reply(const sqlite::Statement& row) {
  if (!sqlite::is_null(row, 5)) return numbers(row, 5);
  const auto code = sqlite::integer(row, 6);
  if (sqlite::is_null(row, 6) || code < static_cast<int>(Errc::Timeout) ||
      code > static_cast<int>(Errc::NoDevice)) {
    throw std::runtime_error("an exchange has neither a reply nor a known error");
  }
  return fail(static_cast<Errc>(code), sqlite::text(row, 7));
}

std::vector<Exchange> read_exchanges(sqlite3* database) {
  std::vector<Exchange> exchanges;
  const auto row = sqlite::prepare(
      database, "SELECT t,device,id,call,request,reply,error,what FROM exchange ORDER BY seq");
  while (sqlite::step(row)) {
    exchanges.push_back({Time(sqlite::integer(row, 0)), sqlite::text(row, 1),
                         static_cast<int>(sqlite::integer(row, 2)), sqlite::text(row, 3),
                         numbers(row, 4), read_reply(row)});
  }
  return exchanges;
}

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
  try {
    const sqlite::Database database = camera::open_recording(path);
    return {read_origin(database.get()), read_devices(database.get()),
            read_exchanges(database.get())};
  } catch (const std::runtime_error& error) {
    throw ConfigError({path.string()},
                      std::string(error.what()) + ": expected a recording (.ebrec)");
  }
}

}  // namespace eyebridge::hal
