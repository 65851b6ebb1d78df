#include "radio_messages.hpp"

#include "session.hpp"

namespace eyebridge::robios {
namespace {

constexpr Time kRadioPoll = std::chrono::milliseconds(10);
constexpr Time kLongWait = std::chrono::hours(1);

/// In virtual time an hour passes in no time: a program that is alone would wait for ever.
void check_hope(hal::Radio& radio, Session& session, Time since) {
  if (!session.clock().is_virtual() || session.clock().now() - since < kLongWait) return;
  const auto robots = radio.robots();
  if (robots && robots->size() > 1) return;
  session.abort_run({Errc::Unsupported,
                     "waits for a radio message that can never come: no other robot of this world "
                     "has its radio on; other programs are reached by --radio udp:…"});
}

}  // namespace

Result<hal::Radio*> radio_of(Session& session) {
  hal::Radio* const radio = session.backend().radio();
  if (radio == nullptr) {
    const int id = session.backend().robot_id();
    return fail(Errc::NoDevice, id > hal::Radio::kLastId
                                    ? "robot " + std::to_string(id) +
                                          " has no radio: only robots 1 to 255 can be reached"
                                    : std::string("this robot has no radio"));
  }
  return radio;
}

Result<hal::RadioMessage> wait_for_message(Session& session, hal::Radio& radio,
                                           std::string_view call,
                                           const std::function<void(Time)>& wait_until) {
  const Time since = session.clock().now();
  while (session.may_call(call)) {
    auto message = session.messages().take(radio);
    if (!message) return tl::unexpected(message.error());
    if (*message) return std::move(**message);
    check_hope(radio, session, since);
    wait_until(session.clock().now() + kRadioPoll);
  }
  return fail(Errc::Timeout, "the run has ended");
}

}  // namespace eyebridge::robios
