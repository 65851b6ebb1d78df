// Sounds: how long files are, silence that takes time, players.
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "clock/lockstep_clock.hpp"
#include "host/host_sound.hpp"
#include "host/sound_length.hpp"
#include "host/tone.hpp"
#include "run_program.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Bytes = std::vector<std::uint8_t>;

/// `count` frames of `size` bytes each, which `second` and `third` of a header's bytes describe.
Bytes mp3(int count, std::size_t size, std::uint8_t second, std::uint8_t third) {
  Bytes bytes;
  for (int i = 0; i < count; ++i) {
    const std::size_t start = bytes.size();
    bytes.resize(start + size);
    bytes[start] = 0xFF;
    bytes[start + 1] = second;
    bytes[start + 2] = third;
  }
  return bytes;
}

/// Of MPEG 1, layer III, 128 kbit/s, 44100 Hz: 417 bytes, 1152 samples each.
Bytes mp3(int count) { return mp3(count, 417, 0xFB, 0x90); }

std::string as_text(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

TEST(SoundLength, OfAToneIsTheTonesOwn) {
  const auto facts = read_sound(make_tone(440, 0.25));
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->format, SoundFormat::Wav);
  EXPECT_DOUBLE_EQ(facts->length, 0.25);
}

TEST(SoundLength, OfAWavSkipsOtherChunks) {
  Bytes wav = make_tone(440, 0.5);
  const std::string extra("LIST\x03\0\0\0abc\0", 12);  // an odd length is padded
  wav.insert(wav.begin() + 36, extra.begin(), extra.end());
  EXPECT_DOUBLE_EQ(read_sound(wav).value().length, 0.5);
}

TEST(SoundLength, OfAWavThatIsCutIsWhatIsThere) {
  Bytes wav = make_tone(440, 1.0);
  wav.resize(44 + 44100);
  EXPECT_DOUBLE_EQ(read_sound(wav).value().length, 0.5);
}

TEST(SoundLength, OfAnMp3IsTheSumOfItsFrames) {
  const auto facts = read_sound(mp3(100));
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->format, SoundFormat::Mp3);
  EXPECT_NEAR(facts->length, 100 * 1152 / 44100.0, 1e-9);
}

TEST(SoundLength, OfAnMp3OfLowerRatesIsTheSumOfItsShorterFrames) {
  // 64 kbit/s; MPEG 2 has half the sampling rates of MPEG 1, MPEG 2.5 a quarter; both have half its
  // samples in a frame.
  EXPECT_NEAR(read_sound(mp3(100, 208, 0xF3, 0x80)).value().length, 100 * 576 / 22050.0, 1e-9);
  EXPECT_NEAR(read_sound(mp3(100, 417, 0xE3, 0x80)).value().length, 100 * 576 / 11025.0, 1e-9);
  EXPECT_NEAR(read_sound(mp3(100, 192, 0xF3, 0x84)).value().length, 100 * 576 / 24000.0, 1e-9);
  EXPECT_NEAR(read_sound(mp3(100, 576, 0xE3, 0x88)).value().length, 100 * 576 / 8000.0, 1e-9);
}

TEST(SoundLength, OfAnMp3CountsTheByteThatFillsAFrameUp) {
  EXPECT_NEAR(read_sound(mp3(100, 418, 0xFB, 0x92)).value().length, 100 * 1152 / 44100.0, 1e-9);
}

TEST(SoundLength, OfAnMp3LeavesOutItsTagAndDamage) {
  Bytes bytes = {'I', 'D', '3', 4, 0, 0, 0, 0, 1, 2};  // 130 bytes follow
  bytes.resize(10 + 130, 0xFF);
  const Bytes first = mp3(3);
  bytes.insert(bytes.end(), first.begin(), first.end());
  bytes.insert(bytes.end(), {1, 2, 3, 0xFF, 0xFB, 0x90, 5});
  const Bytes second = mp3(2);
  bytes.insert(bytes.end(), second.begin(), second.end());
  EXPECT_NEAR(read_sound(bytes).value().length, 5 * 1152 / 44100.0, 1e-9);
}

TEST(SoundLength, OfAnythingElseIsUnknown) {
  const std::string text = "RIFF\4\0\0\0WAVE";
  for (const Bytes& bytes :
       {Bytes{}, Bytes{1, 2, 3}, Bytes(1000, 0xFF), Bytes(text.begin(), text.end())}) {
    EXPECT_EQ(read_sound(bytes).error().code, Errc::Unsupported);
  }
}

