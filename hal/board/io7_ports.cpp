// The letters i, I, o, c, a, V and v of an IO7 board: its ports and itself.
#include <algorithm>
#include <string>

#include "board/io7_link.hpp"
#include "opcodes.h"

namespace eyebridge::hal {
namespace {

namespace io7 = bridges::io7;

constexpr double kCentivolts = 100;

char letter_of(LineMode mode) {
  switch (mode) {
    case LineMode::Input:
      return IO7_PORT_INPUT;
    case LineMode::Output:
      return IO7_PORT_OUTPUT;
    case LineMode::PullUp:
      return IO7_PORT_PULL_UP;
    case LineMode::PullDown:
      return IO7_PORT_PULL_DOWN;
  }
  return IO7_PORT_INPUT;
}

}  // namespace

bool Io7Link::has_digital() const {
  constexpr std::string_view kLetters{"iIoc"};
  return std::ranges::any_of(kLetters, [&](char letter) { return letters_.has(letter); });
}

bool Io7Link::has_analog() const { return letters_.has(IO7_ANALOG) || letters_.has(IO7_VOLTAGE); }

Result<void> Io7Link::digital_setup(int port, LineMode mode) {
  return tell(io7::port_config(port, letter_of(mode)));
}

Result<bool> Io7Link::digital_in(int port) {
  return ask(io7::digital_in(port)).map([](int bit) { return bit != 0; });
}

Result<std::uint16_t> Io7Link::digital_in_all() {
  return ask(io7::request(IO7_DIGITAL_IN_ALL)).map([](int bits) {
    return static_cast<std::uint16_t>(bits);
  });
}

Result<void> Io7Link::digital_out(int port, bool high) {
  return tell(io7::digital_out(port, high));
}

Result<int> Io7Link::analog(int channel) { return ask(io7::analog(channel)); }

Result<double> Io7Link::supply_voltage() {
  return ask(io7::request(IO7_VOLTAGE)).map([](int value) { return value / kCentivolts; });
}

Result<std::string> Io7Link::version() {
  return client_->exchange(io7::request(IO7_VERSION)).map([](const io7::Reply& reply) {
    return std::string(reply.version.data(), reply.version.size());
  });
}

Result<int> Io7Link::remote_key() {
  return fail(Errc::Unsupported, "an IO7 board has no infrared receiver");
}

}  // namespace eyebridge::hal
