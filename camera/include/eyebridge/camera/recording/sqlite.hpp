#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include <sqlite3.h>

namespace eyebridge::camera::sqlite {

// What recordings need of SQLite 3. All throw std::runtime_error with SQLite's reason.

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, Close>;
/// Must go before its database.
using Statement = std::unique_ptr<sqlite3_stmt, Close>;

inline void run(sqlite3* database, const char* sql) {
  if (sqlite3_exec(database, sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
    throw std::runtime_error(sqlite3_errmsg(database));
  }
}

/// Before a database in WAL mode is closed: then it needs no files beside it, also where readers
/// may not make any. It stays as it is while somebody reads it; that is not waited for.
inline void leave_one_file(sqlite3* database) {
  sqlite3_busy_timeout(database, 0);
  sqlite3_exec(database, "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr);
}

inline Statement prepare(sqlite3* database, const char* sql) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database, sql, -1, &statement, nullptr) != SQLITE_OK) {
    throw std::runtime_error(sqlite3_errmsg(database));
  }
  return Statement(statement);
}

/// True when there is another row.
inline bool step(const Statement& statement) {
  const int code = sqlite3_step(statement.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  throw std::runtime_error(sqlite3_errmsg(sqlite3_db_handle(statement.get())));
}

/// Makes a statement that has run ready for other values.
inline void reset(const Statement& statement) {
  sqlite3_reset(statement.get());
  sqlite3_clear_bindings(statement.get());
}

inline void bind(const Statement& statement, int column, std::string_view text) {
  sqlite3_bind_text(statement.get(), column, text.data(), static_cast<int>(text.size()),
                    SQLITE_TRANSIENT);
}

inline void bind(const Statement& statement, int column, std::int64_t number) {
  sqlite3_bind_int64(statement.get(), column, number);
}

/// `bytes` are lent until the statement has run.
inline void bind(const Statement& statement, int column, std::span<const std::uint8_t> bytes) {
  sqlite3_bind_blob64(statement.get(), column, bytes.data(), bytes.size(), SQLITE_STATIC);
}

inline std::int64_t integer(const Statement& statement, int column) {
  return sqlite3_column_int64(statement.get(), column);
}

inline bool is_null(const Statement& statement, int column) {
  return sqlite3_column_type(statement.get(), column) == SQLITE_NULL;
}

/// Text of a column; "" for null.
inline std::string text(const Statement& statement, int column) {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), column));
  const auto length = static_cast<std::size_t>(sqlite3_column_bytes(statement.get(), column));
  return bytes == nullptr ? std::string() : std::string(bytes, length);
}

/// Bytes of a column, valid until the statement goes on; empty for null.
inline std::span<const std::uint8_t> blob(const Statement& statement, int column) {
  const auto* bytes =
      static_cast<const std::uint8_t*>(sqlite3_column_blob(statement.get(), column));
  const auto length = static_cast<std::size_t>(sqlite3_column_bytes(statement.get(), column));
  return bytes == nullptr ? std::span<const std::uint8_t>() : std::span(bytes, length);
}

}  // namespace eyebridge::camera::sqlite
