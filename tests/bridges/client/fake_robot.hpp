#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/bridges/can_bus.hpp"

namespace eyebridge::bridges::testing {

/// A frame from its bytes, as the specification writes them.
CanFrame raw_frame(std::uint32_t id, std::initializer_list<int> bytes);
/// "201#2C01D8DC0700"
std::string text_of(const CanFrame& frame);

/// A robot on the bus that does what the specification says, as far as a client notices. Written
/// without the codec under test.
struct FakeRobot {
  FakeRobot(std::unique_ptr<CanBus> its_bus, int its_node, Clock& its_clock)
      : bus(std::move(its_bus)), node(its_node), clock(its_clock) {}

  /// Takes what has come, and sends what is due; to be called every 10 ms.
  void step();
  /// Power off and on.
  void reboot();
  void send(std::uint32_t function, std::initializer_list<int> bytes);
  /// How many frames with this function (upper seven bits) came since the last clear().
  [[nodiscard]] std::size_t count(std::uint32_t function) const;
  /// The last of them as text; "" when there is none.
  [[nodiscard]] std::string last(std::uint32_t function) const;
  void clear() { heard.clear(); }

  std::unique_ptr<CanBus> bus;
  int node;
  Clock& clock;
  int state = 0;        ///< Heartbeat: 0 boot, 5 operational, 0x7F standby.
  Time started{0};      ///< When it booted.
  bool silent = false;  ///< Receives, but sends nothing.
  bool obeys = true;    ///< Echoes moves and takes enables.
  int echoed = 0;       ///< Number of the last move.
  int move_state = 0;   ///< 0 idle, 2 running, 3 done, 4 aborted.
  int x_mm = 0, y_mm = 0, phi_cdeg = 0;
  int psd_mm = 500;
  int capabilities = 1;         ///< 1 moves, 2 scans, 256 zones of the first range matrix.
  std::vector<CanFrame> heard;  ///< What came, oldest first.

 private:
  void obey(const CanFrame& frame);
  void send_cyclic();

  Time next_{0};
  unsigned ticks_ = 0;
};

}  // namespace eyebridge::bridges::testing
