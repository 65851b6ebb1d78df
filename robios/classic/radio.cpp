#include <algorithm>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "call.hpp"
#include "eyebot.h"
#include "radio_messages.hpp"

namespace {

using namespace eyebridge;
using robios::radio_of;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

constexpr int kHost = 0;

struct Ioctl {
  std::mutex mutex;
  RadioIOParameters parameters{SERIAL2, SER9600, 0, 0, 0, 0};
};

}  // namespace

int RADIOInit(void) {
  return doing("RADIOInit", 1, [](Session& session) {
    return radio_of(session).and_then([](hal::Radio* radio) { return radio->start(); });
  });
}

int RADIOTerm(void) {
  return doing("RADIOTerm", 1, [](Session& session) {
    return radio_of(session).and_then([&](hal::Radio* radio) {
      session.messages().clear();
      return radio->stop();
    });
  });
}

int RADIOSend(BYTE id, int byteCount, const void* buffer) {
  return doing("RADIOSend", 1, [&](Session& session) -> Result<void> {
    if (buffer == nullptr) return robios::null_pointer();
    if (byteCount < 0 || byteCount > MAXMSGLEN) {
      return fail(Errc::OutOfRange, fmt::format("{} bytes, expected 0 … {}", byteCount, MAXMSGLEN));
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
    return radio_of(session)
        .and_then([&](hal::Radio* radio) { return session.messages().count(*radio); })
        .map([](std::size_t count) { return static_cast<int>(count); });
  });
}

int RADIORecv(BYTE* id, int* bytesReceived, void* buffer) {
  return doing("RADIORecv", 1, [&](Session& session) -> Result<void> {
    const Result<hal::Radio*> radio = radio_of(session);
    if (!radio) return tl::unexpected(radio.error());
    const auto next =
        robios::wait_for_message(session, **radio, "RADIORecv", robios::classic::wait_until);
    return next.map([&](const hal::RadioMessage& message) {
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
    auto& ioctl = session.own<Ioctl>();
    const std::lock_guard lock(ioctl.mutex);
    if (ioctl.parameters.id == 0) ioctl.parameters.id = session.backend().robot_id();
    *radioParams = ioctl.parameters;
    return {};
  });
}

void RADIOSetIoctl(RadioIOParameters* radioParams) {
  doing("RADIOSetIoctl", 1, [&](Session& session) -> Result<void> {
    if (radioParams == nullptr) return robios::null_pointer();
    auto& ioctl = session.own<Ioctl>();
    const std::lock_guard lock(ioctl.mutex);
    ioctl.parameters = *radioParams;
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
