#include "eyebridge/camera/recording/checked_file.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>
#include <system_error>

#include "eyebridge/base/text.hpp"

namespace eyebridge::camera::sqlite {
namespace {

namespace fs = std::filesystem;

// A text or picture may be as long as the file, of which a writer may make more.
constexpr std::uintmax_t kLeastLimit = std::uintmax_t{64} << 20U;
// Its writer is in the way for a moment while it begins and ends.
constexpr int kPatience_ms = 10'000;
constexpr int kLongestStatement = 4096;  // of ours and of a schema
// Ours takes some hundred steps to read; one that leads in circles does not end.
constexpr int kStepsAtOnce = 1000;
constexpr int kMostSteps = 1000;  // times kStepsAtOnce

/// Bytes of the file and of what its writer has not moved into it yet.
std::uintmax_t size_of(const fs::path& path) {
  std::uintmax_t size = 0;
  for (const char* end : {"", "-wal"}) {
    std::error_code none;
    const std::uintmax_t bytes = fs::file_size(path.string() + end, none);
    if (!none) size += bytes;
  }
  return size;
}

/// https://www.sqlite.org/uri.html: a file without a writer is opened as one that never changes,
/// so that SQLite makes no files beside it.
std::string uri_of(const fs::path& path, bool writable) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  constexpr std::string_view kPlain = "/-_.~";
  std::string uri = "file:";
  for (const char c : fs::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if ((std::isalnum(byte) != 0 && byte < 0x80) || kPlain.find(c) != std::string_view::npos) {
      uri += c;
    } else {
      uri.append(1, '%').append(1, kDigits[byte >> 4U]).append(1, kDigits[byte & 15U]);
    }
  }
  std::error_code none;
  if (!writable && !fs::exists(path.string() + "-wal", none)) uri += "?immutable=1";
  return uri;
}

void harden(sqlite3* database, std::uintmax_t size) {
  const auto set = [&](int option, int value) {
    if (sqlite3_db_config(database, option, value, nullptr) != SQLITE_OK) {
      throw std::runtime_error("this SQLite is too old to read files of others safely");
    }
  };
  set(SQLITE_DBCONFIG_DEFENSIVE, 1);
  set(SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0);
  set(SQLITE_DBCONFIG_ENABLE_TRIGGER, 0);
  set(SQLITE_DBCONFIG_ENABLE_VIEW, 0);
  const std::uintmax_t longest =
      std::min<std::uintmax_t>(std::max(size, kLeastLimit), std::numeric_limits<int>::max());
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH, static_cast<int>(longest));
  sqlite3_limit(database, SQLITE_LIMIT_SQL_LENGTH, kLongestStatement);
  sqlite3_limit(database, SQLITE_LIMIT_ATTACHED, 0);
  sqlite3_limit(database, SQLITE_LIMIT_COLUMN, 32);
  sqlite3_limit(database, SQLITE_LIMIT_EXPR_DEPTH, 32);
  sqlite3_limit(database, SQLITE_LIMIT_COMPOUND_SELECT, 2);
}

/// Reads the schema, which anything may be in.
void read_schema(sqlite3* database) {
  int steps = 0;
  sqlite3_progress_handler(
      database, kStepsAtOnce,
      [](void* count) { return ++*static_cast<int*>(count) > kMostSteps ? 1 : 0; }, &steps);
  const int code =
      sqlite3_exec(database, "SELECT 1 FROM sqlite_schema LIMIT 1", nullptr, nullptr, nullptr);
  sqlite3_progress_handler(database, 0, nullptr, nullptr);
  if (code != SQLITE_OK) throw std::runtime_error(sqlite3_errmsg(database));
}

}  // namespace

Database open_checked(const fs::path& path, bool writable) {
  // A FIFO would wait for its writer, and a device may do anything.
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw std::runtime_error("no such file");
  if (!fs::is_regular_file(status)) throw std::runtime_error("it is no regular file");
  // Played back it changes the file, and removes another one whose name it has.
  const fs::path journal = path.string() + "-journal";
  if (writable && fs::exists(fs::symlink_status(journal, error))) {
    throw std::runtime_error("there is a " + journal.filename().string() +
                             " beside it; expected none: remove it if it is yours");
  }
  sqlite3* opened = nullptr;
  const int flags = (writable ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY) | SQLITE_OPEN_URI;
  const int code = sqlite3_open_v2(uri_of(path, writable).c_str(), &opened, flags, nullptr);
  Database database(opened);
  if (code != SQLITE_OK) throw std::runtime_error(sqlite3_errmsg(opened));
  sqlite3_busy_timeout(opened, kPatience_ms);
  harden(opened, size_of(path));
  read_schema(opened);
  return database;
}

void check_tables(sqlite3* database, std::span<const std::string_view> tables, std::size_t needed,
                  Others others) {
  std::size_t found = 0;
  Rows rows(database, "SELECT rowid,type,name,sql FROM sqlite_schema ORDER BY rowid");
  while (rows.next()) {
    const Statement& row = rows.statement();
    const std::string sql = text(row, 3);
    const auto known = std::ranges::find(tables, sql);
    if (known != tables.end()) {
      if (static_cast<std::size_t>(known - tables.begin()) < needed) ++found;
      continue;
    }
    const std::string name = text(row, 2);
    // Those of PRIMARY KEY and UNIQUE.
    if (text(row, 1) == "index" && name.starts_with("sqlite_autoindex_")) continue;
    const bool is_ours = std::ranges::any_of(tables, [&](std::string_view table) {
      return table.starts_with("CREATE TABLE " + name + "(");
    });
    if (others == Others::Refused || is_ours) {
      throw std::runtime_error("found the " + printable(text(row, 1)) + " " + in_quotes(name) +
                               " that it should not have");
    }
  }
  if (found != needed) throw std::runtime_error("found not all tables that it should have");
}

Rows::Rows(sqlite3* database, const char* sql) : statement_(prepare(database, sql)) {}

bool Rows::next() {
  if (!step(statement_)) return false;
  const std::int64_t key = integer(statement_, 0);
  if (last_ && key <= *last_) throw std::runtime_error("its rows are out of order");
  last_ = key;
  for (int i = 1; i < sqlite3_column_count(statement_.get()); ++i) {
    const int type = sqlite3_column_type(statement_.get(), i);
    if (type == SQLITE_TEXT || type == SQLITE_BLOB) {
      count(sqlite3_column_bytes(statement_.get(), i));
    }
  }
  return true;
}

void Rows::count(std::int64_t bytes) {
  bytes_ += static_cast<std::uint64_t>(std::max<std::int64_t>(bytes, 0));
  if (bytes_ <= size_) return;
  size_ = size_of(sqlite3_db_filename(sqlite3_db_handle(statement_.get()), "main"));
  if (bytes_ > size_) throw std::runtime_error("it speaks of more than it holds");
}

}  // namespace eyebridge::camera::sqlite
