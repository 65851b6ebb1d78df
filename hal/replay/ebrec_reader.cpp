#include "eyebridge/base/config_error.hpp"
#include "replay/ebrec.hpp"
#include "replay/numbers.hpp"
#include "replay/sqlite.hpp"

namespace eyebridge::hal {
namespace {

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, Close>;

Values numbers(sqlite3_stmt* row, int column) {
  const std::string text = sqlite::text(row, column);
  std::optional<Values> values = read_numbers(text);
  if (!values) throw std::runtime_error("found '" + text.substr(0, 40) + "', expected numbers");
  return std::move(*values);
}

void check_version(sqlite3* database) {
  const Statement row(sqlite::prepare(database, "SELECT value FROM meta WHERE key='version'"));
  if (!sqlite::step(row.get())) throw std::runtime_error("it has no version, expected 1");
  if (const std::string found = sqlite::text(row.get(), 0); found != "1") {
    throw std::runtime_error("its version is " + found.substr(0, 40) + ", expected 1");
  }
}

RecordingOrigin read_origin(sqlite3* database) {
  RecordingOrigin origin;
  const Statement row(sqlite::prepare(database, "SELECT key,value FROM meta"));
  while (sqlite::step(row.get())) {
    const std::string key = sqlite::text(row.get(), 0);
    if (key == "program") origin.program = sqlite::text(row.get(), 1);
    if (key == "hal") origin.hal = sqlite::text(row.get(), 1);
    if (key == "world") origin.world = sqlite::text(row.get(), 1);
  }
  return origin;
}

std::vector<RecordedDevice> read_devices(sqlite3* database) {
  std::vector<RecordedDevice> devices;
  const Statement row(sqlite::prepare(database, "SELECT kind,id,facts FROM device"));
  while (sqlite::step(row.get())) {
    devices.push_back(
        {sqlite::text(row.get(), 0), sqlite3_column_int(row.get(), 1), numbers(row.get(), 2)});
  }
  return devices;
}

Result<Values> read_reply(sqlite3_stmt* row) {
  if (sqlite3_column_type(row, 5) != SQLITE_NULL) return numbers(row, 5);
  const int code = sqlite3_column_int(row, 6);
  if (sqlite3_column_type(row, 6) == SQLITE_NULL || code < static_cast<int>(Errc::Timeout) ||
      code > static_cast<int>(Errc::OutOfRange)) {
    throw std::runtime_error("an exchange has neither a reply nor a known error");
  }
  return fail(static_cast<Errc>(code), sqlite::text(row, 7));
}

std::vector<Exchange> read_exchanges(sqlite3* database) {
  std::vector<Exchange> exchanges;
  const Statement row(sqlite::prepare(
      database, "SELECT t,device,id,call,request,reply,error,what FROM exchange ORDER BY seq"));
  while (sqlite::step(row.get())) {
    exchanges.push_back({Time(sqlite3_column_int64(row.get(), 0)), sqlite::text(row.get(), 1),
                         sqlite3_column_int(row.get(), 2), sqlite::text(row.get(), 3),
                         numbers(row.get(), 4), read_reply(row.get())});
  }
  return exchanges;
}

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
  try {
    sqlite3* opened = nullptr;
    const int code = sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
    const std::unique_ptr<sqlite3, Close> database(opened);
    if (code != SQLITE_OK) throw std::runtime_error(sqlite3_errmsg(opened));
    check_version(opened);
    return {read_origin(opened), read_devices(opened), read_exchanges(opened)};
  } catch (const std::runtime_error& error) {
    throw ConfigError({path.string()},
                      fmt::format("{}: expected a recording (.ebrec)", error.what()));
  }
}

}  // namespace eyebridge::hal
