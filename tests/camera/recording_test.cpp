// Frames in recordings: packed and unpacked, damaged, and what is left when a program is killed.

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "frame_files.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

/// Pixels that differ, and rows with padding.
Frame odd_frame(PixelFormat format) {
  Frame frame = make_frame(5, 3, format);
  frame.stride += 3;
  frame.bytes.assign(static_cast<std::size_t>(frame.stride) * 3, 0xEE);
  for (int y = 0; y < 3; ++y) {
    for (std::size_t i = 0; i < frame.row(y).size(); ++i) {
      frame.bytes[static_cast<std::size_t>(y * frame.stride) + i] =
          static_cast<std::uint8_t>(i * 37 + static_cast<std::size_t>(y) * 101);
    }
  }
  return frame;
}

void expect_same_pixels(const Frame& a, const Frame& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  ASSERT_EQ(a.format, b.format);
  for (int y = 0; y < a.height; ++y) EXPECT_TRUE(std::ranges::equal(a.row(y), b.row(y))) << y;
}

TEST(FrameCodec, LosslessGivesEveryFormatBackAsItWas) {
  for (const auto format : {PixelFormat::Rgb24, PixelFormat::Bgra32, PixelFormat::Grey8}) {
    const Frame frame = odd_frame(format);
    const auto data = encode_frame(frame, FrameCodec::Lossless);
    expect_same_pixels(decode_frame(data, FrameCodec::Lossless, {5, 3}, format), frame);
  }
}

TEST(FrameCodec, MjpegKeepsColoursAndGreys) {
  for (const auto format : {PixelFormat::Rgb24, PixelFormat::Grey8}) {
    Frame frame = make_frame(32, 16, format);
    for (std::size_t i = 0; i < frame.bytes.size(); ++i) {
      frame.bytes[i] = static_cast<std::uint8_t>(60 + 40 * (i % 3));
    }
    if (format == PixelFormat::Grey8) std::ranges::fill(frame.bytes, std::uint8_t{77});
    const auto data = encode_frame(frame, FrameCodec::Mjpeg);
    const Frame back = decode_frame(data, FrameCodec::Mjpeg, {32, 16}, format);
    ASSERT_EQ(back.bytes.size(), frame.bytes.size());
    for (std::size_t i = 0; i < frame.bytes.size(); ++i) {
      ASSERT_NEAR(back.bytes[i], frame.bytes[i], 3) << i;
    }
  }
}

TEST(FrameCodec, NamesAreReadAsTheyAreWritten) {
  for (const auto codec : {FrameCodec::Lossless, FrameCodec::Mjpeg}) {
    EXPECT_EQ(find_frame_codec(name_of(codec)), codec);
  }
  for (const auto format : {PixelFormat::Rgb24, PixelFormat::Bgra32, PixelFormat::Grey8}) {
    EXPECT_EQ(find_pixel_format(name_of(format)), format);
  }
  EXPECT_FALSE(find_frame_codec("none"));
}

