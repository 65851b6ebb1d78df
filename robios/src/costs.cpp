#include "costs.hpp"

#include <algorithm>
#include <array>

namespace eyebridge::robios {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

struct Row {
  std::string_view prefix;
  Time cost;
};

// Longest matching prefix wins. One exchange with an IO7 board takes 1 to 3 ms (full-speed USB, one
// frame each way); what stays on the host is the time a Raspberry Pi class computer needs.
constexpr std::array kTable = {
    Row{"ANALOG", microseconds(1500)},  // one exchange
    Row{"ANALOGRecord", microseconds(100)},
    Row{"ANALOGTransfer", microseconds(100)},
    Row{"AU", microseconds(100)},
    Row{"AUMicrophone", microseconds(1500)},
    Row{"CAM", microseconds(200)},          // waiting for the frame comes on top
    Row{"DIGITAL", microseconds(1500)},     //
    Row{"ENCODER", microseconds(1500)},     //
    Row{"IRTV", microseconds(20)},          //
    Row{"IP", milliseconds(2)},             // a QVGA filter
    Row{"IPP", microseconds(1)},            // one pixel
    Row{"KEY", microseconds(100)},          //
    Row{"LCD", microseconds(200)},          // text, lines
    Row{"LCDGet", microseconds(10)},        //
    Row{"LCDImage", milliseconds(4)},       // a QVGA picture to the display
    Row{"LCDImageSize", microseconds(10)},  //
    Row{"LCDImageStart", microseconds(10)},
    Row{"LCDPixel", microseconds(20)},
    Row{"LIDAR", milliseconds(5)},
    Row{"LIDARSet", microseconds(1500)},
    Row{"MOTOR", microseconds(1500)},
    Row{"OS", microseconds(20)},
    Row{"OSVersionIO", microseconds(1500)},
    Row{"PSD", microseconds(1500)},
    Row{"RADIO", microseconds(200)},  // a datagram by Wi-Fi
    Row{"SER", microseconds(100)},
    Row{"SERVO", microseconds(1500)},
    Row{"SIM", microseconds(20)},
    Row{"VW", microseconds(1500)},
};
constexpr Time kOther = microseconds(100);

}  // namespace

Time cost_of(std::string_view call) {
  const Row* best = nullptr;
  for (const Row& row : kTable) {
    if (call.starts_with(row.prefix) &&
        (best == nullptr || row.prefix.size() > best->prefix.size())) {
      best = &row;
    }
  }
  return best != nullptr ? best->cost : kOther;
}

}  // namespace eyebridge::robios
