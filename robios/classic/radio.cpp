#include <algorithm>
#include <cstring>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "call.hpp"
#include "eyebot.h"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

constexpr int kHost = 0;
// In virtual time an hour passes in no time: who is alone would wait for ever.
constexpr Time kLongWait = std::chrono::hours(1);

std::mutex radio_mutex;
std::deque<hal::RadioMessage> received;
RadioIOParameters radio_parameters{SERIAL2, SER9600, 0, 0, 0, 0};

Result<hal::Radio*> radio_of(Session& session) {
  hal::Radio* const radio = session.backend().radio();
  if (radio == nullptr) return fail(Errc::Unsupported, "this robot has no radio");
  return radio;
}

/// Takes what has come. Lock radio_mutex.
Result<void> collect(hal::Radio& radio) {
  for (;;) {
    auto message = radio.receive();
    if (!message) return tl::unexpected(message.error());
    if (!*message) return {};
    received.push_back(std::move(**message));
  }
}

/// Ends a program that waits in virtual time for a message that nobody can send.
void check_somebody(hal::Radio& radio, Session& session, Time since) {
  if (!session.clock().is_virtual() || session.clock().now() - since < kLongWait) return;
  const auto robots = radio.robots();
  if (robots && robots->size() > 1) return;
  session.abort_run({Errc::Unsupported,
                     "waits for a radio message that can never come: no other robot has its radio "
                     "on; other programs are reached by --radio udp:…"});
}

Result<hal::RadioMessage> next_message(Session& session) {
  const Result<hal::Radio*> radio = radio_of(session);
  if (!radio) return tl::unexpected(radio.error());
  const Time since = session.clock().now();
  while (session.may_call("RADIORecv")) {
    {
      const std::lock_guard lock(radio_mutex);
      if (Result<void> come = collect(**radio); !come) return tl::unexpected(come.error());
      if (!received.empty()) {
        hal::RadioMessage first = std::move(received.front());
        received.pop_front();
        return first;
      }
    }
    check_somebody(**radio, session, since);
    robios::classic::wait_until(session.clock().now() + robios::classic::kTick);
  }
  return fail(Errc::Timeout, "the run has ended");
}

}  // namespace

int RADIOInit(void) {
  return doing("RADIOInit", 1, [](Session& session) {
    return radio_of(session).and_then([](hal::Radio* radio) { return radio->start(); });
  });
}

int RADIOTerm(void) {
  return doing("RADIOTerm", 1, [](Session& session) {
    return radio_of(session).and_then([](hal::Radio* radio) {
      const std::lock_guard lock(radio_mutex);
      received.clear();
      return radio->stop();
    });
  });
}

int RADIOSend(BYTE id, int byteCount, const void* buffer) {
  return doing("RADIOSend", 1, [&](Session& session) -> Result<void> {
    if (buffer == nullptr) return robios::null_pointer();
    if (byteCount < 0 || byteCount > MAXMSGLEN) {
      return fail(Errc::OutOfRange,
                  fmt::format("{} bytes, expected 0 … {}", byteCount, MAXMSGLEN));
    }
    const Result<hal::Radio*> radio = radio_of(session);
    if (!radio) return tl::unexpected(radio.error());
    const std::string text(static_cast<const char*>(buffer), static_cast<std::size_t>(byteCount));
    // Nobody hears what is sent to the host; whether the radio is on matters all the same.
    if (id == kHost) return (*radio)->robots().map([](const std::vector<int>&) {});
    return (*radio)->send(id == BROADCAST ? hal::Radio::kEveryone : id, text);
  });
}

int RADIOCheck(void) {
  return call("RADIOCheck", 0, [](Session& session) -> Result<int> {
    return radio_of(session).and_then([](hal::Radio* radio) {
      const std::lock_guard lock(radio_mutex);
      return collect(*radio).map([] { return static_cast<int>(received.size()); });
    });
  });
}

int RADIORecv(BYTE* id, int* bytesReceived, void* buffer) {
  return doing("RADIORecv", 1, [&](Session& session) {
    return next_message(session).map([&](const hal::RadioMessage& message) {
      const std::size_t length = std::min(message.text.size(), std::size_t{MAXMSGLEN});
      if (id != nullptr) *id = static_cast<BYTE>(message.sender);
      if (bytesReceived != nullptr) *bytesReceived = static_cast<int>(length);
      if (buffer != nullptr) std::memcpy(buffer, message.text.data(), length);
    });
  });
}

void RADIOGetIoctl(RadioIOParameters* radioParams) {
  doing("RADIOGetIoctl", 1, [&](Session& session) -> Result<void> {
    if (radioParams == nullptr) return robios::null_pointer();
    const std::lock_guard lock(radio_mutex);
    if (radio_parameters.id == 0) radio_parameters.id = session.backend().robot_id();
    *radioParams = radio_parameters;
    return {};
  });
}

void RADIOSetIoctl(RadioIOParameters* radioParams) {
  doing("RADIOSetIoctl", 1, [&](Session&) -> Result<void> {
    if (radioParams == nullptr) return robios::null_pointer();
    const std::lock_guard lock(radio_mutex);
    radio_parameters = *radioParams;
    return {};
  });
}

int RADIOGetStatus(RadioStatus* status) {
  return doing("RADIOGetStatus", 1, [&](Session& session) -> Result<void> {
    if (status == nullptr) return robios::null_pointer();
    const Result<hal::Radio*> radio = radio_of(session);
    if (!radio) return tl::unexpected(radio.error());
    return (*radio)->robots().map([&](const std::vector<int>& robots) {
      *status = {};
      status->own = (*radio)->id();
      status->master = robots.empty() ? status->own : robots.front();
      status->count = static_cast<int>(robots.size());
      for (const int robot : robots) {
        if (robot >= 0 && robot < 256) status->active[robot] = 1;
      }
    });
  });
}
