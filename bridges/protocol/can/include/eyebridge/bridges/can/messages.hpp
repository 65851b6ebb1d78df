#pragma once

#include <variant>

#include "eyebridge/base/result.hpp"
#include "eyebridge/bridges/can/codec.hpp"
#include "eyebridge/bridges/can/command_messages.hpp"
#include "eyebridge/bridges/can/identifier.hpp"
#include "eyebridge/bridges/can/status_messages.hpp"

namespace eyebridge::bridges::can {

/// Any message of the protocol, in the order of the table.
using AnyMessage =
    std::variant<NmtCommand, EmergencyStop, FaultStatus, PoseStatus, SpeedStatus, Encoder12Status,
                 Encoder34Status, PsdAStatus, PsdBStatus, PsdRawStatus, DigitalStatus, SpeedCommand,
                 MoveCommand, PoseCommand, MotorCommand, PidCommand, ServoCommand, DigitalCommand,
                 PortCommand, AnalogAStatus, AnalogBStatus, BoardStatus, LidarHeader, LidarChunk,
                 LidarChunkFd, ZoneChunk, VersionStatus, Heartbeat>;

/// A message, and which robot it is to or from.
struct Received {
  int node = 0;
  AnyMessage message;

  friend bool operator==(const Received&, const Received&) = default;
};

/// Unpacks whatever frame of the protocol this is. Fails with Unsupported when its identifier is
/// none of ours (other devices may share the bus), with Corrupt when it is one of ours but cannot
/// be right.
Result<Received> decode_any(const CanFrame& frame);

/// Packs any message; fails as encode_raw does.
Result<CanFrame> encode_any(const Received& message);

}  // namespace eyebridge::bridges::can
