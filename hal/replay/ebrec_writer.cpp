#include <system_error>

#include "eyebridge/base/config_error.hpp"
#include "replay/ebrec.hpp"
#include "replay/numbers.hpp"
#include "replay/sqlite.hpp"

namespace eyebridge::hal {
namespace {

constexpr Time kCommitPeriod = std::chrono::seconds(1);

constexpr const char* kSchema =
    "PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL; PRAGMA application_id=0x45425243;"
    "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL);"
    "CREATE TABLE device(kind TEXT NOT NULL, id INTEGER NOT NULL, facts TEXT NOT NULL);"
    "CREATE TABLE exchange(seq INTEGER PRIMARY KEY, t INTEGER NOT NULL, device TEXT NOT NULL,"
    " id INTEGER NOT NULL, call TEXT NOT NULL, request TEXT NOT NULL, reply TEXT, error INTEGER,"
    " what TEXT);"
    "INSERT INTO meta VALUES('version','1');";

}  // namespace

void EbrecWriter::Close::operator()(sqlite3* database) const { sqlite3_close(database); }
void EbrecWriter::Close::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

EbrecWriter::EbrecWriter(const std::filesystem::path& path,
                         const std::vector<RecordedDevice>& devices,
                         const RecordingOrigin& origin) {
  for (const char* end : {"", "-wal", "-shm"}) {
    std::error_code ignored;  // what cannot be removed cannot be written either: SQLite will say so
    std::filesystem::remove(path.string() + end, ignored);
  }
  try {
    sqlite3* database = nullptr;
    const int code = sqlite3_open(path.c_str(), &database);
    database_.reset(database);
    if (code != SQLITE_OK) throw std::runtime_error(sqlite3_errmsg(database));
    sqlite::run(database, kSchema);
    const std::unique_ptr<sqlite3_stmt, Close> add_fact(
        sqlite::prepare(database, "INSERT INTO meta VALUES(?,?)"));
    for (const auto& [key, value] : std::initializer_list<std::pair<const char*, std::string_view>>{
             {"program", origin.program}, {"hal", origin.hal}, {"world", origin.world}}) {
      sqlite::bind(add_fact.get(), 1, key);
      sqlite::bind(add_fact.get(), 2, value);
      sqlite::step(add_fact.get());
      sqlite3_reset(add_fact.get());
    }
    const std::unique_ptr<sqlite3_stmt, Close> add_device(
        sqlite::prepare(database, "INSERT INTO device VALUES(?,?,?)"));
    for (const RecordedDevice& device : devices) {
      sqlite::bind(add_device.get(), 1, device.kind);
      sqlite3_bind_int(add_device.get(), 2, device.id);
      sqlite::bind(add_device.get(), 3, write_numbers(device.facts));
      sqlite::step(add_device.get());
      sqlite3_reset(add_device.get());
    }
    insert_.reset(sqlite::prepare(database,
                                  "INSERT INTO exchange(t,device,id,call,request,reply,error,what) "
                                  "VALUES(?,?,?,?,?,?,?,?)"));
  } catch (const std::runtime_error& error) {
    throw ConfigError({}, fmt::format("cannot write {}: {}", path.string(), error.what()));
  }
}

EbrecWriter::~EbrecWriter() {
  try {
    commit();
  } catch (const std::runtime_error&) {  // add() has met it, or will not come any more
  }
}

void EbrecWriter::commit() {
  if (!std::exchange(pending_, false)) return;
  sqlite::run(database_.get(), "COMMIT");
}

void EbrecWriter::add(Time time, const Call& call, const Result<Values>& reply) {
  if (pending_ && time - committed_ >= kCommitPeriod) commit();
  if (!pending_) {
    sqlite::run(database_.get(), "BEGIN");
    pending_ = true;
    committed_ = time;
  }
  sqlite3_stmt* row = insert_.get();
  sqlite3_reset(row);
  sqlite3_clear_bindings(row);
  sqlite3_bind_int64(row, 1, time.count());
  sqlite::bind(row, 2, call.device);
  sqlite3_bind_int(row, 3, call.id);
  sqlite::bind(row, 4, call.name);
  sqlite::bind(row, 5, write_numbers(call.request));
  if (reply) {
    sqlite::bind(row, 6, write_numbers(*reply));
  } else {
    sqlite3_bind_int(row, 7, static_cast<int>(reply.error().code));
    sqlite::bind(row, 8, reply.error().what);
  }
  sqlite::step(row);
}

}  // namespace eyebridge::hal