std::string damage(std::span<const std::uint8_t> data, FrameCodec codec, Size size) {
  try {
    decode_frame(data, codec, size, PixelFormat::Rgb24);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(FrameCodec, DamagedPixelsAreRefused) {
  const Frame frame = numbered(3, 20, 10);
  auto data = encode_frame(frame, FrameCodec::Lossless);
  EXPECT_THAT(damage(data, FrameCodec::Lossless, {20, 9}), HasSubstr("more pixels"));
  EXPECT_THAT(damage(data, FrameCodec::Lossless, {20, 11}), HasSubstr("fewer pixels"));
  // 58 TB: no memory is taken for what cannot be there.
  EXPECT_THAT(damage(data, FrameCodec::Lossless, {4'400'000, 4'400'000}),
              HasSubstr("fewer pixels"));
  EXPECT_THAT(damage({}, FrameCodec::Lossless, {20, 10}), HasSubstr("fewer pixels"));
  EXPECT_THAT(damage(std::span(data).first(data.size() / 2), FrameCodec::Lossless, {20, 10}),
              HasSubstr("damaged"));
  data[data.size() - 1] ^= 1;  // the checksum
  EXPECT_THAT(damage(data, FrameCodec::Lossless, {20, 10}), HasSubstr("damaged"));
  const auto jpeg = encode_frame(frame, FrameCodec::Mjpeg);
  EXPECT_THAT(damage(jpeg, FrameCodec::Mjpeg, {40, 10}), HasSubstr("20 x 10 pixels, expected 40"));
  EXPECT_NE(damage(std::span(jpeg).first(jpeg.size() / 2), FrameCodec::Mjpeg, {20, 10}), "");
}

class Recordings : public ::testing::Test {
 protected:
  void run_sql(const char* sql) const {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(file_.c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sql;
    sqlite3_close(database);
  }
  [[nodiscard]] std::string complaint() const {
    try {
      const FrameReader reader(file_);
      return "";
    } catch (const ConfigError& error) {
      EXPECT_EQ(error.where().file, file_);
      return error.text();
    }
  }

  FrameFiles files_;
  std::string file_ = files_.path("frames.ebrec");
};

TEST_F(Recordings, FramesAreReadAsTheyWereWritten) {
  {
    RecordingFile file(file_, {{"program", "test"}});
    FrameWriter writer(file, FrameCodec::Lossless);
    for (const int i : {1, 2, 5}) {
      writer.add(numbered(i, 8 + i, 6), numbered(i).time + std::chrono::milliseconds(4));
    }
    Frame grey = to_grey8(numbered(60));
    writer.add(grey, std::chrono::seconds(3));
  }
  FrameReader reader(file_);
  ASSERT_EQ(reader.frames().size(), 4U);
  const RecordedFrame& last = reader.frames()[2];
  EXPECT_EQ(last.given, numbered(5).time + std::chrono::milliseconds(4));
  EXPECT_EQ(last.size, (Size{13, 6}));
  const Frame frame = reader.read(2).value();
  EXPECT_EQ(frame.time, numbered(5).time);
  EXPECT_EQ(frame.sequence, 5U);
  EXPECT_EQ(number_of(frame), 5);
  EXPECT_EQ(reader.read(3).value().format, PixelFormat::Grey8);
}

TEST_F(Recordings, ADamagedFrameIsAnErrorAndTheOthersAreThere) {
  static_cast<void>(files_.recording(3));
  run_sql("UPDATE frame SET data=x'0102' WHERE seq=2");
  FrameReader reader(file_);
  EXPECT_EQ(number_of(*reader.read(0)), 0);
  const Result<Frame> damaged = reader.read(1);
  ASSERT_FALSE(damaged);
  EXPECT_EQ(damaged.error().code, Errc::Corrupt);
  EXPECT_EQ(damaged.error().what, file_ + ": frame 2: its pixels are damaged");
  EXPECT_EQ(number_of(*reader.read(2)), 2);
}

TEST_F(Recordings, RowsThatCannotBeAreRefused) {
  for (const auto& [change, expected] : {
           std::pair{"width=0", "frame 2: 0 x 6 pixels, expected 1 ... 4096 each way"},
           {"height=100000", "frame 2: 8 x 100000 pixels"},
           {"codec='gif'", "frame 2: unknown codec 'gif'"},
           {"format='yuv'", "frame 2: unknown format 'yuv'"},
           {"t=-1", "frame 2: found the time -1 ns, expected 0"},
           {"t=9000000000", "frame 3: earlier than the one before it"},
       }) {
    static_cast<void>(files_.recording(3));
    run_sql((std::string("UPDATE frame SET ") + change + " WHERE seq=2").c_str());
    EXPECT_THAT(complaint(), HasSubstr(expected)) << change;
  }
}

TEST_F(Recordings, OlderOnesHaveNoFrames) {
  static_cast<void>(files_.recording(3));
  run_sql("DROP TABLE frame");
  EXPECT_EQ(complaint(), "");
  EXPECT_TRUE(FrameReader(file_).frames().empty());
}

TEST_F(Recordings, FilesThatAreNoneAreRefused) {
  EXPECT_THAT(complaint(), HasSubstr("no such file: expected a recording"));
  std::ofstream(file_) << "text";
  EXPECT_THAT(complaint(), HasSubstr("expected a recording (.ebrec)"));
}

TEST_F(Recordings, ThatCannotBeWrittenAreRefused) {
  try {
    const RecordingFile file("/no/such/folder/x.ebrec", {});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.text(), HasSubstr("cannot write /no/such/folder/x.ebrec"));
  }
}

/// Why a recording cannot be made at `path`; "" when it can.
std::string refusal(const std::string& path) {
  try {
    const RecordingFile file(path, {});
    return "";
  } catch (const ConfigError& error) {
    return error.text();
  }
}

TEST_F(Recordings, ReplaceNothingButRecordings) {
  const std::string text = "int main() { return 0; }";
  std::ofstream(file_) << text;
  EXPECT_THAT(refusal(file_), HasSubstr("it is no recording; expected a new name"));
  std::ifstream there(file_);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(there), {}), text);

  std::filesystem::remove(file_);
  run_sql("CREATE TABLE mine(x); INSERT INTO mine VALUES(1)");
  EXPECT_THAT(refusal(file_), HasSubstr("no recording"));
  EXPECT_THAT(complaint(), HasSubstr("expected a recording"));
  run_sql("SELECT x FROM mine");

  EXPECT_THAT(refusal(files_.path("")), HasSubstr("cannot write"));
  const std::string pipe = files_.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal(pipe), HasSubstr("no regular file"));
}

