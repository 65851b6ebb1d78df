#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "eyebridge/camera/recording/sqlite.hpp"

namespace eyebridge::camera::sqlite {

// A database that a stranger may have made: no SQL of its author runs, and reading it takes no more
// time and memory than its size lets expect. All throw std::runtime_error.

/// Whether a database may have tables, indices and views besides those that are expected.
enum class Others { Refused, Ignored };

/// Opens the regular file `path`, to be read only, or to be written as well. Its views and triggers
/// do not work, and functions are not called by its schema
/// (https://www.sqlite.org/security.html). Nothing is written beside a file that is only read, but
/// where its writer has not finished.
Database open_checked(const std::filesystem::path& path, bool writable = false);

/// That `database` has the first `needed` of `tables`, texts of CREATE TABLE, and each as it is
/// written there.
void check_tables(sqlite3* database, std::span<const std::string_view> tables, std::size_t needed,
                  Others others);

/// The rows of a table of such a file. A damaged one may lead in circles: a row comes once, and all
/// texts together are no longer than the file.
class Rows {
 public:
  /// Of `sql`, whose first column grows from row to row (ORDER BY rowid).
  Rows(sqlite3* database, const char* sql);
  /// True when there is another row, at which statement() stands then.
  bool next();
  [[nodiscard]] const Statement& statement() const { return statement_; }
  /// Counts `bytes` that a row speaks of and does not hold.
  void count(std::int64_t bytes);

 private:
  Statement statement_;
  std::optional<std::int64_t> last_;  ///< Key of the row before.
  std::uint64_t bytes_ = 0;
  std::uint64_t size_ = 0;
};

}  // namespace eyebridge::camera::sqlite
