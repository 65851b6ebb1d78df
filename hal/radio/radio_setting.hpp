#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {

/// What the setting `radio` says.
struct RadioSetting {
  enum class Medium {
    None,   ///< The robot has no radio.
    World,  ///< The robots of this process's world.
    Udp,    ///< Robots of other processes, by multicast.
  };

  Medium medium = Medium::World;
  std::string group;                    ///< Udp: a multicast address, "239.192.7.1".
  std::uint16_t port = 0;               ///< Udp.
  std::string interface = "127.0.0.1";  ///< Udp: the address of the interface to use.
  std::optional<int> id;                ///< Of this robot; none: its number in its world.
  std::optional<double> loss;           ///< Share of the messages that get lost, 0 … 1; else as
  std::optional<Time> delay;            ///< the robot's model says. On the robot's clock.
  std::optional<Time> jitter;           ///< Up to so much more delay.
  std::optional<double> corrupt;        ///< Share of the messages with a flipped bit, 0 … 1.
  std::optional<double> range;          ///< World: metres, >= 0; 0 is no limit.

  friend bool operator==(const RadioSetting&, const RadioSetting&) = default;
};

/// Reads "world", "none" or "udp:239.192.7.1:7007?interface=127.0.0.1", each but none with the
/// options id (1 … 255), loss (a share as 10%) and delay (as 20ms, at most an hour). Throws
/// ConfigError at `where`.
RadioSetting parse_radio(std::string_view text, const SourceLocation& where);

}  // namespace eyebridge::hal
