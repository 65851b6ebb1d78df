#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "eyebot.h"
#include "guarded.hpp"
#include "radio_messages.hpp"

namespace {

using namespace eyebridge;
using robios::Session;

template <class Body>
int with_radio(const robios::Call& call, int failure, Body&& body) {
  return robios::guarded(call, failure, [&](Session& session) -> Result<int> {
    return robios::radio_of(session).and_then(
        [&](hal::Radio* radio) -> Result<int> { return body(*radio, session); });
  });
}

}  // namespace

int RADIOInit(void) {
  return with_radio("RADIOInit", 1, [](hal::Radio& radio, Session&) -> Result<int> {
    return radio.start().map([] { return 0; });
  });
}

int RADIOGetID(void) {
  return with_radio("RADIOGetID", 0,
                    [](hal::Radio& radio, Session&) -> Result<int> { return radio.id(); });
}

int RADIOSend(int id, const char* buf) {
  return with_radio("RADIOSend", 1, [&](hal::Radio& radio, Session&) -> Result<int> {
    if (buf == nullptr) return robios::null_pointer();
    if (id == hal::Radio::kEveryone) {
      return fail(Errc::OutOfRange, fmt::format("robot {}, expected 1..255", id));
    }
    return radio.send(id, buf).map([] { return 0; });
  });
}

int RADIOReceive(int* id_no, char* buf, int size) {
  return with_radio("RADIOReceive", -1, [&](hal::Radio& radio, Session& session) -> Result<int> {
    if (buf == nullptr) return robios::null_pointer();
    if (size < 1) return fail(Errc::OutOfRange, fmt::format("size {}, expected at least 1", size));
    const auto wait_until = [&](Time until) { session.wait_until(until); };
    return robios::wait_for_message(session, radio, "RADIOReceive", wait_until)
        .map([&](const hal::RadioMessage& message) {
          const std::size_t length =
              std::min(message.text.size(), static_cast<std::size_t>(size) - 1);
          std::memcpy(buf, message.text.data(), length);
          buf[length] = '\0';
          if (id_no != nullptr) *id_no = message.sender;
          return static_cast<int>(length);
        });
  });
}

int RADIOCheck(void) { return EYEBRIDGERadioCheck(nullptr); }

int EYEBRIDGERadioCheck(int* id_no) {
  return with_radio("RADIOCheck", -1, [&](hal::Radio& radio, Session& session) -> Result<int> {
    return session.messages().first_sender(radio).map([&](std::optional<int> sender) {
      if (sender && id_no != nullptr) *id_no = *sender;
      return sender ? 1 : 0;
    });
  });
}

int RADIOStatus(int IDlist[]) {
  return with_radio("RADIOStatus", 0, [&](hal::Radio& radio, Session&) -> Result<int> {
    if (IDlist == nullptr) return robios::null_pointer();
    return radio.robots().map([&](const std::vector<int>& ids) {
      std::copy(ids.begin(), ids.end(), IDlist);
      return static_cast<int>(ids.size());
    });
  });
}

int RADIORelease(void) {
  return with_radio("RADIORelease", 1, [](hal::Radio& radio, Session& session) -> Result<int> {
    session.messages().clear();
    return radio.stop().map([] { return 0; });
  });
}
