#include "sweep/results.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/hash.hpp"
#include "eyebridge/camera/recording/checked_file.hpp"

namespace eyebridge::apps {
namespace {

namespace sqlite = camera::sqlite;

constexpr auto kSyncPeriod = std::chrono::seconds(1);
constexpr const char* kVersion = "1";
constexpr std::array<std::string_view, 5> kTables = {
    "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL)",
    "CREATE TABLE input(path TEXT PRIMARY KEY, hash TEXT NOT NULL)",
    "CREATE TABLE run(id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, how TEXT NOT NULL,"
    " reason TEXT NOT NULL, exit_code INTEGER, signal INTEGER, time REAL, distance REAL,"
    " collisions INTEGER, state_hash TEXT, wall REAL NOT NULL, cpu REAL NOT NULL)",
    "CREATE TABLE coordinate(run INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,"
    " name TEXT NOT NULL, value TEXT NOT NULL, PRIMARY KEY(run, name))",
    "CREATE TABLE result(run INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,"
    " name TEXT NOT NULL, value NOT NULL, PRIMARY KEY(run, name))"};

// "EBSW"; a file that has another number is not ours.
void make_tables(sqlite3* database) {
  sqlite::run(database, "BEGIN IMMEDIATE; PRAGMA application_id=0x45425357");
  for (const std::string_view table : kTables) sqlite::run(database, std::string(table).c_str());
  sqlite::run(database, "INSERT INTO meta VALUES('version','1'); COMMIT");
}

bool is_empty(sqlite3* database) {
  const auto row = sqlite::prepare(database, "SELECT count(*) FROM sqlite_master");
  return sqlite::step(row) && sqlite::integer(row, 0) == 0;
}

void check_version(sqlite3* database) {
  const auto id = sqlite::prepare(database, "PRAGMA application_id");
  if (!sqlite::step(id) || sqlite::integer(id, 0) != 0x45425357) {
    throw std::runtime_error("found another kind of file");
  }
  // People may add views and indices.
  sqlite::check_tables(database, kTables, kTables.size(), sqlite::Others::Ignored);
  const auto row = sqlite::prepare(database, "SELECT value FROM meta WHERE key='version'");
  if (!sqlite::step(row) || sqlite::text(row, 0) != kVersion) {
    throw std::runtime_error("found another version");
  }
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::runtime_error& error) {
  throw ConfigError({path.string()}, std::string(error.what()) +
                                         "; expected results of eyebridge sweep, or no file");
}

std::string hash_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  StateHash hash;
  std::array<char, 65536> block{};
  while (file.read(block.data(), block.size()), file.gcount() > 0) {
    for (std::streamsize i = 0; i < file.gcount(); ++i) {
      hash.add_byte(static_cast<std::uint8_t>(block[static_cast<std::size_t>(i)]));
    }
  }
  return fmt::format("{:016x}", hash.value());
}

/// Columns that are null without a value.
void bind_number(const sqlite::Statement& statement, int column, double value) {
  sqlite3_bind_double(statement.get(), column, value);
}
template <class Number>
void bind_optional(const sqlite::Statement& statement, int column,
                   const std::optional<Number>& value) {
  if (!value) return;
  if constexpr (std::is_floating_point_v<Number>) {
    bind_number(statement, column, *value);
  } else {
    sqlite::bind(statement, column, static_cast<std::int64_t>(*value));
  }
}

/// The whole of `text` as a finite number.
std::optional<double> as_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::int64_t add_run(sqlite3* database, const Cell& cell, const Outcome& o) {
  const auto add = sqlite::prepare(
      database,
      "INSERT OR REPLACE INTO run(key,how,reason,exit_code,signal,time,distance,collisions,"
      "state_hash,wall,cpu) VALUES(?,?,?,?,?,?,?,?,?,?,?)");
  sqlite::bind(add, 1, cell.key());
  sqlite::bind(add, 2, o.how);
  sqlite::bind(add, 3, o.reason);
  bind_optional(add, 4, o.exit_code);
  bind_optional(add, 5, o.signal);
  bind_optional(add, 6, o.time);
  bind_optional(add, 7, o.distance);
  bind_optional(add, 8, o.collisions);
  if (!o.state_hash.empty()) sqlite::bind(add, 9, o.state_hash);
  bind_number(add, 10, o.wall);
  bind_number(add, 11, o.cpu);
  sqlite::step(add);
  return sqlite3_last_insert_rowid(database);
}

void add_pair(const sqlite::Statement& add, std::int64_t run, const std::string& name,
              const std::string& value, bool maybe_number) {
  sqlite::reset(add);
  sqlite::bind(add, 1, run);
  sqlite::bind(add, 2, name);
  const auto number = maybe_number ? as_number(value) : std::nullopt;
  if (number) {
    bind_number(add, 3, *number);
  } else {
    sqlite::bind(add, 3, value);
  }
  sqlite::step(add);
}

}  // namespace

