#include <mutex>

#include "host/host_sound.hpp"
#include "host/sound_file.hpp"

namespace eyebridge::hal {
namespace {

class SilentSound final : public Sound {
 public:
  explicit SilentSound(Clock& clock) : clock_(clock) {}

  Result<void> tone(double frequency, double duration) override {
    return check_tone(frequency, duration).map([&] { lasts(duration); });
  }
  Result<void> play(const std::string& path) override {
    return read_sound_file(path).map([&](const SoundFacts& facts) { lasts(facts.length); });
  }
  Result<bool> is_playing() override {
    const std::lock_guard lock(mutex_);
    return clock_.now() < end_;
  }

 private:
  void lasts(double seconds) {
    const std::lock_guard lock(mutex_);
    end_ = clock_.now() + from_seconds(seconds);
  }

  Clock& clock_;
  std::mutex mutex_;
  Time end_{0};
};

}  // namespace

std::unique_ptr<Sound> make_silent_sound(Clock& clock) {
  return std::make_unique<SilentSound>(clock);
}

}  // namespace eyebridge::hal