TEST_F(Recordings, TakeThePlaceOfEarlierOnes) {
  std::ofstream(file_).close();
  EXPECT_EQ(refusal(file_), "") << "an empty file is in nobody's way";
  const FrameReader earlier(file_);
  EXPECT_EQ(refusal(file_), "");
  // One whose program was killed while it recorded.
  const pid_t killed = fork();
  if (killed == 0) {
    const RecordingFile file(file_, {});
    raise(SIGKILL);
  }
  waitpid(killed, nullptr, 0);
  EXPECT_EQ(refusal(file_), "");
}

TEST_F(Recordings, AreWrittenByOneAtATime) {
  const RecordingFile file(file_, {});
  EXPECT_THAT(refusal(file_), HasSubstr("another run records into it"));
}

TEST_F(Recordings, ThoseWhoLookAtOneThatBeginsDoNotEndIt) {
  std::atomic<int> present = 0;
  const auto name = [&](int number) { return file_ + std::to_string(number); };
  std::thread looks([&] {
    while (present < 50) {
      try {
        const FrameReader reader(name(present));
      } catch (const ConfigError&) {  // not there yet, or not whole
      }
    }
  });
  EXPECT_NO_THROW({
    while (present < 50) {
      const RecordingFile file(name(present), {});
      ++present;
    }
  });
  present = 50;
  looks.join();
}

// The robot's clock stands still, as when a program thinks for long: real time counts, too.
TEST_F(Recordings, AProgramThatStoppedWritingLeavesAllWhenItIsKilled) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      RecordingFile file(file_, {});
      FrameWriter writer(file, FrameCodec::Lossless);
      for (int i = 0; i < 5; ++i) writer.add(numbered(i), Time{0});
      while (true) pause();
    } catch (const std::exception& error) {  // not into the tests of this copy of them
      std::fputs(error.what(), stderr);
      _exit(1);
    }
  }
  const auto frames_seen = [&]() -> std::size_t {
    try {
      return FrameReader(file_).frames().size();
    } catch (const ConfigError&) {  // not made yet
      return 0;
    }
  };
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (frames_seen() < 5 && std::chrono::steady_clock::now() < give_up) {
  }
  kill(child, SIGKILL);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  FrameReader reader(file_);
  ASSERT_EQ(reader.frames().size(), 5U);
  EXPECT_EQ(number_of(*reader.read(4)), 4);
}

}  // namespace
}  // namespace eyebridge::camera::testing