ResultsFile::ResultsFile(const std::filesystem::path& path, std::string flag)
    : file_(path.string()), flag_(std::move(flag)) {
  lock_.reset(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (!lock_.valid()) throw ConfigError({file_}, std::string("cannot write: ") + strerror(errno));
  if (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw ConfigError({file_}, fmt::format("another sweep is writing it; expected to be alone ({} "
                                           "names another place)",
                                           flag_));
  }
  try {
    database_ = sqlite::open_checked(path, true);
    sqlite::run(database_.get(), "PRAGMA foreign_keys=ON");
    if (is_empty(database_.get())) make_tables(database_.get());
    check_version(database_.get());
    sqlite::run(database_.get(), "PRAGMA journal_mode=WAL");  // only now: it changes the file
  } catch (const std::runtime_error& error) {
    refuse(path, error);
  }
}

ResultsFile::~ResultsFile() { sqlite::leave_one_file(database_.get()); }

void ResultsFile::note_input(const std::filesystem::path& path) {
  const std::string hash = hash_of(path);
  const auto present = sqlite::prepare(database_.get(), "SELECT hash FROM input WHERE path=?");
  sqlite::bind(present, 1, path.string());
  if (sqlite::step(present)) {
    if (sqlite::text(present, 0) == hash) return;
    throw ConfigError({file_},
                      fmt::format("holds runs of another version of {}; expected the same, "
                                  "or another place ({})",
                                  path.string(), flag_));
  }
  const auto add = sqlite::prepare(database_.get(), "INSERT INTO input VALUES(?,?)");
  sqlite::bind(add, 1, path.string());
  sqlite::bind(add, 2, hash);
  sqlite::step(add);
}

std::set<std::string> ResultsFile::keys(bool well_only) const {
  const auto row = sqlite::prepare(
      database_.get(), well_only ? "SELECT key FROM run WHERE how IN ('ended','time limit')"
                                 : "SELECT key FROM run");
  std::set<std::string> out;
  while (sqlite::step(row)) out.insert(sqlite::text(row, 0));
  return out;
}

void ResultsFile::add(const Cell& cell, const Outcome& outcome) {
  sqlite3* database = database_.get();
  // Waiting for the disk after each run would take as long as a short run.
  const auto now = std::chrono::steady_clock::now();
  const bool waits = now - synced_ >= kSyncPeriod;
  if (waits) synced_ = now;
  sqlite::run(database, waits ? "PRAGMA synchronous=FULL" : "PRAGMA synchronous=NORMAL");
  sqlite::run(database, "BEGIN IMMEDIATE");
  try {
    const std::int64_t run = add_run(database, cell, outcome);
    const auto coordinate = sqlite::prepare(database, "INSERT INTO coordinate VALUES(?,?,?)");
    for (const auto& [name, value] : cell.coordinates()) {
      add_pair(coordinate, run, name, value, false);
    }
    const auto result = sqlite::prepare(database, "INSERT INTO result VALUES(?,?,?)");
    for (const auto& [name, value] : outcome.results) add_pair(result, run, name, value, true);
    sqlite::run(database, "COMMIT");
  } catch (...) {
    sqlite3_exec(database, "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
}

std::vector<ResultRow> read_results_file(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 5> kColumns = {"time", "distance", "collisions", "wall",
                                                        "cpu"};
  try {
    const sqlite::Database database = sqlite::open_checked(path);
    check_version(database.get());
    const auto runs = sqlite::prepare(
        database.get(),
        "SELECT id,how,time,distance,collisions,wall,cpu,key,reason,state_hash FROM run "
        "ORDER BY id");
    const auto coordinates =
        sqlite::prepare(database.get(), "SELECT name,value FROM coordinate WHERE run=?");
    const auto results = sqlite::prepare(
        database.get(),
        "SELECT name,value FROM result WHERE run=? AND typeof(value) IN ('real','integer')");
    std::vector<ResultRow> rows;
    while (sqlite::step(runs)) {
      ResultRow& row = rows.emplace_back();
      row.how = sqlite::text(runs, 1);
      row.key = sqlite::text(runs, 7);
      row.reason = sqlite::text(runs, 8);
      if (!sqlite::is_null(runs, 9)) row.state_hash = sqlite::text(runs, 9);
      for (int i = 0; i < static_cast<int>(kColumns.size()); ++i) {
        if (sqlite::is_null(runs, 2 + i)) continue;
        row.values[std::string(kColumns[static_cast<std::size_t>(i)])] =
            sqlite3_column_double(runs.get(), 2 + i);
      }
      for (const auto* pairs : {&coordinates, &results}) {
        sqlite::reset(*pairs);
        sqlite::bind(*pairs, 1, sqlite::integer(runs, 0));
      }
      while (sqlite::step(coordinates)) {
        row.coordinates[sqlite::text(coordinates, 0)] = sqlite::text(coordinates, 1);
      }
      while (sqlite::step(results)) {
        std::string name = sqlite::text(results, 0);
        // A program may call its own numbers as we call ours.
        if (std::ranges::find(kColumns, name) != kColumns.end()) name = "result." + name;
        row.values[name] = sqlite3_column_double(results.get(), 1);
      }
    }
    return rows;
  } catch (const std::runtime_error& error) {
    refuse(path, error);
  }
}

}  // namespace eyebridge::apps
