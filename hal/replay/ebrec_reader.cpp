#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/recording/checked_file.hpp"
#include "replay/ebrec.hpp"
#include "replay/numbers.hpp"

namespace eyebridge::hal {
namespace {

namespace sqlite = camera::sqlite;

Values numbers(const sqlite::Statement& row, int column) {
  const std::string text = sqlite::text(row, column);
  std::optional<Values> values = read_numbers(text);
  if (!values) throw std::runtime_error("found " + in_quotes(text, 40) + ", expected numbers");
  return std::move(*values);
}

RecordingOrigin read_origin(sqlite3* database) {
  RecordingOrigin origin;
  sqlite::Rows rows(database, "SELECT rowid,key,value FROM meta ORDER BY rowid");
  while (rows.next()) {
    const sqlite::Statement& row = rows.statement();
    const std::string key = sqlite::text(row, 1);
    if (key == "program") origin.program = sqlite::text(row, 2);
    if (key == "hal") origin.hal = sqlite::text(row, 2);
    if (key == "world") origin.world = sqlite::text(row, 2);
  }
  return origin;
}

std::vector<ListedDevice> read_devices(sqlite3* database) {
  std::vector<ListedDevice> devices;
  sqlite::Rows rows(database, "SELECT rowid,kind,id,facts FROM device ORDER BY rowid");
  while (rows.next()) {
    const sqlite::Statement& row = rows.statement();
    devices.push_back(
        {sqlite::text(row, 1), static_cast<int>(sqlite::integer(row, 2)), numbers(row, 3)});
  }
  return devices;
}

Result<Values> read_reply(const sqlite::Statement& row) {
  if (!sqlite::is_null(row, 6)) return numbers(row, 6);
  const auto code = sqlite::integer(row, 7);
  if (sqlite::is_null(row, 7) || code < static_cast<int>(Errc::Timeout) ||
      code > static_cast<int>(Errc::NoDevice)) {
    throw std::runtime_error("an exchange has neither a reply nor a known error");
  }
  return fail(static_cast<Errc>(code), sqlite::text(row, 8));
}

std::vector<Exchange> read_exchanges(sqlite3* database) {
  std::vector<Exchange> exchanges;
  sqlite::Rows rows(
      database, "SELECT seq,t,device,id,call,request,reply,error,what FROM exchange ORDER BY seq");
  while (rows.next()) {
    const sqlite::Statement& row = rows.statement();
    exchanges.push_back({camera::recorded_time(sqlite::integer(row, 1)), sqlite::text(row, 2),
                         static_cast<int>(sqlite::integer(row, 3)), sqlite::text(row, 4),
                         numbers(row, 5), read_reply(row)});
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
