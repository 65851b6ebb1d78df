// Recordings that a stranger made: none of their SQL runs, and none takes time or memory that its
// size does not let expect.
#include "eyebridge/camera/recording/checked_file.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"
#include "eyebridge/camera/recording/recording_file.hpp"
#include "frame_files.hpp"

namespace eyebridge::camera {
namespace {

using testing::FrameFiles;
using ::testing::HasSubstr;

class Strangers : public ::testing::Test {
 protected:
  void sql(const std::string& text) const {
    sqlite3* opened = nullptr;
    ASSERT_EQ(sqlite3_open(file_.c_str(), &opened), SQLITE_OK);
    const sqlite::Database database(opened);
    EXPECT_EQ(sqlite3_exec(opened, text.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(opened);
  }
  /// All of the recording that EyeBridge reads.
  [[nodiscard]] std::string complaint() const {
    try {
      const FrameReader frames(file_);
      const sqlite::Database database = open_recording(file_);
      sqlite::Rows rows(database.get(), "SELECT seq,what FROM exchange ORDER BY seq");
      while (rows.next()) {
      }
      return "";
    } catch (const std::exception& error) {
      return error.what();
    }
  }
  void make() { const RecordingFile file(file_, {}); }

  FrameFiles files_;
  std::string file_ = files_.path("strange.ebrec");
};

TEST_F(Strangers, TablesAreThoseOfARecordingOrNothingIsRead) {
  // Endless, if it were asked.
  const std::string endless = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM n) ";
  for (const std::string& attack : std::vector<std::string>{
           "DROP TABLE exchange; CREATE VIEW exchange AS " + endless +
               "SELECT i seq,0 t,'' device,1 id,'' call,'' request,'' reply,0 error,'' what FROM n",
           "DROP TABLE meta; CREATE VIEW meta AS " + endless + "SELECT i key, '1' value FROM n",
           "DROP TABLE exchange; CREATE TABLE exchange(seq INTEGER PRIMARY KEY, t, device, id, "
           "call, "
           "request, reply, error, what TEXT AS (hex(zeroblob(500000000))))",
           "CREATE TABLE more(x)", "CREATE INDEX fast ON exchange(t)",
           "CREATE TRIGGER on_it INSERT ON meta BEGIN SELECT 1; END", "DROP TABLE device"}) {
    std::filesystem::remove(file_);
    make();
    ASSERT_EQ(complaint(), "");
    sql(attack);
    EXPECT_THAT(complaint(), HasSubstr("that it should ")) << attack;
  }
}

TEST_F(Strangers, ATableThatLeadsInCirclesEnds) {
  make();
  sql("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM n WHERE i<2000) INSERT INTO "
      "exchange SELECT i,0,'psd',1,'read','','1',NULL,hex(zeroblob(20)) FROM n");
  ASSERT_EQ(complaint(), "");
  int root = 0;
  int page_size = 0;
  {
    sqlite3* opened = nullptr;
    ASSERT_EQ(sqlite3_open(file_.c_str(), &opened), SQLITE_OK);
    const sqlite::Database database(opened);
    const auto row =
        sqlite::prepare(opened, "SELECT rootpage FROM sqlite_schema WHERE name='exchange'");
    ASSERT_TRUE(sqlite::step(row));
    root = static_cast<int>(sqlite::integer(row, 0));
    const auto size = sqlite::prepare(opened, "PRAGMA page_size");
    ASSERT_TRUE(sqlite::step(size));
    page_size = static_cast<int>(sqlite::integer(size, 0));
  }
  // https://www.sqlite.org/fileformat2.html, 1.6: an interior page; each cell begins with the
  // number of a page.
  std::fstream stream(file_, std::ios::binary | std::ios::in | std::ios::out);
  std::string page(static_cast<std::size_t>(page_size), '\0');
  stream.seekg(std::streamoff{root - 1} * page_size);
  ASSERT_TRUE(stream.read(page.data(), page_size));
  ASSERT_EQ(page[0], 5) << "an interior page of a table";
  const auto two = [&](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(page[at])) << 8U |
           static_cast<unsigned char>(page[at + 1]);
  };
  const std::size_t cells = two(3);
  ASSERT_GT(cells, 2U);
  const std::string first = page.substr(two(12), 4);
  for (std::size_t i = 0; i < cells; ++i) page.replace(two(12 + 2 * i), 4, first);
  stream.seekp(std::streamoff{root - 1} * page_size);
  ASSERT_TRUE(stream.write(page.data(), page_size).flush());
  EXPECT_EQ(complaint(), "its rows are out of order");
}

TEST_F(Strangers, FramesSpeakOfNoMoreThanTheFileHolds) {
  make();
  // SQLite keeps a run of zeros, whose length it tells, as what it is until it is written.
  sql("INSERT INTO frame VALUES(1,0,0,0,4,4,'rgb24','lossless',zeroblob(100))");
  ASSERT_EQ(complaint(), "");
  const sqlite::Database database = open_recording(file_);
  sqlite::Rows rows(database.get(), "SELECT seq,codec FROM frame ORDER BY seq");
  ASSERT_TRUE(rows.next());
  EXPECT_THROW(rows.count(std::int64_t{1} << 40U), std::runtime_error);
}

TEST_F(Strangers, TimesAreThoseOfARun) {
  for (const char* const time : {"9223372036854775807", "-1", "31622400000000001"}) {
    std::filesystem::remove(file_);
    make();
    sql(std::string("INSERT INTO frame VALUES(1,") + time + ",0,0,4,4,'rgb24','lossless','')");
    EXPECT_THAT(complaint(), HasSubstr(std::string("found the time ") + time)) << time;
  }
  std::filesystem::remove(file_);
  make();
  sql("INSERT INTO frame VALUES(1,0,-9223372036854775807-1,0,4,4,'rgb24','lossless','')");
  EXPECT_THAT(complaint(), HasSubstr("found the time -9223372036854775808"));
}

TEST_F(Strangers, OnlyRegularFilesAreOpened) {
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  EXPECT_THAT(complaint(), HasSubstr("it is no regular file"));
  std::filesystem::remove(file_);
  std::filesystem::create_symlink("/dev/zero", file_);
  EXPECT_THAT(complaint(), HasSubstr("it is no regular file"));
}

TEST_F(Strangers, NothingIsWrittenBesideAFileThatIsRead) {
  make();
  sql("PRAGMA journal_mode=WAL");  // as a program leaves it that was killed, without its -wal
  for (const char* end : {"-wal", "-shm"}) std::filesystem::remove(file_ + end);
  ASSERT_EQ(complaint(), "");
  EXPECT_FALSE(std::filesystem::exists(file_ + "-shm"));
  EXPECT_FALSE(std::filesystem::exists(file_ + "-wal"));
}

}  // namespace
}  // namespace eyebridge::camera
