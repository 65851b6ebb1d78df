#include "can_report.hpp"

#include <linux/can/error.h>

namespace eyebridge::bridges {
namespace {

void note_controller(std::uint8_t status, CanStatistics& statistics) {
  if ((status & (CAN_ERR_CRTL_RX_OVERFLOW | CAN_ERR_CRTL_TX_OVERFLOW)) != 0) ++statistics.dropped;
  if ((status & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0) {
    statistics.state = CanState::Passive;
  } else if ((status & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) != 0) {
    statistics.state = CanState::Warning;
  } else if ((status & CAN_ERR_CRTL_ACTIVE) != 0) {
    statistics.state = CanState::Active;
  }
}

}  // namespace

std::optional<Error> note_report(const CanFrame& report, CanStatistics& statistics,
                                 const std::string& bus) {
  ++statistics.error_frames;
  if ((report.id & CAN_ERR_ACK) != 0) ++statistics.no_ack;
  if ((report.id & CAN_ERR_CRTL) != 0) note_controller(report.data[1], statistics);
  if ((report.id & CAN_ERR_RESTARTED) != 0) statistics.state = CanState::Active;
  if ((report.id & CAN_ERR_BUSOFF) == 0) return std::nullopt;
  ++statistics.bus_off;
  statistics.state = CanState::BusOff;
  return bus_off_error(bus);
}

Error bus_off_error(const std::string& bus) {
  return {Errc::Disconnected,
          bus +
              ": bus off, the controller gave up after too many errors; expected the same bit "
              "rate at all nodes, both terminations, and a restart of the interface"};
}

}  // namespace eyebridge::bridges
