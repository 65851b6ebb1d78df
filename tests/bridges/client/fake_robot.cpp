#include "fake_robot.hpp"

#include <cstdio>

namespace eyebridge::bridges::testing {
namespace {

using namespace std::chrono_literals;

int word(const CanFrame& frame, std::size_t at) {
  return static_cast<std::int16_t>(frame.data[at] | frame.data[at + 1] << 8);
}
int low(int value) { return value & 0xFF; }
int high(int value) { return (value >> 8) & 0xFF; }

}  // namespace

CanFrame raw_frame(std::uint32_t id, std::initializer_list<int> bytes) {
  CanFrame frame;
  frame.id = id;
  for (const int byte : bytes) frame.data[frame.length++] = static_cast<std::uint8_t>(byte);
  return frame;
}

std::string text_of(const CanFrame& frame) {
  char text[8];
  std::snprintf(text, sizeof text, "%03X#", static_cast<unsigned>(frame.id));
  std::string out = text;
  for (const std::uint8_t byte : frame.bytes()) {
    std::snprintf(text, sizeof text, "%02X", static_cast<unsigned>(byte));
    out += text;
  }
  return out;
}

void FakeRobot::send(std::uint32_t function, std::initializer_list<int> bytes) {
  if (silent) return;
  (void)bus->send(raw_frame(function << 4U | static_cast<std::uint32_t>(node), bytes), Time{0});
}

std::size_t FakeRobot::count(std::uint32_t function) const {
  std::size_t found = 0;
  for (const CanFrame& frame : heard) found += frame.id >> 4U == function ? 1 : 0;
  return found;
}

std::string FakeRobot::last(std::uint32_t function) const {
  for (auto frame = heard.rbegin(); frame != heard.rend(); ++frame) {
    if (frame->id >> 4U == function) return text_of(*frame);
  }
  return "";
}

void FakeRobot::reboot() {
  state = 0;
  started = clock.now();
  echoed = 0;
  move_state = 0;
  x_mm = y_mm = phi_cdeg = 0;
}

void FakeRobot::step() {
  while (true) {
    const auto frame = bus->receive(Time{0});
    if (!frame) break;
    heard.push_back(*frame);
    obey(*frame);
  }
  for (; next_ <= clock.now(); next_ += 10ms) send_cyclic();
}

void FakeRobot::obey(const CanFrame& frame) {
  const bool mine = (frame.id & 0xFU) == static_cast<std::uint32_t>(node);
  if (!obeys) return;
  if (frame.id == 0x000 && (frame.data[1] == 0 || frame.data[1] == node)) {
    if (frame.data[0] == 1) state = 5;
    if (frame.data[0] == 0x80) state = 0x7F;
  }
  if (!mine) return;
  switch (frame.id >> 4U) {
    case 0x01:
      state = 4;
      break;
    case 0x48:
      if (frame.remote)
        send(0x48, {1, '1', '.', '0', '4', 1, capabilities & 0xFF, capabilities >> 8});
      break;
    case 0x21:
      if (frame.data[1] != echoed) move_state = 2;
      echoed = frame.data[1];
      break;
    case 0x22:
      x_mm = word(frame, 0);
      y_mm = word(frame, 3);
      phi_cdeg = word(frame, 6);
      break;
    default:
      break;
  }
}

void FakeRobot::send_cyclic() {
  const int uptime = static_cast<int>((clock.now() - started) / 100ms);
  const auto every = [this](unsigned ticks) { return ticks_ % ticks == 0; };
  if (every(2)) {
    send(0x18, {low(x_mm), high(x_mm), x_mm < 0 ? 0xFF : 0, low(y_mm), high(y_mm),
                y_mm < 0 ? 0xFF : 0, low(phi_cdeg), high(phi_cdeg)});
    send(0x19, {0x2C, 0x01, 0, 0, move_state | (state == 5 ? 0x40 : 0), echoed, 0x10, 0});
    send(0x1A, {1, 0, 0, 0, 2, 0, 0, 0});
  }
  if (every(5)) {
    send(0x1C, {low(psd_mm), high(psd_mm), 0x0F, 0x27, 0xFF, 0xFF, 0xFF, 0xFF});
    send(0x1D, {0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF});
    send(0x1E, {0, 2, 0, 1, 0xFF, 0xFF, 0xFF, 0xFF});
    send(0x1F, {0, 0, 0, 0, 0, 0xFF});
  }
  if (every(10)) {
    send(0x1B, {0, 0, 0, 0, 0, 0, 0, 0});
    send(0x28, {0, 0, 0, 0, 0, 0, 0, 0});
    send(0x29, {0, 0, 0, 0, 0, 0, 0, 0});
    send(0x2A, {0xE4, 2, 0, 0, 0, low(uptime), high(uptime), 0});
    send(0x70, {state});
  }
  ++ticks_;
}

}  // namespace eyebridge::bridges::testing
