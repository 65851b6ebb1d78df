#include "eyebridge/camera/recording/recording_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <span>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/deaf_thread.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/recording/checked_file.hpp"

namespace eyebridge::camera {
namespace {

constexpr Time kCommitPeriod = std::chrono::seconds(1);
constexpr auto kRealCommitPeriod = std::chrono::milliseconds(500);
// While a recording begins, and while it is closed, whoever looks at it is in the way for a moment.
constexpr int kPatience_ms = 2000;

// "EBRC". It is written first: it identifies a recording even if its program was killed.
constexpr std::array<char, 4> kApplication = {'E', 'B', 'R', 'C'};
constexpr std::array<std::string_view, 4> kTables = {
    "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL)",
    "CREATE TABLE device(kind TEXT NOT NULL, id INTEGER NOT NULL, facts TEXT NOT NULL)",
    "CREATE TABLE exchange(seq INTEGER PRIMARY KEY, t INTEGER NOT NULL, device TEXT NOT NULL,"
    " id INTEGER NOT NULL, call TEXT NOT NULL, request TEXT NOT NULL, reply TEXT, error INTEGER,"
    " what TEXT)",
    "CREATE TABLE frame(seq INTEGER PRIMARY KEY, t INTEGER NOT NULL, taken INTEGER NOT NULL,"
    " sequence INTEGER NOT NULL, width INTEGER NOT NULL, height INTEGER NOT NULL,"
    " format TEXT NOT NULL, codec TEXT NOT NULL, data BLOB NOT NULL)"};
constexpr std::size_t kNeeded = 3;  // there was a time when recordings had no frames

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw ConfigError({}, "cannot write " + path.string() + ": " + why);
}

/// Whether the file is empty or a recording: only these are replaced. The header is that of
/// sqlite.org's "Database File Format", section 1.3.
bool may_be_replaced(int file) {
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  constexpr std::size_t kIdAt = 68;
  std::array<char, 100> header{};
  const ssize_t got = pread(file, header.data(), header.size(), 0);
  return got == 0 ||
         (got == std::ssize(header) &&
          std::ranges::equal(kMagic, std::span(header).first(kMagic.size())) &&
          std::ranges::equal(kApplication, std::span(header).subspan(kIdAt, kApplication.size())));
}

/// Makes an empty file at `path` and locks it. Removes an earlier recording that nobody is writing,
/// and nothing else. Throws ConfigError.
UniqueFd claim(const std::filesystem::path& path) {
  constexpr int kTries = 10;  // others may begin at the same moment
  for (int i = 0; i < kTries; ++i) {
    UniqueFd file(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666));
    struct stat opened = {};
    struct stat there = {};
    if (!file.valid() || fstat(file.get(), &opened) != 0) refuse(path, std::strerror(errno));
    if (!S_ISREG(opened.st_mode))
      refuse(path, "it is no regular file; expected a new name, or an earlier recording");
    if (flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
      refuse(path, errno == EWOULDBLOCK ? "another run records into it; expected another name"
                                        : std::strerror(errno));
    }
    if (!may_be_replaced(file.get())) {
      refuse(path, "it is no recording; expected a new name, or an earlier recording");
    }
    if (stat(path.c_str(), &there) != 0 || there.st_ino != opened.st_ino) continue;
    if (opened.st_size == 0) return file;
    // A new file, and not this one made empty: somebody may replay it.
    for (const char* end : {"-wal", "-shm", ""}) {  // the one with the lock last
      std::error_code ignored;  // what cannot be removed will be refused in the next round
      std::filesystem::remove(path.string() + end, ignored);
    }
  }
  refuse(path, "it cannot be removed; expected a new name, or a folder in which it can be");
}

