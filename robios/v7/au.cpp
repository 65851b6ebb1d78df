#include "eyebot.h"
#include "guarded.hpp"

namespace {

using namespace eyebridge;

constexpr double kBeep = 1000;       // hertz
constexpr double kBeepLength = 0.1;  // seconds

template <class Body>
int with_sound(const robios::Call& call, int failure, Body&& body) {
  return robios::guarded(call, failure, [&](robios::Session& session) -> Result<int> {
    hal::Sound* sound = session.backend().sound();
    if (sound == nullptr) return fail(Errc::NoDevice, "this robot has no loudspeaker");
    return body(*sound);
  });
}

}  // namespace

int AUBeep(void) {
  return with_sound("AUBeep", 1, [](hal::Sound& sound) -> Result<int> {
    return sound.tone(kBeep, kBeepLength).map([] { return 0; });
  });
}

int AUPlay(const char* filename) {
  return with_sound("AUPlay", 1, [&](hal::Sound& sound) -> Result<int> {
    if (filename == nullptr) return robios::null_pointer();
    return sound.play(filename).map([] { return 0; });
  });
}

int AUDone(void) {
  return with_sound("AUDone", 1, [](hal::Sound& sound) -> Result<int> {
    return sound.is_playing().map([](bool playing) { return playing ? 0 : 1; });
  });
}
