#include <algorithm>
#include <mutex>
#include <string>

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "call.hpp"
#include "eyebot.h"
#include "eyebridge/base/unique_fd.hpp"
#include "sample.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

constexpr double kBeepHertz = 1000;
constexpr double kBeepSeconds = 0.1;
// What the loudspeaker of the HAL can do at most.
constexpr int kHighestTone = 20000;
constexpr double kLongestTone = 60;
constexpr int kMicrophoneShift = 2;  // 12 bits to 10

struct PlayingSample {
  std::mutex mutex;
  UniqueFd file;  ///< What the player reads.
};

Result<hal::Sound*> sound_of(Session& session) {
  hal::Sound* const sound = session.backend().sound();
  if (sound == nullptr) return fail(Errc::NoDevice, "this robot has no loudspeaker");
  return sound;
}

/// The sound as a file without a name, as others see it.
Result<std::string> as_file(Session& session, const robios::classic::Sample& sample) {
  UniqueFd file(::memfd_create("eyebridge-sample", MFD_CLOEXEC));
  if (!file.valid() || ::write(file.get(), sample.wav.data(), sample.wav.size()) !=
                           static_cast<ssize_t>(sample.wav.size())) {
    return fail(Errc::Unsupported, "there is no memory for the sample");
  }
  auto& playing = session.own<PlayingSample>();
  const std::lock_guard lock(playing.mutex);
  playing.file = std::move(file);
  return fmt::format("/proc/{}/fd/{}", ::getpid(), playing.file.get());
}

/// What nothing is heard of has ended.
int is_silent(const robios::Call& name) {
  return call(name, 1, [](Session& session) -> Result<int> {
    return sound_of(session).and_then([](hal::Sound* sound) {
      return sound->is_playing().map([](bool playing) { return playing ? 0 : 1; });
    });
  });
}

int play_tone(const robios::Call& name, double hertz, double seconds) {
  return doing(name, 1, [&](Session& session) {
    return sound_of(session).and_then(
        [&](hal::Sound* sound) { return sound->tone(hertz, seconds); });
  });
}

}  // namespace

int AUPlaySample(void* sample, ...) {
  return call("AUPlaySample", 0, [&](Session& session) -> Result<int> {
    if (sample == nullptr) return robios::null_pointer();
    const auto* const bytes = static_cast<const std::uint8_t*>(sample);
    return robios::classic::sample_size({bytes, robios::classic::kSampleHead})
        .and_then([&](std::size_t size) {
          return robios::classic::read_sample({bytes, size});
        })
        .and_then([&](const robios::classic::Sample& read) -> Result<int> {
          const Result<hal::Sound*> sound = sound_of(session);
          if (!sound) return tl::unexpected(sound.error());
          return as_file(session, read).and_then([&](const std::string& path) {
            return (*sound)->play(path).map([&] { return read.frequency; });
          });
        });
  });
}

int AUTone(int freq, int msec) {
  if (freq < 65 || freq > 21000 || msec < 1 || msec > 65535) {
    return doing("AUTone", 1, [&](Session&) -> Result<void> {
      return fail(Errc::OutOfRange,
                  fmt::format("{} Hz for {} ms, expected 65 … 21000 and 1 … 65535", freq, msec));
    });
  }
  return play_tone("AUTone", std::min(freq, kHighestTone), std::min(msec / 1000.0, kLongestTone));
}

int AUBeep(void) { return play_tone("AUBeep", kBeepHertz, kBeepSeconds); }

int AUCheckSample(void) { return is_silent("AUCheckSample"); }
int AUCheckTone(void) { return is_silent("AUCheckTone"); }

int AURecordSample(void*, long, long) {
  return call("AURecordSample", 0, [](Session&) -> Result<int> {
    return fail(Errc::Unsupported, "there is no microphone that is fast enough to record");
  });
}

int AUCheckRecord(void) {
  return call("AUCheckRecord", 1, [](Session&) -> Result<int> { return 1; });
}

int AUCaptureMic(void) {
  return call("AUCaptureMic", -1, [](Session& session) -> Result<int> {
    hal::AnalogInputs* const inputs = session.backend().analog();
    if (inputs == nullptr) return fail(Errc::NoDevice, "this robot has no microphone");
    return inputs->read(hal::AnalogInputs::kMicrophone).map([](int value) {
      return value >> kMicrophoneShift;
    });
  });
}
