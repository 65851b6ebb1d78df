#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::robios {

/// What calls whose names begin so take on a real robot.
struct CallCost {
  std::string_view prefix;
  Time cost;
};

// Longest matching prefix wins. One exchange with an IO7 board takes 1 to 3 ms (full-speed USB, one
// frame each way); what stays on the host is the time a Raspberry Pi class computer needs.
inline constexpr std::array kCallCosts = {
    CallCost{"ANALOG", std::chrono::microseconds(1500)},  // one exchange
    CallCost{"ANALOGRecord", std::chrono::microseconds(100)},
    CallCost{"ANALOGTransfer", std::chrono::microseconds(100)},
    CallCost{"AU", std::chrono::microseconds(100)},
    CallCost{"AUMicrophone", std::chrono::microseconds(1500)},
    CallCost{"CAM", std::chrono::microseconds(200)},       // waiting for the frame comes on top
    CallCost{"DIGITAL", std::chrono::microseconds(1500)},  //
    CallCost{"ENCODER", std::chrono::microseconds(1500)},  //
    CallCost{"EYEBRIDGEAccelerometer", std::chrono::microseconds(1500)},  // as other sensors
    CallCost{"EYEBRIDGEGyroscope", std::chrono::microseconds(1500)},      //
    CallCost{"EYEBRIDGERangeMatrix", std::chrono::milliseconds(2)},       // its 128 bytes
    CallCost{"IRTV", std::chrono::microseconds(20)},                      //
    CallCost{"IP", std::chrono::milliseconds(2)},                         // a QVGA filter
    CallCost{"IPP", std::chrono::microseconds(1)},                        // one pixel
    CallCost{"KEY", std::chrono::microseconds(100)},                      //
    CallCost{"LCD", std::chrono::microseconds(200)},                      // text, lines
    CallCost{"LCDGet", std::chrono::microseconds(10)},                    //
    CallCost{"LCDImage", std::chrono::milliseconds(4)},       // a QVGA picture to the display
    CallCost{"LCDImageSize", std::chrono::microseconds(10)},  //
    CallCost{"LCDImageStart", std::chrono::microseconds(10)},
    CallCost{"LCDPixel", std::chrono::microseconds(20)},
    CallCost{"LIDAR", std::chrono::milliseconds(5)},
    CallCost{"LIDARSet", std::chrono::microseconds(1500)},
    CallCost{"MOTOR", std::chrono::microseconds(1500)},
    CallCost{"OS", std::chrono::microseconds(20)},
    CallCost{"OSVersionIO", std::chrono::microseconds(1500)},
    CallCost{"PSD", std::chrono::microseconds(1500)},
    CallCost{"RADIO", std::chrono::microseconds(200)},  // a datagram by Wi-Fi
    CallCost{"SER", std::chrono::microseconds(100)},
    CallCost{"SERVO", std::chrono::microseconds(1500)},
    CallCost{"SIM", std::chrono::microseconds(20)},
    CallCost{"VW", std::chrono::microseconds(1500)},
};
/// A look at the C library's clocks.
inline constexpr Time kLookCost = std::chrono::microseconds(1);
inline constexpr Time kOtherCallCost = std::chrono::microseconds(100);

/// How long the call named `call` takes on a real robot, for virtual clocks.
constexpr Time cost_of(std::string_view call) {
  // By values: g++ 12 with UBSan does not take comparisons of pointers for constants.
  Time cost = kOtherCallCost;
  std::size_t longest = 0;
  for (const CallCost& row : kCallCosts) {
    if (row.prefix.size() <= longest || !call.starts_with(row.prefix)) continue;
    longest = row.prefix.size();
    cost = row.cost;
  }
  return cost;
}

/// A call of the API by its name, which is a literal: what it costs is known when it is compiled.
struct Call {
  std::string_view name;
  Time cost;

  template <std::size_t Size>
  consteval Call(
      const char (&literal)[Size])  // NOLINT(google-explicit-constructor): names are calls
      : name(literal, Size - 1), cost(cost_of(name)) {}
};

}  // namespace eyebridge::robios