TEST(SilentSound, TakesItsLengthOnTheRobotsClock) {
  LockstepClock clock(10ms, [] {});
  const auto sound = make_silent_sound(clock);
  EXPECT_FALSE(sound->is_playing().value());
  ASSERT_TRUE(sound->tone(1000, 0.1));
  clock.spend(99ms);
  EXPECT_TRUE(sound->is_playing().value());
  clock.spend(1ms);
  EXPECT_FALSE(sound->is_playing().value());

  const testing::ScratchFolder folder;
  ASSERT_TRUE(sound->play(folder.write("a.mp3", as_text(mp3(50)))));
  clock.spend(1306ms);
  EXPECT_TRUE(sound->is_playing().value());
  clock.spend(1ms);
  EXPECT_FALSE(sound->is_playing().value());
}

TEST(SilentSound, RefusesWhatIsNoSound) {
  LockstepClock clock(10ms, [] {});
  const auto sound = make_silent_sound(clock);
  const testing::ScratchFolder folder;
  EXPECT_EQ(sound->play(folder.path() + "/none.wav").error().code, Errc::OutOfRange);
  EXPECT_EQ(sound->play(folder.path()).error().code, Errc::OutOfRange);
  const auto text = sound->play(folder.write("a.txt", "no sound"));
  EXPECT_EQ(text.error().code, Errc::Unsupported);
  EXPECT_THAT(text.error().what, HasSubstr("a.txt: no sound that is known, expected WAV or MP3"));
  EXPECT_EQ(sound->tone(10, 1).error().code, Errc::OutOfRange);
  EXPECT_EQ(sound->tone(440, 0).error().code, Errc::OutOfRange);
  EXPECT_EQ(sound->tone(440, 61).error().code, Errc::OutOfRange);
}

/// A folder with a player that copies what it is given beside itself.
class PlayedSoundTest : public ::testing::Test {
 protected:
  void put(const std::string& name, const std::string& script) {
    const std::string path = folder_.write(name, "#!/bin/sh\n" + script);
    ASSERT_EQ(::chmod(path.c_str(), 0755), 0);
  }
  static void wait_for_end(Sound& sound) {
    while (sound.is_playing().value()) std::this_thread::yield();
  }
  std::string copy() { return testing::file_text(folder_.path() + "/copy"); }

  testing::ScratchFolder folder_;
  /// The test's own folder first: no real player is ever started.
  const std::string path_ = folder_.path();
};

TEST_F(PlayedSoundTest, HandsAToneToThePlayer) {
  put("aplay", "/bin/cat \"$2\" > " + folder_.path() + "/copy\n");
  const auto sound = make_played_sound("auto", path_);
  ASSERT_TRUE(sound->tone(1000, 0.1));
  wait_for_end(*sound);
  EXPECT_EQ(copy(), as_text(make_tone(1000, 0.1)));
}

TEST_F(PlayedSoundTest, ChoosesAPlayerThatKnowsTheFormat) {
  put("aplay", "echo wav $1 $2 > " + folder_.path() + "/copy\n");
  put("mpg123", "echo mp3 $1 $2 > " + folder_.path() + "/copy\n");
  const auto sound = make_played_sound("auto", path_);
  const std::string file = folder_.write("a.sound", as_text(mp3(3)));
  ASSERT_TRUE(sound->play(file));
  wait_for_end(*sound);
  EXPECT_EQ(copy(), "mp3 -q " + file + "\n");
}

TEST_F(PlayedSoundTest, UsesTheCommandOfTheUserForAnyFile) {
  put("my", "echo $1 $2 $3 > " + folder_.path() + "/copy\n");
  const auto sound = make_played_sound("my --loud  --once", path_);
  const std::string file = folder_.write("a.ogg", "OggS");
  ASSERT_TRUE(sound->play(file));
  wait_for_end(*sound);
  EXPECT_EQ(copy(), "--loud --once " + file + "\n");
  EXPECT_EQ(sound->play(folder_.path() + "/none").error().code, Errc::OutOfRange);
}

TEST_F(PlayedSoundTest, SaysWhatToDoWithoutAPlayer) {
  const auto none = make_played_sound("auto", path_)->tone(1000, 0.1);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, Errc::Unsupported);
  EXPECT_THAT(none.error().what, StartsWith("sound: found no player, expected one of pw-play"));
  const auto bad = make_played_sound("nothing-like-that", path_)->tone(1000, 0.1);
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().what, HasSubstr("'nothing-like-that'"));
}

TEST_F(PlayedSoundTest, APlayerThatTheSystemCannotStartIsNone) {
  const std::string path = folder_.write("my", "#!/no/such/interpreter\n");
  ASSERT_EQ(::chmod(path.c_str(), 0755), 0);
  const auto sound = make_played_sound("my", path_);
  const auto played = sound->tone(1000, 0.1);
  ASSERT_FALSE(played);
  EXPECT_EQ(played.error().code, Errc::Unsupported);
  EXPECT_FALSE(sound->is_playing().value());
}

}  // namespace
}  // namespace eyebridge::hal