sqlite::Database make_database(const std::filesystem::path& path, const RecordingFacts& facts) {
  sqlite3* opened = nullptr;
  const int code = sqlite3_open(path.c_str(), &opened);
  sqlite::Database database(opened);
  if (code != SQLITE_OK) throw std::runtime_error(sqlite3_errmsg(opened));
  sqlite3_busy_timeout(opened, kPatience_ms);
  sqlite::run(opened,
              "PRAGMA application_id=0x45425243; PRAGMA journal_mode=WAL; "
              "PRAGMA synchronous=NORMAL");
  sqlite::run(opened, "BEGIN");
  for (const std::string_view table : kTables) sqlite::run(opened, std::string(table).c_str());
  sqlite::run(opened, "INSERT INTO meta VALUES('version','1')");
  const sqlite::Statement add = sqlite::prepare(opened, "INSERT INTO meta VALUES(?,?)");
  for (const auto& [key, value] : facts) {
    sqlite::reset(add);
    sqlite::bind(add, 1, key);
    sqlite::bind(add, 2, value);
    sqlite::step(add);
  }
  sqlite::run(opened, "COMMIT");
  return database;
}

}  // namespace

RecordingFile::RecordingFile(const std::filesystem::path& path, const RecordingFacts& facts) {
  lock_ = claim(path);
  try {
    database_ = make_database(path, facts);
  } catch (const std::runtime_error& error) {
    refuse(path, error.what());
  }
  committer_ = deaf_thread([this] { keep_committing(); });
}

RecordingFile::~RecordingFile() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  ended_.notify_all();
  committer_.join();
  try {
    commit();
    sqlite::leave_one_file(database_.get());
  } catch (const std::runtime_error&) {  // write() has met it, or will not come any more
  }
}

sqlite::Statement RecordingFile::prepare(const char* sql) {
  const std::lock_guard lock(mutex_);
  return sqlite::prepare(database_.get(), sql);
}

void RecordingFile::write(Time time, const std::function<void()>& add_rows) {
  const std::lock_guard lock(mutex_);
  if (!failure_.empty()) throw std::runtime_error(failure_);
  if (pending_ && time - begun_ >= kCommitPeriod) commit_pending();
  if (!pending_) {
    sqlite::run(database_.get(), "BEGIN");
    pending_ = true;
    begun_ = time;
  }
  add_rows();
}

void RecordingFile::commit() {
  const std::lock_guard lock(mutex_);
  if (!failure_.empty()) throw std::runtime_error(failure_);
  commit_pending();
}

void RecordingFile::commit_pending() {
  if (std::exchange(pending_, false)) sqlite::run(database_.get(), "COMMIT");
}

// Real time on purpose: what is lost when a process is killed is lost in real time.
void RecordingFile::keep_committing() {
  // By this name robios knows that it is none of the program's own threads.
  pthread_setname_np(pthread_self(), "eb:recording");
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, kRealCommitPeriod, [this] { return ending_; })) {
    try {
      commit_pending();
    } catch (const std::runtime_error& error) {
      failure_ = error.what();
      return;
    }
  }
}

sqlite::Database open_recording(const std::filesystem::path& path) {
  sqlite::Database database = sqlite::open_checked(path);
  sqlite::check_tables(database.get(), kTables, kNeeded, sqlite::Others::Refused);
  const auto row = sqlite::prepare(database.get(), "SELECT value FROM meta WHERE key='version'");
  if (!sqlite::step(row)) throw std::runtime_error("it has no version, expected 1");
  if (const std::string found = sqlite::text(row, 0); found != "1") {
    throw std::runtime_error("its version is " + in_quotes(found, 40) + ", expected 1");
  }
  return database;
}

Time recorded_time(std::int64_t ns, Time least) {
  if (Time(ns) < least || Time(ns) > kLongestRecording) {
    throw std::runtime_error("found the time " + std::to_string(ns) + " ns, expected " +
                             std::to_string(least.count()) + " ... " +
                             std::to_string(kLongestRecording.count()));
  }
  return Time(ns);
}

}  // namespace eyebridge::camera
