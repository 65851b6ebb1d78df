#include "host/sound_file.hpp"

#include <cerrno>
#include <filesystem>
#include <vector>

#include "eyebridge/base/read_file.hpp"
#include "eyebridge/hal/sound_file.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::uintmax_t kMostBytes = 256U << 20U;

tl::unexpected<Error> unreadable(const std::string& path, const std::string& why) {
  return fail(Errc::OutOfRange, "sound: " + path + ": " + why);
}

}  // namespace

Result<SoundFacts> read_sound_file(const std::string& path) {
  const auto bytes = read_file(path, kMostBytes);
  if (!bytes) return unreadable(path, bytes.error().what);
  auto facts = read_sound({reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()});
  if (!facts) return fail(facts.error().code, "sound: " + path + ": " + facts.error().what);
  return facts;
}

Result<double> sound_length(const std::string& path) {
  return read_sound_file(path).map([](const SoundFacts& facts) { return facts.length; });
}

Result<void> check_tone(double frequency, double duration) {
  if (frequency >= 20 && frequency <= 20000 && duration > 0 && duration <= 60) return {};
  return fail(Errc::OutOfRange, "sound: got " + std::to_string(frequency) + " Hz for " +
                                    std::to_string(duration) +
                                    " s, expected 20 … 20000 Hz for at most 60 s");
}

}  // namespace eyebridge::hal
